#include "addons/files/siconos.hpp"

#include <limits>
#include <string>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// A whole number on this line or below.
Index whole_below(TextReader& in, const std::string& what, Index least, Index most) {
  return in.whole(in.word_anywhere(), what, least, most);
}

double number_below(TextReader& in, const std::string& what) {
  return in.number(in.word_anywhere(), what);
}

void expect_word(TextReader& in, std::string_view wanted) {
  const std::string_view word = in.word_anywhere();
  if (word != wanted) in.fail("'" + std::string(wanted) + "'", word);
}

/// A whole number that is known already.
void expect_whole(TextReader& in, const std::string& what, Index wanted) {
  static_cast<void>(whole_below(in, what, wanted, wanted));
}

/// A size that is known already.
void expect_size(TextReader& in, const std::string& what, Index n) {
  const Index size = in.size(in.word_anywhere(), what, 0);
  if (size != n) in.fail(text(what, ": expected ", n, " as the unknowns, got ", size));
}

VectorXd read_numbers(TextReader& in, const std::string& name, Index size) {
  in.check_room(1, size, name);
  VectorXd numbers(size);
  for (Index i = 0; i < size; ++i) numbers(i) = number_below(in, text(name, "(", i + 1, ")"));
  return numbers;
}

double read_entry(TextReader& in, Index i, Index j) {
  return number_below(in, text("M(", i + 1, ",", j + 1, ")"));
}

/// Where the entries of a matrix that leaves zeros out will stand.
MatrixXd zeros(TextReader& in, Index n) {
  if (n > largest_sparse_matrix)
    in.fail(text("a matrix with ", n, " rows is not read: at most ", largest_sparse_matrix,
                 ", because it is solved as a dense one"));
  in.check_room(1, n, "vector");
  return MatrixXd::Zero(n, n);
}

/// Storage 0: both sizes again, then all entries COLUMN by column.
MatrixXd read_dense(TextReader& in, Index n) {
  expect_size(in, "rows of the matrix, repeated", n);
  expect_size(in, "columns of the matrix, repeated", n);
  in.check_room(n, n + 1, "matrix and vector");
  MatrixXd M(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) M(i, j) = read_entry(in, i, j);
  return M;
}

/// Where blocks begin, from the numbers where they end, and where the last one ends.
std::vector<Index> read_borders(TextReader& in, const std::string& what, Index count, Index n) {
  in.check_room(1, count, what);
  std::vector<Index> borders = {0};
  for (Index i = 0; i < count; ++i) borders.push_back(whole_below(in, what, borders.back() + 1, n));
  if (borders.back() != n)
    in.fail(text(what, ": expected the last at ", n, ", got ", borders.back()));
  return borders;
}

/// Storage 1: the ends of the blocks in rows and columns; the first block of each row and the column of each block;
/// then each block behind its number, COLUMN by column.
MatrixXd read_blocks(TextReader& in, Index n) {
  MatrixXd M = zeros(in, n);
  const Index count = whole_below(in, "number of blocks", 0, TextReader::largest_size);
  const Index rows = whole_below(in, "number of block rows", 1, n);
  const Index columns = whole_below(in, "number of block columns", 1, n);
  const std::vector<Index> top = read_borders(in, "end of a block row", rows, n);
  const std::vector<Index> left = read_borders(in, "end of a block column", columns, n);
  const Index filled = whole_below(in, "number of filled block rows and 1", 2, rows + 1);
  expect_whole(in, "number of blocks, repeated", count);
  in.check_room(2, count, "columns and numbers of the blocks");
  std::vector<Index> start;
  for (Index i = 0; i < filled; ++i) {
    const bool last = i + 1 == filled;  // no block may be without a row
    start.push_back(whole_below(in, "first block of a row",
                                last    ? count
                                : i > 0 ? start.back()
                                        : 0,
                                i == 0 && !last ? 0 : count));
  }
  std::vector<Index> column;
  for (Index b = 0; b < count; ++b)
    column.push_back(whole_below(in, "column of a block", 0, columns - 1));
  std::size_t row = 0;
  for (Index b = 0; b < count; ++b) {
    while (b >= start[row + 1]) ++row;
    const auto c = at(column[at(b)]);
    expect_whole(in, "number of a block", b);
    for (Index j = left[c]; j < left[c + 1]; ++j)
      for (Index i = top[row]; i < top[row + 1]; ++i) M(i, j) += read_entry(in, i, j);
  }
  return M;
}

/// What CSparse prints behind the place of an entry.
void add_entry(TextReader& in, Index row, Index column, MatrixXd& M) {
  expect_word(in, ":");
  M(row, column) += read_entry(in, row, column);
}

void read_triplets(TextReader& in, Index count, MatrixXd& M) {
  for (Index k = 0; k < count; ++k) {
    const Index row = whole_below(in, "row of an entry", 0, M.rows() - 1);
    add_entry(in, row, whole_below(in, "column of an entry", 0, M.cols() - 1), M);
  }
}

