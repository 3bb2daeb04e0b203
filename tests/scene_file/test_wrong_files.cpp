// Scene files with one mistake each: the first line of a file lists what the message must say.
#include <filesystem>
#include <set>
#include <sstream>

#include "catch_compat.hpp"
#include "fuzz/check_scene.hpp"
#include "signorini/core/text_reader.hpp"
#include "signorini/scene_file/scene_file.hpp"
#include "support/message.hpp"

using namespace signorini;
using signorini_test::problem_message;

namespace {

const std::filesystem::path data = SIGNORINI_TEST_DATA;

std::set<std::filesystem::path> files_of(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator all(folder), end;
  return {all, end};
}

/// What reading, planning and assembling say.
std::string complaint(const std::filesystem::path& path) {
  return problem_message([&] {
    const SceneFile file = read_scene(path);
    at_file(file, [&] {
      Ledger ledger;
      const Model model = build(file.scene, ledger);
      static_cast<void>(condense(model, ledger));
    });
  });
}

/// The parts of "# part | part | ...".
std::vector<std::string> wanted(const std::string& content) {
  std::vector<std::string> parts;
  const std::string line = content.substr(2, content.find('\n') - 2);
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(" | ", at), line.size());
    parts.push_back(line.substr(at, end - at));
    at = end + 3;
  }
  return parts;
}

}  // namespace

TEST_CASE("every wrong scene file is refused with file, line, thing and way out", "[scene_file]") {
  const std::set<std::filesystem::path> files = files_of(data / "scenes" / "wrong");
  CHECK(files.size() >= 40);
  for (const std::filesystem::path& path : files) {
    const std::string said = complaint(path);
    CAPTURE(path.filename().string(), said);
    CHECK(said.rfind(path.string() + ":", 0) == 0);
    CHECK(said.find('\n') == std::string::npos);
    CHECK(said.size() < path.string().size() * 2 + 600);
    const std::vector<std::string> parts = wanted(file_content(path, 10000));
    CHECK(parts.size() >= 2);
    for (const std::string& part : parts) {
      CAPTURE(part);
      CHECK(said.find(part) != std::string::npos);
    }
  }
}

TEST_CASE("texts of the fuzzer are scenes or refused", "[scene_file]") {
  std::size_t count = 0;
  for (const std::filesystem::path& path : files_of(data / "fuzz_corpus_scene")) {
    CAPTURE(path.filename().string());
    CHECK(signorini_test::check_scene(file_content(path, 100000)).empty());
    ++count;
  }
  CHECK(count > 0);
}
