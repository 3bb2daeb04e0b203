// What is said about files that hold no problem: name and line, what was expected, what came.
#include <fstream>

#include "addons/files/problem_file.hpp"
#include "catch_compat.hpp"
#include "support/folder.hpp"
#include "support/message.hpp"

using namespace signorini;
using signorini_test::Folder;
using signorini_test::problem_message;

namespace {

std::string complaint(const std::string& content) {
  return problem_message([&] { static_cast<void>(parse_problem(content, "file")); });
}

const std::string quadratic = "n 1\nm 1\nr 0\nP\n2\nq\n-1\nA\n1\n";

}  // namespace

TEST_CASE("a text that is no problem is refused at its first word", "[problem_file]") {
  const std::string wanted =
      "expected a problem: the number of unknowns (Siconos) or a line 'n NUMBER', got ";
  CHECK(complaint("") == "file:1: " + wanted + "the end of the file");
  CHECK(complaint("# only\n\n# comments\n") == "file:3: " + wanted + "the end of the file");
  CHECK(complaint("\n\nhello world\n") == "file:3: " + wanted + "'hello'");
  CHECK(complaint(std::string("\x7f\x45LF\x02\x01\0\0\n", 9)) ==
        "file:1: " + wanted + "'\?ELF\?\?\?\?'");
  CHECK(complaint(std::string(500, 'x')) ==
        "file:1: " + wanted + "'" + std::string(40, 'x') + "...'");
}

TEST_CASE("sizes are whole numbers that the file can hold", "[problem_file]") {
  const std::string wanted = "expected a whole number from 1 to 1000000, got ";
  CHECK(complaint("n 0\nM\n") == "file:1: n: " + wanted + "'0'");
  CHECK(complaint("n -3\nM\n") == "file:1: n: " + wanted + "'-3'");
  CHECK(complaint("n 2.5\nM\n") == "file:1: n: " + wanted + "'2.5'");
  CHECK(complaint("n\nM\n") == "file:1: n: " + wanted + "the end of the line");
  CHECK(complaint("n 1000000000\nM\n1\n") == "file:1: n: " + wanted + "'1000000000'");
  CHECK(complaint("n 99999999999999999999\n") == "file:1: n: " + wanted + "'99999999999999999999'");
  CHECK(complaint("n 2 2\n") == "file:1: expected the end of the line after 'n NUMBER', got '2'");
  CHECK(complaint("-7\n") == "file:1: number of unknowns: " + wanted + "'-7'");
  // Nothing is allocated for numbers that cannot be there.
  CHECK(
      complaint("n 1000000\nM\n1 2\n") ==
      "file:2: M: expected 1000000 x 1000000 numbers, but only 4 characters are left in the file");
  CHECK(complaint("1000000 0 1000000 1000000 1000000 1000000\n1 2 3") ==
        "file:1: matrix and vector: expected 1000000 x 1000001 numbers, but only 5 characters are "
        "left in the file");
  CHECK(complaint("n 1\nm 1000000\nr 0\nP\n2\nq\n1\nA\n1\n") ==
        "file:8: A: expected 1000000 x 1 numbers, but only 2 characters are left in the file");
}

TEST_CASE("the header of Siconos is checked against itself", "[problem_file]") {
  CHECK(complaint("3 7 3 3") ==
        "file:1: expected the storage of the matrix, 0 (dense), 1 (blocks) or 2 (columns or "
        "triplets); of friction problems those of the plane are read, which begin with 2, got '7'");
  CHECK(complaint("2\n0\n2\n3\n2 3\n1 2 3") ==
        "file:4: columns of the matrix: expected 2 as the unknowns, got 3");
  CHECK(complaint("2\n0\n2\n2\n2\t7\n1 2 3") ==
        "file:5: columns of the matrix, repeated: expected 2 as the unknowns, got 7");
  CHECK(complaint("2\n0\n2") ==
        "file:3: columns of the matrix: expected a whole number from 0 to 1000000, got the end of "
        "the file");
}

