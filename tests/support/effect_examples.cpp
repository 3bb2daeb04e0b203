#include "support/effect_examples.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "addons/files/scene_file.hpp"
#include "support/cantilever.hpp"

namespace signorini_test {

using namespace signorini;
namespace fs = std::filesystem;

namespace {

const char* const folders[] = {"signorini/scene", "addons/effects", "addons/equations", "addons/motion", "addons/steps"};

/// What stands behind a mark at the beginning of a line.
bool marked(const std::string& line, const std::string& mark, std::string& rest) {
  if (line.rfind(mark, 0) != 0) return false;
  rest = line.substr(mark.size());
  return true;
}

std::set<std::string> words(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

EffectExample read_example(const fs::path& file) {
  EffectExample example;
  const std::string mark = "# with";
  std::string with, without, rest;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line); with += line + '\n') {
    if (marked(line, "# changes: ", rest)) example.touched.merge(words(rest));
    if (marked(line, "# adds: ", rest)) example.own = words(rest);
    if (marked(line, "# without: ", rest))
      without += rest + '\n';
    else if (line.size() < mark.size() || line.substr(line.size() - mark.size()) != mark)
      without += line + '\n';
  }
  example.touched.insert(example.own.begin(), example.own.end());
  const auto scene = [&file](const std::string& text) {
    return parse_scene(text, file.filename().string(), file.parent_path()).scene;
  };
  example.without = scene(without);
  example.with = scene(with);
  return example;
}

}  // namespace

Scene plain_beam() {
  Scene scene = cantilever("q4_incompatible", 12, 2);
  scene.bodies[0].loads = {};
  return scene;
}

const std::map<std::string, EffectExample>& effect_examples() {
  static const std::map<std::string, EffectExample> all = [] {
    std::map<std::string, EffectExample> read;
    for (const char* const folder : folders)
      for (const auto& file : fs::directory_iterator(fs::path(SIGNORINI_SOURCES) / folder)) {
        std::string name = file.path().stem().string();
        std::replace(name.begin(), name.end(), '_', ' ');
        if (file.path().extension() == ".toml") read.emplace(name, read_example(file.path()));
      }
    return read;
  }();
  return all;
}

}  // namespace signorini_test
