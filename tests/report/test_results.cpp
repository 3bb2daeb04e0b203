#include <cmath>
#include <fstream>
#include <sstream>

#include "catch_compat.hpp"
#include "signorini/report/results.hpp"
#include "support/folder.hpp"
#include "support/message.hpp"

using signorini::Repeats;
using signorini::Results;
using signorini_test::argument_message;
using signorini_test::content_of;
using signorini_test::Folder;
using signorini_test::problem_message;

TEST_CASE("results come back from the file bit by bit", "[results]") {
  const Folder folder;
  const double third = 1.0 / 3.0;
  const double tiny = 4.9406564584124654e-300;
  Results results("ch00");
  results.add("third", third, "cm");
  results.add("tiny", tiny, "-");
  results.write(folder.path());
  std::istringstream lines(content_of(folder.path() / "ch00.results"));
  std::string key;
  std::string value;
  std::string unit;
  lines >> key >> value >> unit;
  CHECK(key == "third");
  CHECK(std::stod(value) == third);  // 17 digits name one double
  CHECK(unit == "cm");
  lines >> key >> value >> unit;
  CHECK(std::stod(value) == tiny);
}

TEST_CASE("a value that does not repeat is marked, the others are not", "[results]") {
  const Folder folder;
  Results results("ch00");
  results.add("force", 2, "kN");
  results.add("seconds", 0.5, "s", Repeats::No);
  results.headline("force", 2.5, "beam theory");
  results.write(folder.path());
  CHECK(content_of(folder.path() / "ch00.results") ==
        "# headline force 2.5 beam theory\nforce 2 kN\nseconds 0.5 s varies\n");
}

TEST_CASE("a key is one word and comes once", "[results]") {
  Results results("ch00");
  results.add("total_force", 1, "kN");
  CHECK_THAT(argument_message([&] { results.add("total_force", 2, "kN"); }),
             ContainsSubstring("'total_force' was added before"));
  CHECK_THAT(argument_message([&] { results.add("total force", 2, "kN"); }),
             ContainsSubstring("must be one word, got 'total force'"));
  CHECK_THAT(argument_message([&] { results.add("", 2, "kN"); }),
             ContainsSubstring("must be one word"));
  CHECK(results.value("total_force") == 1);
  CHECK_THAT(argument_message([&] { static_cast<void>(results.value("peak")); }),
             ContainsSubstring("no key 'peak'"));
}

TEST_CASE("results that cannot be written leave nothing behind", "[results]") {
  const Folder folder;
  std::ofstream(folder.path() / "a_file") << "in the way";
  Results results("ch00");
  results.add("force", 2, "kN");
  // Below a regular file nobody can write, not even a superuser.
  const std::string message = problem_message([&] { results.write(folder.path() / "a_file"); });
  CHECK_THAT(message, ContainsSubstring("cannot write"));
  CHECK_THAT(message, ContainsSubstring("a_file"));
  CHECK(folder.entries() == 1);
  CHECK(content_of(folder.path() / "a_file") == "in the way");
}

TEST_CASE("a file that cannot be replaced stays as it was", "[results]") {
  const Folder folder;
  const std::filesystem::path taken = folder.path() / "taken";
  std::filesystem::create_directory(taken);
  std::ofstream(taken / "inside") << "kept";
  CHECK_THAT(problem_message([&] { signorini::write_file(taken, "new"); }),
             ContainsSubstring("cannot write"));
  CHECK(content_of(taken / "inside") == "kept");
  CHECK(folder.entries() == 1);  // and the draft is gone
}

TEST_CASE("writing a file replaces all of the old one and leaves no draft", "[results]") {
  const Folder folder;
  const std::filesystem::path file = folder.path() / "data.csv";
  signorini::write_file(file, "a long first version\n");
  signorini::write_file(file, "short\n");
  CHECK(content_of(file) == "short\n");
  CHECK(folder.entries() == 1);
}

TEST_CASE("the output folder is made with its parents and left empty", "[results]") {
  const Folder folder;
  const std::filesystem::path deep = folder.path() / "a" / "b";
  signorini::prepare_output_folder(deep);
  CHECK(std::filesystem::is_directory(deep));
  CHECK(std::filesystem::is_empty(deep));
  signorini::prepare_output_folder(deep);  // once more does no harm
}

TEST_CASE("an output folder that cannot be made is named", "[results]") {
  const Folder folder;
  std::ofstream(folder.path() / "a_file") << "in the way";
  const auto prepare = [&](const char* name) {
    return problem_message([&] { signorini::prepare_output_folder(folder.path() / name); });
  };
  CHECK_THAT(prepare("a_file"), ContainsSubstring("a_file"));
  CHECK_THAT(prepare("a_file/out"), ContainsSubstring("a_file/out"));
  CHECK_THAT(prepare("a_file/out"), ContainsSubstring("--out"));
}
