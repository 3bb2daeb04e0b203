#include "addons/files/problem_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "addons/files/siconos.hpp"
#include "addons/text/text_reader.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// The rows of a matrix, each on a line.
Eigen::MatrixXd read_rows(TextReader& in, const std::string& name, Index rows, Index columns) {
  in.check_room(rows, columns, name);
  Eigen::MatrixXd matrix(rows, columns);
  Eigen::RowVectorXd row(columns);
  for (Index i = 0; i < rows; ++i) {
    in.expect_row(text(name, ", row ", i + 1), row);
    matrix.row(i) = row;
  }
  return matrix;
}

/// A matrix of a block format: its rows below a line with its name.
Eigen::MatrixXd read_matrix(TextReader& in, const std::string& name, Index rows, Index columns) {
  in.expect_line(name);
  return read_rows(in, name, rows, columns);
}

/// The rest of a line `NAME NUMBER`: a size.
Index read_size(TextReader& in, const std::string& name, Index least) {
  const Index size = in.size(in.word(), name, least);
  in.expect_end_of_line("'" + name + " NUMBER'");
  return size;
}

/// The entries of a vector on the next line.
Eigen::VectorXd read_entries(TextReader& in, const std::string& name, Index size) {
  in.check_room(1, size, name);
  Eigen::RowVectorXd row(size);
  in.expect_row(name, row);
  return row.transpose();
}

Eigen::VectorXd read_vector(TextReader& in, const std::string& name, Index size) {
  in.expect_line(name);
  return read_entries(in, name, size);
}

/// Bounds of rows; a word that is no number may be meant for none.
Eigen::VectorXd read_bounds(TextReader& in, const std::string& name, Index size) {
  in.expect_line(name);
  try {
    return read_entries(in, name, size);
  } catch (const ProblemError& error) {
    const bool number = std::string(error.what()).find("a finite number") != std::string::npos;
    throw ProblemError(text(error.what(), number ? "; for no bound write " : "",
                            number ? (name == "l" ? "-1e20" : "1e20") : ""));
  }
}

/// A problem whose line `n NUMBER` and line `M` were read.
FiledProblem read_block(TextReader& in, std::size_t line, Index n) {
  FiledProblem filed;
  filed.line = line;
  filed.problem.compliance = read_rows(in, "M", n, n);
  filed.problem.free_gap = read_vector(in, "q", n);
  return filed;
}

std::vector<FiledProblem> read_blocks(TextReader& in, std::size_t line, Index n) {
  std::vector<FiledProblem> all = {read_block(in, line, n)};
  while (in.next_line()) {
    FiledProblem& last = all.back();
    const std::string_view word = in.word();
    if (word == "z" && last.known_force.size() == 0 && last.known_gap.size() == 0) {
      in.expect_end_of_line("'z'");
      last.known_force = read_entries(in, "z", n);
    } else if (word == "w" && last.known_gap.size() == 0) {
      in.expect_end_of_line("'w'");
      last.known_gap = read_entries(in, "w", n);
    } else if (word == "n") {
      line = in.line();
      n = read_size(in, "n", 1);
      in.expect_line("M");
      all.push_back(read_block(in, line, n));
    } else {
      in.fail("'z', then 'w' (each once), or 'n NUMBER' of another problem", word);
    }
  }
  return all;
}

void check_bounds(const TextReader& in, const TwoSidedProgramme& programme) {
  for (Index i = 0; i < programme.lower.size(); ++i) {
    const double lower = programme.lower(i);
    const double upper = programme.upper(i);
    if (lower > upper || lower >= no_bound || upper <= -no_bound)
      in.fail(text("row ", i + 1, ": no number lies between l = ", lower, " and u = ", upper));
  }
}

/// Refuses a P that is not symmetric to rounding, and evens the rounding out.
void make_symmetric(const TextReader& in, Eigen::MatrixXd& P) {
  const Eigen::VectorXd size = P.diagonal().cwiseAbs().cwiseSqrt();
  const double rounding = 1e3 * epsilon;
  for (Index j = 0; j < P.cols(); ++j)
    for (Index i = 0; i < j; ++i) {
      const double a = P(i, j);
      const double b = P(j, i);
      const double allowed = rounding * std::max({std::abs(a), std::abs(b), size(i) * size(j)});
      if (std::abs(a - b) > allowed)
        in.fail(text("P must be symmetric, but P(", i + 1, ",", j + 1, ") = ", a, " and P(", j + 1,
                     ",", i + 1, ") = ", b, "; (P + P')/2 gives the same objective"));
      P(i, j) = P(j, i) = 0.5 * a + 0.5 * b;
    }
}

TwoSidedProgramme read_programme(TextReader& in, Index n, Index m) {
  TwoSidedProgramme programme;
  in.next_line();
  const std::string_view word = in.word();
  if (word != "r") in.fail("a line 'r NUMBER'", word);
  programme.r = in.number(in.word(), "r");
  in.expect_end_of_line("'r NUMBER'");
  programme.P = read_matrix(in, "P", n, n);
  make_symmetric(in, programme.P);
  programme.q = read_vector(in, "q", n);
  programme.A = read_matrix(in, "A", m, n);
  programme.lower = read_bounds(in, "l", m);
  programme.upper = read_bounds(in, "u", m);
  check_bounds(in, programme);
  if (in.next_line()) in.fail("the end of the file after 'u'", in.word());
  return programme;
}

/// The number after the colon of a comment that begins with `published optimum`.
std::optional<double> published_optimum(std::string_view content) {
  constexpr std::string_view title = "# published optimum";
  const std::size_t begin = content.find(title);
  if (begin == std::string_view::npos) return std::nullopt;
  std::string_view line = content.substr(begin);
  line = line.substr(0, line.find_first_of("\r\n"));
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  TextReader rest(line.substr(colon + 1), "");
  try {
    return rest.next_line() ? std::optional<double>(rest.number(rest.word(), "")) : std::nullopt;
  } catch (const ProblemError&) {
    return std::nullopt;  // a remark in words
  }
}

}  // namespace

ProblemFile parse_problem(std::string_view content, const std::string& name) {
  const std::string wanted = "a problem: the number of unknowns (Siconos) or a line 'n NUMBER'";
  TextReader in(content, name);
  in.next_line();
  const std::string_view first = in.word();
  if (!first.empty() && first.find_first_not_of("+-.0123456789") == std::string_view::npos)
    return read_siconos(in, first);
  if (first != "n") in.fail(wanted, first);
  const std::size_t line = in.line();
  const Index n = read_size(in, "n", 1);
  in.next_line();
  const std::string_view second = in.word();
  if (second == "M") {
    in.expect_end_of_line("'M'");
    return read_blocks(in, line, n);
  }
  if (second != "m")
    in.fail("'M' of a complementarity problem or 'm NUMBER' of a quadratic programme", second);
  TwoSidedProgramme programme = read_programme(in, n, read_size(in, "m", 0));
  programme.published_optimum = published_optimum(content);
  return programme;
}

ProblemFile read_problem(const std::filesystem::path& file) {
  return parse_problem(file_content(file, largest_problem_file), file.string());
}

}  // namespace signorini
