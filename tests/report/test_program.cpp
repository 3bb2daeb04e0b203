#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <utility>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/report/program.hpp"
#include "support/folder.hpp"

using namespace signorini;
using signorini_test::content_of;
using signorini_test::Folder;

namespace {

/// Catches what goes to a stream as long as it lives.
class Caught {
 public:
  explicit Caught(std::ostream& stream) : stream_(stream), before_(stream.rdbuf(text_.rdbuf())) {}
  ~Caught() { stream_.rdbuf(before_); }
  Caught(const Caught&) = delete;
  Caught& operator=(const Caught&) = delete;
  Caught(Caught&&) = delete;
  Caught& operator=(Caught&&) = delete;
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::ostream& stream_;
  std::streambuf* before_;
};

struct Run {
  int code;
  std::string output;
  std::string errors;
};

Run run(const std::filesystem::path& folder, std::vector<const char*> arguments,
        const std::function<SolveStatus(const ProgramOptions&)>& body) {
  arguments.insert(arguments.begin(), "ch00");
  const Caught output(std::cout);
  const Caught errors(std::cerr);
  const int code = run_program("ch00", "A title", folder, static_cast<int>(arguments.size()),
                               arguments.data(), body);
  return {code, output.text(), errors.text()};
}

SolveStatus well(const ProgramOptions& /*options*/) { return SolveStatus::Solved; }

}  // namespace

TEST_CASE("a program that solved its problem ends with 0 and no complaint", "[program]") {
  const Folder folder;
  const Run done = run(folder.path() / "out", {}, well);
  CHECK(done.code == 0);
  CHECK(done.errors.empty());
  CHECK(std::filesystem::is_directory(folder.path() / "out"));
}

TEST_CASE("options reach the program and what it writes reaches the folder", "[program]") {
  const Folder folder;
  const std::string other = (folder.path() / "other").string();
  bool full = true;
  const auto body = [&](const ProgramOptions& options) {
    full = options.full;
    std::ofstream(options.out / "data.csv") << "x\n";
    return SolveStatus::Solved;
  };
  CHECK(run(folder.path() / "out", {}, body).code == 0);
  CHECK(content_of(folder.path() / "out" / "data.csv") == "x\n");
  CHECK_FALSE(full);
  CHECK(run(folder.path() / "out", {"--out", other.c_str(), "--full"}, body).code == 0);
  CHECK(content_of(folder.path() / "other" / "data.csv") == "x\n");
  CHECK(full);
}

TEST_CASE("a program that fails leaves the folder as it was", "[program]") {
  const Folder folder;
  std::ofstream(folder.path() / "data.csv") << "old";
  const auto write_then = [&](const std::function<SolveStatus()>& end) {
    return run(folder.path(), {},
               [&](const ProgramOptions& options) {
                 std::ofstream(options.out / "data.csv") << "half";
                 std::ofstream(options.out / "more.csv") << "half";
                 return end();
               })
        .code;
  };
  CHECK(write_then([] { return SolveStatus::Breakdown; }) == 1);
  CHECK(write_then([]() -> SolveStatus { throw NotSolved("no"); }) == 1);
  CHECK(write_then([]() -> SolveStatus { throw ProblemError("bad"); }) == 2);
  CHECK(content_of(folder.path() / "data.csv") == "old");
  CHECK(folder.entries() == 1);
  CHECK(write_then([] { return SolveStatus::Solved; }) == 0);
  CHECK(content_of(folder.path() / "data.csv") == "half");
  CHECK(folder.entries() == 2);
}

TEST_CASE("an error that nobody foresaw ends with 1 and its message", "[program]") {
  const Folder folder;
  const Run odd = run(folder.path(), {}, [](const ProgramOptions&) -> SolveStatus {
    throw std::runtime_error("out of luck");
  });
  CHECK(odd.code == 1);
  CHECK_THAT(odd.errors, ContainsSubstring("ch00: ") && ContainsSubstring("out of luck"));
}

TEST_CASE("a program that did not solve its problem ends with 1 and says how it ended",
          "[program]") {
  const Folder folder;
  const Run limit =
      run(folder.path(), {}, [](const ProgramOptions&) { return SolveStatus::IterationLimit; });
  CHECK(limit.code == 1);
  CHECK(limit.errors == "ch00: not solved: iteration limit\n");
  const Run thrown = run(folder.path(), {}, [](const ProgramOptions&) -> SolveStatus {
    throw NotSolved("the beam was not solved");
  });
  CHECK(thrown.code == 1);
  CHECK(thrown.errors == "ch00: the beam was not solved\n");
}

