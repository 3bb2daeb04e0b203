#include "signorini/problem/residual.hpp"

#include <algorithm>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/problem/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Columns = Eigen::SparseMatrix<double>;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Whether u carries a second, smaller part.
bool has_low(const PrimalDual& solution) { return solution.displacement_low.size() > 0; }

/// u as the sum of two vectors.
struct Parts {
  VectorXd high;
  VectorXd low;
};

/// u without its rigid part: the difference is exact.
Parts strained_parts(const PrimalDual& solution) {
  const VectorXd none = VectorXd::Zero(solution.displacement.size());
  Parts parts{solution.displacement, has_low(solution) ? solution.displacement_low : none};
  for (Index i = 0; i < solution.rigid.size(); ++i) {
    ExactSum difference(parts.high(i));
    difference.add(-solution.rigid(i));
    parts.high(i) = difference.high();
    parts.low(i) += difference.low();
  }
  return parts;
}

/// Whether this and the next column of K have entries in the same rows, as the unknowns of a node mostly have.
bool twins(const Columns& K, Index column) {
  if (column + 1 >= K.cols() || !K.isCompressed()) return false;
  const int* const outer = K.outerIndexPtr() + column;
  const int* const inner = K.innerIndexPtr();
  return outer[1] - outer[0] == outer[2] - outer[1] &&
         std::equal(inner + outer[0], inner + outer[1], inner + outer[1]);
}

/// p - K u of one unknown, or of two that are twins side by side: that takes half of the time. K has both triangles, so
/// columns serve as rows.
template <int rows>
void subtract_stiffness(const QuadraticProgramme& programme, const Parts& u, Index row,
                        std::vector<ExactSum>& sums) {
  using Numbers = Eigen::Array<double, rows, 1>;
  const Columns& K = programme.stiffness;
  const double* const values = K.valuePtr() + K.outerIndexPtr()[row];
  const int* const inner = K.innerIndexPtr() + K.outerIndexPtr()[row];
  const Index count = K.col(row).nonZeros();
  ExactSumOf<Numbers> sum(programme.load.segment<rows>(row), Numbers::Zero());
  Numbers small = Numbers::Zero();
  for (Index k = 0; k < count; ++k) {
    Numbers entry;
    for (int r = 0; r < rows; ++r) entry(r) = values[r * count + k];
    sum.add_product(-entry, Numbers::Constant(u.high(inner[k])));
    small += entry * u.low(inner[k]);
  }
  sum.add(-small);
  for (int r = 0; r < rows; ++r) sums.emplace_back(sum.high()(r), sum.low()(r));
}

}  // namespace

void check_sizes(const QuadraticProgramme& programme, const PrimalDual& solution) {
  const Index n = programme.load.size();
  const Index pairs = programme.initial_gap.size();
  require_argument(programme.stiffness.rows() == n && programme.stiffness.cols() == n &&
                       programme.A.rows() == pairs && programme.A.cols() == n,
                   "certify: K must be ", n, " x ", n, " and A ", pairs, " x ", n, ", got ",
                   programme.stiffness.rows(), " x ", programme.stiffness.cols(), " and ",
                   programme.A.rows(), " x ", programme.A.cols());
  require_argument(solution.displacement.size() == n && solution.force.size() == pairs &&
                       (!has_low(solution) || solution.displacement_low.size() == n) &&
                       (solution.rigid.size() == 0 || solution.rigid.size() == n),
                   "certify: need ", n, " displacements and ", pairs, " forces, got ",
                   solution.displacement.size(), " and ", solution.force.size());
}

void add_displacement(PrimalDual& solution, const VectorXd& change) {
  for (Index i = 0; i < change.size(); ++i)
    add_to(solution.displacement(i), solution.displacement_low(i), change(i));
}

VectorXd strained(const PrimalDual& solution) {
  VectorXd u = solution.displacement;
  if (solution.rigid.size() > 0) u -= solution.rigid;
  if (has_low(solution)) u += solution.displacement_low;
  return u;
}

VectorXd equilibrium_residual(const QuadraticProgramme& programme, const PrimalDual& solution) {
  check_sizes(programme, solution);
  const Parts u = strained_parts(solution);
  std::vector<ExactSum> sums;
  sums.reserve(static_cast<std::size_t>(programme.load.size()));
  for (Index i = 0; i < programme.load.size(); ++i)
    if (twins(programme.stiffness, i))
      subtract_stiffness<2>(programme, u, i++, sums);
    else
      subtract_stiffness<1>(programme, u, i, sums);
  for (Index pair = 0; pair < programme.A.rows(); ++pair)
    for (RowMatrix::InnerIterator entry(programme.A, pair); entry; ++entry)
      sums[static_cast<std::size_t>(entry.col())].add_product(-entry.value(), solution.force(pair));
  VectorXd residual(programme.load.size());
  for (Index i = 0; i < residual.size(); ++i)
    residual(i) = sums[static_cast<std::size_t>(i)].value();
  return residual;
}

VectorXd gaps(const QuadraticProgramme& programme, const PrimalDual& solution) {
  check_sizes(programme, solution);
  VectorXd gap(programme.initial_gap.size());
  for (Index pair = 0; pair < gap.size(); ++pair) {
    ExactSum sum(programme.initial_gap(pair));
    for (RowMatrix::InnerIterator entry(programme.A, pair); entry; ++entry) {
      sum.add_product(-entry.value(), solution.displacement(entry.col()));
      if (has_low(solution)) sum.add(-entry.value() * solution.displacement_low(entry.col()));
    }
    gap(pair) = sum.value();
  }
  return gap;
}

}  // namespace signorini