TEST_CASE("friction problems of Siconos that contradict themselves", "[problem_file]") {
  const std::string dense = "2 1 0 2 2 2 2 1 0 0 1\n-1 0\n";
  CHECK(complaint(dense + "-0.5") ==
        "file:3: mu(1): expected a friction coefficient of 0 or more, got -0.5");
  CHECK(complaint(dense) ==
        "file:2: mu: expected 1 x 1 numbers, but only 0 characters are left in the file");
  CHECK(complaint(dense + "0.5 7") ==
        "file:3: expected the end of the problem, or a remark, got '7'");
  CHECK(complaint("2 3 0 5") == "file:1: rows of the matrix: expected 6 as the unknowns, got 5");
  const std::string block = "2 1 1 2 2 ";
  CHECK(complaint(block + "1 1 1 3") ==
        "file:1: end of a block row: expected a whole number from 1 to 2, got '3'");
  CHECK(complaint(block + "1 1 1 1 2") ==
        "file:1: end of a block row: expected the last at 2, got 1");
  CHECK(complaint(block + "1 1 1 2 2 2 1 0 0") ==
        "file:1: first block of a row: expected a whole number from 1 to 1, got '0'");
  CHECK(complaint(block + "1 1 1 2 2 2 1 0 1 1") ==
        "file:1: column of a block: expected a whole number from 0 to 0, got '1'");
  const std::string sparse = "2 1 2 2 2 2\nCSparse Version\n2-by-2, nzmax: 2 nnz: 2, 1-norm: 1\n";
  CHECK(complaint(sparse + "col 0 : locations 0 to 2") ==
        "file:4: last entry of a column: expected a whole number from -1 to 1, got '2'");
  CHECK(complaint(sparse + "col 0 : locations 0 to 0\n2 : 1") ==
        "file:5: row of an entry: expected a whole number from 0 to 1, got '2'");
  CHECK(complaint("2 1 2 2 2 2\nmatrix") == "file:2: expected 'CSparse', got 'matrix'");
  CHECK(complaint("2 6000 2 12000 12000 2\n") ==
        "file:1: a matrix with 12000 rows is not read: at most 10000, because it is solved as a "
        "dense one");
}

TEST_CASE("numbers of Siconos that are missing, odd or too many", "[problem_file]") {
  const std::string head = "2\n0\n2\n2\n2\t2\n";
  CHECK(complaint(head + "1 2\n3 4\n-5 ......") ==
        "file:8: q(2): expected a finite number, got '......'");
  CHECK(complaint(head + "1 2\n3 4\n-5                ") ==
        "file:8: q(2): expected a finite number, got the end of the file");
  CHECK(complaint(head + "1 2\nx 4\n-5 -6\n") ==
        "file:7: M(1,2): expected a finite number, got 'x'");
  CHECK(complaint(head + "1 2\n3 4\n-5 -6\n7\n") ==
        "file:9: expected the end of the 2 x 3 numbers, or a remark, got '7'");
  CHECK(complaint(head + "1 2\n3 4\n-5 -6\nRemark 7\n").empty());
}

TEST_CASE("a row has as many numbers as it should, all finite", "[problem_file]") {
  CHECK(complaint("n 2\nM\n1 2\n3\nq\n1 2\n") ==
        "file:4: M, row 2: expected 2 numbers on one line, got 1");
  CHECK(complaint("n 2\nM\n1 2 3\n4\nq\n1 2\n") ==
        "file:3: M, row 1: expected 2 numbers on one line, got 3 words");
  CHECK(complaint("n 2\nM\n1 2\n3 4\nq\n1  # 2\n") ==
        "file:6: q: expected 2 numbers on one line, got 1");
  for (const std::string& word : std::vector<std::string>{"nan", "-inf", "infinity", "1e", "1,5",
                                                          "0x10", "--1", "+-1", "1d3", "1.2.3"})
    CHECK(complaint("n 1\nM\n" + std::string(word) + "\nq\n1\n") ==
          "file:3: M, row 1, number 1: expected a finite number, got '" + word + "'");
  for (const std::string& word : std::vector<std::string>{"1e999", "-1e309", "1e-999"})
    CHECK(complaint("n 1\nM\n" + std::string(word) + "\nq\n1\n") ==
          "file:3: M, row 1, number 1: expected a number that a double can hold, got '" + word +
              "'");
  CHECK(complaint("n 1\nM\n5e-324\nq\n-1.7976931348623157e308\n").empty());
}