TEST_CASE("bad input ends with 2 and one line that says what is wrong", "[program]") {
  const Folder folder;
  const Run posed = run(folder.path(), {}, [](const ProgramOptions&) -> SolveStatus {
    throw ProblemError("cell 7 is inverted");
  });
  CHECK(posed.code == 2);
  CHECK(posed.errors == "ch00: cell 7 is inverted\n");
  const Run argument = run(folder.path(), {}, [](const ProgramOptions&) -> SolveStatus {
    throw std::invalid_argument("need 2 rows");
  });
  CHECK(argument.code == 2);
  CHECK(argument.errors == "ch00: need 2 rows\n");
}

TEST_CASE("an unknown option is named and the known ones are listed", "[program]") {
  const Folder folder;
  bool called = false;
  const Run wrong = run(folder.path(), {"--fast"}, [&](const ProgramOptions&) {
    called = true;
    return SolveStatus::Solved;
  });
  CHECK(wrong.code == 2);
  CHECK_FALSE(called);
  CHECK_THAT(wrong.errors, ContainsSubstring("--fast") && ContainsSubstring("--out FOLDER"));
  CHECK(run(folder.path(), {"--out"}, well).code == 2);  // its value is missing
  CHECK(run(folder.path(), {"word"}, well).code == 2);
}

TEST_CASE("a folder that cannot be written to ends with 2 before anything is computed",
          "[program]") {
  const Folder folder;
  std::ofstream(folder.path() / "a_file") << "in the way";
  const std::string below = (folder.path() / "a_file" / "out").string();
  bool called = false;
  const Run wrong = run(folder.path(), {"--out", below.c_str()}, [&](const ProgramOptions&) {
    called = true;
    return SolveStatus::Solved;
  });
  CHECK(wrong.code == 2);
  CHECK_FALSE(called);
  CHECK_THAT(wrong.errors, ContainsSubstring("a_file") && ContainsSubstring("--out FOLDER"));
}

TEST_CASE("help is no error and makes no folder", "[program]") {
  const Folder folder;
  const Run help = run(folder.path() / "out", {"--help"}, well);
  CHECK(help.code == 0);
  CHECK_THAT(help.output, ContainsSubstring("A title") && ContainsSubstring("--full"));
  CHECK(folder.entries() == 0);
}

namespace {

/// A terminal that takes `room` characters, and says so only when the rest is sent on.
class Full : public std::streambuf {
 public:
  explicit Full(int room) : room_(room) {}

 protected:
  int_type overflow(int_type c) override {
    --room_;
    return traits_type::not_eof(c);
  }
  int sync() override { return room_ < 0 ? -1 : 0; }

