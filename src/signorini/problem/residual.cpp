// # What a claim leaves of the equations
//
// A claimed solution (u, λ) is put into the equations as they were posed, and two vectors remain,
// \f[ r = p - Ku - A^T\lambda, \qquad g - Au: \f]
// the forces that are missing in the equilibrium, and the gaps. Everything that is said about the
// quality of a solution rests on them. So their own rounding must not be seen.
//
// Two things make it large otherwise. A stiff spring of 1e10 carries the force 1 between nodes that
// are displaced by 1 and \f$ 1 + 10^{-10} \f$. A double near 1 is rounded by up to 1.1e-16, and
// that alone is a force of 1.1e-6. So u is kept as the sum of two doubles, and the sums are those
// of ExactSum. And a body that moves far as a whole is strained by the rounding of K. So the rigid
// part of u is known by itself, and K is not applied to it.

#include "signorini/problem/residual.hpp"

#include <algorithm>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/parts.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Columns = Eigen::SparseMatrix<double>;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// A solution in plain doubles has no second part.
bool has_low(const PrimalDual& solution) { return solution.displacement_low.size() > 0; }

// u as the sum of two vectors.
struct Parts {
  VectorXd high;
  VectorXd low;
};

// u without its rigid part, as two vectors again. ExactSum keeps what the subtraction would lose.
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

// The two unknowns of a node mostly have entries in the same rows of K. Then two residuals are
// computed side by side, which takes half of the time. Such columns are recognised by their row
// numbers.
bool twins(const Columns& K, Index column) {
  if (column + 1 >= K.cols() || !K.isCompressed()) return false;
  const int* const outer = K.outerIndexPtr() + column;
  const int* const inner = K.innerIndexPtr();
  return outer[1] - outer[0] == outer[2] - outer[1] &&
         std::equal(inner + outer[0], inner + outer[1], inner + outer[1]);
}

// Threads take so many residuals at a time: with fewer, a thread would take longer to begin than to compute them.
constexpr Index residuals_at_a_time = 4096;

// p - K u of one unknown, or of two twins. K is symmetric and has both triangles, so a column serves
// as a row. Products with the small part of u are small themselves, and a plain sum is enough for
// them.
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
  for (int r = 0; r < rows; ++r) sums[at(row + r)] = ExactSum(sum.high()(r), sum.low()(r));
}

}  // namespace

// Both residuals and the certificate begin with this check. Eigen would not find wrong sizes in a
// release build: it would read what lies behind a vector, and the residual of a false claim could
// be small.
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

// A correction is smaller than u. Added to a single double it would lose most of its digits, and
// corrections could never make u better than its rounding.
void add_displacement(PrimalDual& solution, const VectorXd& change) {
  for (Index i = 0; i < change.size(); ++i)
    add_to(solution.displacement(i), solution.displacement_low(i), change(i));
}

// Stresses are computed from these displacements. The rigid part goes first, so that the large
// numbers cancel. The small part then adds the digits that u lacks. In the other order, u would
// absorb the small part, because its last digit is larger.
VectorXd strained(const PrimalDual& solution) {
  VectorXd u = solution.displacement;
  if (solution.rigid.size() > 0) u -= solution.rigid;
  if (has_low(solution)) u += solution.displacement_low;
  return u;
}

// One pass over the columns of K. Of twins the second one is done already, so i grows twice. Each
// unknown has its own sum: it is as exact beside a large residual as alone, and the same on any
// number of threads. The certificate measures these forces by the loads, and the refined solve hands
// them to the factor of K, which makes the next correction of them.
VectorXd equilibrium_residual(const QuadraticProgramme& programme, const PrimalDual& solution) {
  check_sizes(programme, solution);
  const Parts u = strained_parts(solution);
  std::vector<ExactSum> sums(at(programme.load.size()));
  for_ranges(programme.load.size(), residuals_at_a_time, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i)
      if (i + 1 < end && twins(programme.stiffness, i))
        subtract_stiffness<2>(programme, u, i++, sums);
      else
        subtract_stiffness<1>(programme, u, i, sums);
  });
  for (Index pair = 0; pair < programme.A.rows(); ++pair)
    for (RowMatrix::InnerIterator entry(programme.A, pair); entry; ++entry)
      sums[at(entry.col())].add_product(-entry.value(), solution.force(pair));
  VectorXd residual(programme.load.size());
  for (Index i = 0; i < residual.size(); ++i) residual(i) = sums[at(i)].value();
  return residual;
}

// The gap of a pair has one row of A. The rigid part of u stays in: a motion of a whole body
// changes gaps, although it strains nothing. Forces have no part in it, because a gap is a matter
// of places alone. A far body has large displacements that cancel, and exact sums keep what is
// left.
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
