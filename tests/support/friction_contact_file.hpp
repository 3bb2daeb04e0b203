// Reader of plane friction problems in the text format of Siconos.
#pragma once
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini_test {

namespace detail {

inline std::vector<double> numbers(std::istream& in, std::size_t count) {
  std::vector<double> read(count);
  for (double& x : read)
    if (!(in >> x)) throw std::runtime_error("friction file: too few numbers");
  return read;
}

inline double number(std::istream& in) { return numbers(in, 1)[0]; }

/// Storage 0: rows, columns, then all entries column by column.
inline Eigen::MatrixXd dense(std::istream& in, Eigen::Index size) {
  static_cast<void>(numbers(in, 4));  // rows and columns, twice
  const std::vector<double> entries = numbers(in, static_cast<std::size_t>(size * size));
  return Eigen::Map<const Eigen::MatrixXd>(entries.data(), size, size);
}

/// Storage 1: sizes, where each row of 2 x 2 blocks starts, the columns, then each block behind its number.
inline Eigen::MatrixXd blocks(std::istream& in, Eigen::Index size) {
  static_cast<void>(numbers(in, 2));
  const auto count = static_cast<std::size_t>(number(in));
  const auto rows = static_cast<std::size_t>(number(in));
  const auto columns = static_cast<std::size_t>(number(in));
  static_cast<void>(numbers(in, rows + columns));
  const auto starts = static_cast<std::size_t>(number(in));
  static_cast<void>(number(in));
  const std::vector<double> start = numbers(in, starts);
  const std::vector<double> column = numbers(in, count);
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(size, size);
  std::size_t row = 0;
  for (std::size_t b = 0; b < count; ++b) {
    while (static_cast<double>(b) >= start[row + 1]) ++row;
    static_cast<void>(number(in));
    const std::vector<double> entries = numbers(in, 4);
    W.block(2 * static_cast<Eigen::Index>(row), 2 * static_cast<Eigen::Index>(column[b]), 2, 2) =
        Eigen::Map<const Eigen::Matrix2d>(entries.data());
  }
  return W;
}

}  // namespace detail

/// Reads u = W r + q, normal and tangential in turns: gaps and slips u, forces r.
inline signorini::ContactProblem read_friction_contact(const std::string& path) {
  std::ifstream in(path);
  if (!in || detail::number(in) != 2) throw std::runtime_error("no plane friction file: " + path);
  const auto n = static_cast<Eigen::Index>(detail::number(in));
  const double storage = detail::number(in);
  const Eigen::MatrixXd W = storage == 0 ? detail::dense(in, 2 * n) : detail::blocks(in, 2 * n);
  const std::vector<double> q = detail::numbers(in, static_cast<std::size_t>(2 * n));
  const std::vector<double> mu = detail::numbers(in, static_cast<std::size_t>(n));
  std::vector<Eigen::Index> order;
  for (Eigen::Index i = 0; i < n; ++i) order.push_back(2 * i);
  for (Eigen::Index i = 0; i < n; ++i) order.push_back(2 * i + 1);
  const Eigen::VectorXd free = Eigen::Map<const Eigen::VectorXd>(q.data(), 2 * n)(order);
  signorini::ContactProblem problem;
  problem.compliance = W(order, order);
  problem.free_gap = free.head(n);
  problem.free_slip = free.tail(n);
  problem.law = signorini::law_of_all(Eigen::Map<const Eigen::VectorXd>(mu.data(), n),
                                      Eigen::VectorXd::Zero(n));
  return problem;
}

}  // namespace signorini_test