TEST_CASE("blocks come in their order, each once", "[problem_file]") {
  CHECK(complaint("n 1\nM\n1\nM\n") == "file:4: expected a line with the single word 'q', got 'M'");
  CHECK(complaint("n 1\nM\n1\nq 5\n") ==
        "file:4: expected a line with the single word 'q', got '5'");
  CHECK(complaint("n 1\nM\n1\n") ==
        "file:3: expected a line with the single word 'q', got the end of the file");
  CHECK(complaint("n 1\nq\n1\n") ==
        "file:2: expected 'M' of a complementarity problem or 'm NUMBER' of a quadratic programme, "
        "got 'q'");
  const std::string problem = "n 1\nM\n1\nq\n1\n";
  const std::string wanted =
      "expected 'z', then 'w' (each once), or 'n NUMBER' of another problem, got ";
  CHECK(complaint(problem + "w\n1\nz\n0\n") == "file:8: " + wanted + "'z'");
  CHECK(complaint(problem + "z\n1\nz\n0\n") == "file:8: " + wanted + "'z'");
  CHECK(complaint(problem + "the end\n") == "file:6: " + wanted + "'the'");
  CHECK(complaint(problem + "z 1\n") == "file:6: expected the end of the line after 'z', got '1'");
  CHECK(complaint("n 1\nm 0\nP\n1\n") == "file:3: expected a line 'r NUMBER', got 'P'");
}

TEST_CASE("bounds leave room, P is symmetric, and nothing follows a quadratic programme",
          "[problem_file]") {
  CHECK(complaint(quadratic + "l\n1\nu\n2\n").empty());
  CHECK(complaint(quadratic + "l\n3\nu\n2\n") ==
        "file:13: row 1: no number lies between l = 3 and u = 2");
  CHECK(complaint(quadratic + "l\n1e20\nu\n1e20\n") ==
        "file:13: row 1: no number lies between l = 1e+20 and u = 1e+20");
  CHECK(complaint(quadratic + "l\n-1e21\nu\n-1e20\n") ==
        "file:13: row 1: no number lies between l = -1e+21 and u = -1e+20");
  CHECK(complaint(quadratic + "l\n1\nu\n2\nn 1\n") ==
        "file:14: expected the end of the file after 'u', got 'n'");
  CHECK(complaint("n 2\nm 0\nr 0\nP\n2 1\n3 2\nq\n1 1\nA\nl\nu\n") ==
        "file:6: P must be symmetric, but P(1,2) = 1 and P(2,1) = 3; (P + P')/2 gives the same "
        "objective");
}

TEST_CASE("a file that cannot be read is named", "[problem_file]") {
  const Folder folder;
  const auto said = [](const std::filesystem::path& file) {
    return problem_message([&] { static_cast<void>(read_problem(file)); });
  };
  const std::string missing = (folder.path() / "missing").string();
  CHECK(said(missing) == missing + ": there is no such file");
  CHECK(said(folder.path()) == folder.path().string() + ": this is a folder; name a file in it");
  CHECK(said("/dev/null") == "/dev/null: this is not a plain file");
  const std::filesystem::path large = folder.path() / "large";
  std::ofstream(large).close();
  std::filesystem::resize_file(large, largest_problem_file + 1);  // holds no blocks
  CHECK(said(large) == large.string() + ": expected at most 268435456 bytes, got 268435457");
}
