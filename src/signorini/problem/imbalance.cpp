// # Out of balance, unknown by unknown
//
// A residual of 1e-9 is nothing where the load is 1e6. On another unknown of the same body, where
// all forces are of size 1e-9, it is an error of 100 per cent. So each entry of
// \f$ p - Ku - A^T\lambda \f$ is also divided by what its own unknown has: its load, its contact
// forces, and the largest force that displacements could make there.
//
// No term \f$ K_{ji}u_i \f$ exceeds \f$ \sqrt{K_{jj}}\sqrt{K_{ii}}\,|u_i| \f$, because K is
// semidefinite. A stable factorisation leaves rounding of that, and what is larger is an error.
//
// Equations need more care. Let x have the stiffness 1 and the load 1, let z have neither, and let
// z = 0.7 x. The solution is x = 1, z = 0.7, and the equation has the force 0. If it is computed as
// 1e-17, z lacks 1e-17 and has nothing else: its share is 1. But the equation may have any force:
// with 0 in its place z lacks nothing, and what changes at x, 0.7e-17, is compared with the load 1.
// This file hands residuals on in that way before it measures them.

#include "signorini/problem/imbalance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/systems.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// The factor s of \f$ \sqrt{K_{jj}}\,s \f$: the largest \f$ \sqrt{K_{ii}}\,|u_i| \f$. With
// equations it is taken over the unknowns that K joins with j, because an equation may join a soft
// body with a stiff one, and what the stiff one has must not hide errors of the soft one. Of all
// others only the rounding counts, as u has two parts.
VectorXd stretches(const QuadraticProgramme& programme, const VectorXd& own, bool equations) {
  VectorXd stretch = VectorXd::Constant(own.size(), largest(own));
  if (!equations) return stretch;
  const QuadraticProgramme free{programme.stiffness, programme.load, RowMatrix(0, own.size()), {}};
  for (const SystemParts& parts : unconnected_systems(free, {}, {}, epsilon))
    stretch(parts.unknowns)
        .setConstant(std::max(epsilon * largest(own), largest(own(parts.unknowns))));
  return stretch;
}

// What every unknown has itself. Where contact holds everything, u is 0, and the rounding of how
// far load and contact forces would move an unknown takes its place.
VectorXd own_forces(const QuadraticProgramme& programme, const PrimalDual& solution,
                    const VectorXd& diagonal, bool equations) {
  const VectorXd root = diagonal.cwiseMax(0.0).cwiseSqrt();
  VectorXd own = programme.load.cwiseAbs();
  if (programme.reached.terms.size() > 0) own += programme.reached.terms;
  for (Index row = 0; row < programme.A.rows(); ++row)
    for (RowMatrix::InnerIterator entry(programme.A, row); entry; ++entry)
      own(entry.col()) += std::abs(entry.value() * solution.force(row));
  VectorXd stretch = root.cwiseProduct(strained(solution)).cwiseAbs();
  for (Index j = 0; j < own.size(); ++j)
    if (root(j) > 0) stretch(j) = std::max(stretch(j), epsilon * own(j) / root(j));
  own += stretches(programme, stretch, equations).cwiseProduct(root);
  // Below the smallest normal number there are fewer digits.
  return (own.array() + std::numeric_limits<double>::min()).matrix();
}

// Handing a residual on helps if it arrives where it matters less. So of a column of shares two
// numbers count: who feels it most, and how much less the next one feels, relative to that.
std::pair<double, Index> most_felt(VectorXd share) {
  Index unknown = 0;
  const double most = share.maxCoeff(&unknown);
  if (!(most > 0)) return {std::numeric_limits<double>::infinity(), unknown};
  share(unknown) = 0;
  return {share.maxCoeff() / most, unknown};
}

// Gaussian elimination in the equations: once one of them has served an unknown, the others must
// not disturb it again. Rounding that is left of an entry would later be divided by, so it becomes
// 0.
void eliminate(MatrixXd& E, Index pivot, Index unknown) {
  const VectorXd row = E.col(pivot);
  const double rounding = static_cast<double>(E.cols()) * epsilon;
  for (Index i = 0; i < E.cols(); ++i) {
    if (E(unknown, i) == 0) continue;
    const VectorXd taken = E(unknown, i) / row(unknown) * row;
    const VectorXd size = E.col(i).cwiseAbs() + taken.cwiseAbs();
    const VectorXd left = E.col(i) - taken;
    E.col(i) = (left.array().abs() <= rounding * size.array()).select(0.0, left);
    E(unknown, i) = 0;
  }
}

// Takes the unknowns in the order in which it helps most. In the example z is first: its share of
// the equation is about 3e17 times that of x. The result is never worse than without any handing
// on.
double rebalanced(MatrixXd E, const VectorXd& own, VectorXd residual) {
  const double worst = largest(residual.cwiseQuotient(own));
  double rounding = 0;
  for (Index step = 0; step < E.cols(); ++step) {
    std::pair<double, Index> least{std::numeric_limits<double>::infinity(), 0};
    Index equation = -1;
    for (Index i = 0; i < E.cols(); ++i)
      if (const auto now = most_felt(E.col(i).cwiseAbs().cwiseQuotient(own));
          now.first < least.first) {
        least = now;
        equation = i;
      }
    if (equation < 0) break;
    const Index unknown = least.second;
    const double taken = residual(unknown);
    rounding = std::max(rounding, epsilon * std::abs(taken) / own(unknown));
    residual -= taken / E(unknown, equation) * E.col(equation);
    residual(unknown) = 0;
    eliminate(E, equation, unknown);
  }
  const double now = std::max(rounding, largest(residual.cwiseQuotient(own)));
  return now < worst ? now : worst;
}

}  // namespace

// Most programmes have no equations, and nothing is handed on.
double own_imbalance(const QuadraticProgramme& programme, const PrimalDual& solution,
                     const VectorXd& residual, const VectorXd& diagonal, Index equations) {
  const VectorXd own = own_forces(programme, solution, diagonal, equations > 0);
  if (equations == 0) return largest(residual.cwiseQuotient(own));
  return rebalanced(MatrixXd(programme.A.topRows(equations).transpose()), own, residual);
}

}  // namespace signorini