 private:
  int room_;
};

/// How a program ends that prints 10 characters where there is room for `room`.
Run run_printing(const std::filesystem::path& folder, int room,
                 const std::vector<const char*>& arguments, SolveStatus status) {
  Full full(room);
  std::streambuf* const before = std::cout.rdbuf(&full);
  const Caught errors(std::cerr);
  std::vector<const char*> all = {"ch00"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const int code = run_program("ch00", "A title", folder, static_cast<int>(all.size()), all.data(),
                               [&](const ProgramOptions& options) {
                                 std::ofstream(options.out / "data.csv") << "x\n";
                                 std::cout << "0123456789";
                                 return status;
                               });
  std::cout.clear();
  std::cout.rdbuf(before);
  return {code, "", errors.text()};
}

}  // namespace

TEST_CASE("a program whose output is lost ends with 2, says so and publishes no file",
          "[program]") {
  const Folder folder;
  const Run lost = run_printing(folder.path(), 9, {}, SolveStatus::Solved);
  CHECK(lost.code == 2);
  CHECK_THAT(lost.errors, ContainsSubstring("ch00: cannot write all that is to be printed"));
  CHECK(folder.entries() == 0);
  CHECK(run_printing(folder.path(), 9, {}, SolveStatus::Ray).code == 2);
  CHECK(run_printing(folder.path(), 9, {"--help"}, SolveStatus::Solved).code == 2);
  CHECK(folder.entries() == 0);
  CHECK(run_printing(folder.path(), 10, {}, SolveStatus::Solved).code == 0);
  CHECK(folder.entries() == 1);
}

TEST_CASE("a file that cannot be put in its place ends with 2 and is named", "[program]") {
  const Folder folder;
  std::filesystem::create_directories(folder.path() / "data.csv" / "below");
  const Run blocked = run_printing(folder.path(), 10, {}, SolveStatus::Solved);
  CHECK(blocked.code == 2);
  CHECK_THAT(blocked.errors, ContainsSubstring("ch00: cannot write") &&
                                 ContainsSubstring("data.csv") && ContainsSubstring("--out"));
}

namespace {

std::string ran;
int well_called(int argc, char** argv) {
  ran += "well";
  for (int k = 1; k < argc; ++k) ran += std::string(" ") + argv[k];
  ran += ';';
  return 0;
}
int ill_called(int /*argc*/, char** /*argv*/) {
  ran += "ill;";
  return 1;
}

int printing(int argc, char** argv) {
  return run_program("ch00", "A title", "out", argc, argv, well);
}

/// What is run, and the exit code, for some words behind the name of the program.
std::pair<std::string, int> run_words(std::vector<const char*> words,
                                      const std::vector<ChapterProgram>& programs = {
                                          {"one", well_called},
                                          {"two", well_called, "two.results two.csv"},
                                          {"three", ill_called},
                                          {"four", well_called}}) {
  words.insert(words.begin(), "ch00");
  ran.clear();
  const int code = run_programs("ch00", programs, static_cast<int>(words.size()), words.data());
  return {ran, code};
}

using Ran = std::pair<std::string, int>;

}  // namespace

TEST_CASE("the programs of a chapter run in order until one fails, or one alone", "[program]") {
  const Caught output(std::cout);
  const Caught errors(std::cerr);
  CHECK(run_words({}) == Ran{"well;well;ill;", 1});
  CHECK(run_words({"--out", "x"}) == Ran{"well --out x;well --out x;ill;", 1});
  CHECK(run_words({"four", "--full"}) == Ran{"well --full;", 0});
  CHECK(run_words({"--full", "--out", "four", "four"}) == Ran{"well --out four --full;", 0});
  CHECK(run_words({"two"}) == Ran{"well;", 0});
  CHECK(output.text().empty());
  CHECK(errors.text().empty());
}

TEST_CASE("what takes long is left out on request, and the files that it would write are named",
          "[program]") {
  const Caught output(std::cout);
  CHECK(run_words({"--quick", "--full"}) == Ran{"well --full;ill;", 1});
  CHECK(output.text() == "ch00: two takes longer than 5 s and is left out: two.results two.csv\n");
  CHECK(run_words({"four", "--quick"}) == Ran{"well;", 0});
  CHECK(run_words({"--quick", "two"}) == Ran{"", 0});
}

TEST_CASE("help is that of the chapter, or of the program that is named", "[program]") {
  for (const char* asked : {"--help", "-h"}) {
    const Caught output(std::cout);
    CHECK(run_words({asked}) == Ran{"well --help;", 0});
    CHECK(run_words({"--quick", asked}) == Ran{"well --help;", 0});
    CHECK_THAT(output.text(), ContainsSubstring("one, two, three, four"));
  }
  const Caught output(std::cout);
  CHECK(run_words({"--help", "two"}) == Ran{"well --help;", 0});
  CHECK(run_words({"two", "--quick", "--help"}) == Ran{"well --help;", 0});
  CHECK(output.text().empty());
}

TEST_CASE("a word that is no program of the chapter, and no option, is refused wherever it stands",
          "[program]") {
  for (const std::vector<const char*>& words :
       {std::vector<const char*>{"fuor"}, {"--quick", "fuor"}, {"--help", "fuor"}}) {
    const Caught errors(std::cerr);
    CHECK(run_words(words) == Ran{"", 2});
    CHECK(errors.text() ==
          "ch00: no program 'fuor'; did you mean 'four'? There are: one, two, three, four\n");
  }
  for (const std::vector<const char*>& words :
       {std::vector<const char*>{"--out"}, {"--out", "--help"}, {"one", "--out", "-h"}}) {
    const Caught errors(std::cerr);
    CHECK(run_words(words) == Ran{"", 2});
    CHECK(errors.text() == "ch00: --out needs a folder: --out FOLDER\n");
  }
  const Caught errors(std::cerr);
  CHECK(run_words({"one", "--quik"}) == Ran{"", 2});
  CHECK_THAT(errors.text(), ContainsSubstring("'--quik'") && ContainsSubstring("--quick"));
  CHECK(run_words({"one", "four"}) == Ran{"", 2});
  CHECK_THAT(errors.text(), ContainsSubstring("got 'one' and 'four'"));
}

TEST_CASE("what a chapter says of itself counts as written only if there is room", "[program]") {
  for (const char* option : {"--help", "--quick"}) {
    for (const int room : {300, 1000}) {
      Full full(room);
      std::streambuf* const before = std::cout.rdbuf(&full);
      const Caught errors(std::cerr);
      const std::string files(600, 'x');
      const int code = run_words({option}, {{"one", printing, files.c_str()}}).second;
      std::cout.clear();
      std::cout.rdbuf(before);
      CAPTURE(option, room, errors.text());
      CHECK(code == (room == 1000 ? 0 : 2));
      CHECK((errors.text().find("cannot write all") == std::string::npos) == (room == 1000));
    }
  }
}
