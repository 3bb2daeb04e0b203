// Scene files with one mistake each: the first line of a file lists what the message must say.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>

#include "addons/files/scene_file.hpp"
#include "addons/steps/steps.hpp"
#include "addons/text/text_reader.hpp"
#include "catch_compat.hpp"
#include "fuzz/check_scene.hpp"
#include "support/message.hpp"
#include "support/random.hpp"

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

std::size_t below(Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.whole(0, static_cast<int>(count) - 1));
}

/// A text with a line left out or repeated, a number that is another or none, or a letter that is another.
std::string changed(std::string text, Random& random) {
  const auto is_in = [](const char* letters) {
    return [=](char c) { return std::string_view(letters).find(c) != std::string_view::npos; };
  };
  const auto from = text.begin() + static_cast<std::ptrdiff_t>(below(random, text.size()));
  const std::size_t begin = text.rfind('\n', static_cast<std::size_t>(from - text.begin())) + 1;
  const std::size_t line = std::min(text.find('\n', begin), text.size() - 1) + 1 - begin;
  const char* const digits = "+-.0123456789";
  const auto number = std::find_if(from, text.end(), is_in(digits));
  const auto behind = std::find_if_not(number, text.end(), is_in(digits));
  const char* const odd[] = {"nan", "inf",  "-inf",    "-1", "0",  "1e300", "1e-300",
                             "0.5", "\"\"", "\"top\"", "[]", "{}", "true",  "[0, 1]"};
  switch (random.whole(0, 5)) {
    case 0:
      text.erase(begin, line);
      break;
    case 1:
      text.insert(begin, text.substr(begin, line));
      break;
    case 2:
      *from = "aetx_.[]=\"\n 1"[below(random, 13)];
      break;
    default:
      text.replace(number, behind, odd[below(random, std::size(odd))]);
  }
  return text;
}

/// What is wrong with how a text ends that was planned, or empty. It may be unsolved, but must say so.
std::string solved_or_refused(const std::string& content) {
  try {
    const SceneFile file = parse_scene(content, "name", "/nowhere");
    if (file.scene.path) {
      const PathEnd end = solve_steps(file.scene);
      return end.status == SolveStatus::Solved || !end.reason.empty() ? ""
                                                                      : "an end without a reason";
    }
    const Solution solution = solve(file.scene);
    const bool right = solution.certificate.holds();
    return solution.contact.report.status != SolveStatus::Solved || right ? "" : "solved and wrong";
  } catch (const ProblemError& error) {
    return std::string(error.what()).empty() ? "no message" : "";
  }
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

TEST_CASE("scene files changed at random are solved, or refused with file and line",
          "[scene_file][random]") {
  int solved = 0;
  int refused = 0;
  for (const char* name : {"cantilever", "every_effect", "lining", "load_steps", "punch"}) {
    const std::string whole = file_content(data / "fuzz_corpus_scene" / name, 100000);
    for (unsigned seed = 0; seed < 400; ++seed) {
      Random random(seed);
      std::string text = changed(whole, random);
      for (int more = random.whole(0, 2); more > 0; --more) text = changed(text, random);
      CAPTURE(name, seed, text);
      const std::string wrong = signorini_test::check_scene(text);
      CHECK(wrong == "");
      CHECK(solved_or_refused(text) == "");
      const bool planned = problem_message([&] {
                             static_cast<void>(plan(parse_scene(text, "name", "").scene));
                           }).empty();
      ++(planned ? solved : refused);
    }
  }
  CHECK(solved >= 100);
  CHECK(refused >= 1000);
}