void read_columns(TextReader& in, Index count, MatrixXd& M) {
  Index next = 0;
  for (Index j = 0; j < M.cols(); ++j) {
    expect_word(in, "col");
    expect_whole(in, "column", j);
    expect_word(in, ":");
    expect_word(in, "locations");
    expect_whole(in, "first entry of a column", next);
    expect_word(in, "to");
    const Index least = j + 1 < M.cols() ? next - 1 : count - 1;
    const Index end = whole_below(in, "last entry of a column", least, count - 1) + 1;
    for (; next < end; ++next)
      add_entry(in, whole_below(in, "row of an entry", 0, M.rows() - 1), j, M);
  }
}

/// Storage 2: what CSparse prints, column by column or as triplets, rows and columns from 0.
MatrixXd read_sparse(TextReader& in, Index n) {
  MatrixXd M = zeros(in, n);
  const bool columns =
      whole_below(in, "order of the entries, 1 for triplets or 2 for columns", 1, 2) == 2;
  expect_word(in, "CSparse");
  static_cast<void>(in.rest_of_line());
  if (!columns) expect_word(in, "triplet:");
  expect_word(in, text(n, "-by-", n, ","));
  expect_word(in, "nzmax:");
  static_cast<void>(whole_below(in, "room for entries", 0, std::numeric_limits<Index>::max()));
  expect_word(in, "nnz:");
  std::string_view entries = in.word_anywhere();
  if (columns) entries = entries.substr(0, entries.find(','));  // the norm follows
  const Index count = in.whole(entries, "number of entries", 0, std::numeric_limits<Index>::max());
  static_cast<void>(in.rest_of_line());
  if (columns)
    read_columns(in, count, M);
  else
    read_triplets(in, count, M);
  return M;
}

/// A matrix behind the number of its storage.
MatrixXd read_matrix(TextReader& in, std::string_view storage, Index n) {
  if (storage != "0" && storage != "1" && storage != "2")
    in.fail(
        "the storage of the matrix, 0 (dense), 1 (blocks) or 2 (columns or triplets); of friction "
        "problems those of the plane are read, which begin with 2",
        storage);
  expect_size(in, "rows of the matrix", n);
  expect_size(in, "columns of the matrix", n);
  return storage == "0"   ? read_dense(in, n)
         : storage == "1" ? read_blocks(in, n)
                          : read_sparse(in, n);
}

/// Normal and tangential rows in turns become gaps first, then slips; the signs are ours.
ContactProblem friction_problem(const MatrixXd& W, const VectorXd& q, const VectorXd& mu) {
  const Index pairs = mu.size();
  std::vector<Index> order;
  for (Index row = 0; row < 2; ++row)
    for (Index i = 0; i < pairs; ++i) order.push_back(2 * i + row);
  ContactProblem problem;
  problem.compliance = W(order, order);
  problem.free_gap = q(order).head(pairs);
  problem.free_slip = q(order).tail(pairs);
  problem.law = law_of_all(mu, VectorXd::Zero(pairs));
  return problem;
}

/// A friction problem, behind its dimension. \param pairs  the word that counts them
ContactProblem read_friction(TextReader& in, std::string_view pairs) {
  const Index n = in.whole(pairs, "number of pairs", 1, TextReader::largest_size / 2);
  const MatrixXd W = read_matrix(in, in.word_anywhere(), 2 * n);
  const VectorXd q = read_numbers(in, "q", 2 * n);
  const VectorXd mu = read_numbers(in, "mu", n);
  for (Index i = 0; i < n; ++i)
    if (mu(i) < 0)
      in.fail(text("mu(", i + 1, "): expected a friction coefficient of 0 or more, got ", mu(i)));
  return friction_problem(W, q, mu);
}

}  // namespace

std::vector<FiledProblem> read_siconos(TextReader& in, std::string_view first) {
  FiledProblem filed;
  filed.line = in.line();
  const Index n = in.size(first, "number of unknowns", 1);
  const std::string_view second = in.word_anywhere();
  const bool friction = n == 2 && second != "0";
  std::string_view more;
  if (friction) {
    filed.problem = read_friction(in, second);
    more = in.word_anywhere();
    if (more == "0" || more == "1") more = in.word_anywhere();  // a mark that Siconos may leave
  } else {
    filed.problem.compliance = read_matrix(in, second, n);
    filed.problem.free_gap = read_numbers(in, "q", n);
    more = in.word_anywhere();
  }
  if (!more.empty() && more.find_first_not_of("0123456789+-.eE") == std::string_view::npos)
    in.fail(text("the end of the ", friction ? "problem" : text(n, " x ", n + 1, " numbers"),
                 ", or a remark"),
            more);
  return {std::move(filed)};
}

}  // namespace signorini
