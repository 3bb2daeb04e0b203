// Three problems with K = I, in exact fractions and in floating point.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "addons/programme/dense_programme.hpp"
#include "support/exact.hpp"

namespace ch04 {

const exact::Programme corner = {{{0, 1}, {1, -1}}, {0, 0}, {1, 2}};
const exact::Programme fan = {{{1, -1}, {2, -1}, {1, 1}}, {0, 0, 0}, {1, 0}};
const exact::Programme four_walls = {
    {{-3, -2, 3}, {1, -3, 3}, {-1, 2, 0}, {2, -3, 3}}, {1, 1, 1, 2}, {0, -1, 6}};

inline Eigen::VectorXd floating(const exact::Vector& x) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(x.size()));
  std::transform(x.begin(), x.end(), result.begin(), [](const auto& f) { return f.value(); });
  return result;
}

/// The same programme, condensed: G = A A^T, d = g - A p.
inline signorini::ContactProblem condensed(const exact::Programme& q) {
  Eigen::MatrixXd A(q.A.size(), q.p.size());
  for (Eigen::Index i = 0; i < A.rows(); ++i) A.row(i) = floating(q.A[static_cast<std::size_t>(i)]);
  return {A * A.transpose(), floating(q.g) - A * floating(q.p)};
}

inline std::string text_of(const exact::Set& rows) {  // counted from 1
  std::string list;
  for (const std::size_t i : rows) list += (list.empty() ? "" : ", ") + std::to_string(i + 1);
  return list;
}

/// u = p - A^T lambda, the displacements that belong to forces.
inline Eigen::VectorXd displacement(const exact::Programme& q, const Eigen::VectorXd& force) {
  Eigen::VectorXd u = floating(q.p);
  for (std::size_t i = 0; i < q.A.size(); ++i)
    u -= force(static_cast<Eigen::Index>(i)) * floating(q.A[i]);
  return u;
}

}  // namespace ch04
