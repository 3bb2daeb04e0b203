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
// The load 1e6 and the stiffness 1e9 beside an unknown with the load 1e-9 and the stiffness 1e-6: a
// residual of 1e-12 is a share of 1e-18 of the first, and of 1e-3 of the second.

#include "signorini/problem/imbalance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/systems.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
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

}  // namespace

// Most programmes have no equations. Who brings some says how their forces come in.
double own_imbalance(const QuadraticProgramme& programme, const PrimalDual& solution,
                     const VectorXd& residual, const VectorXd& diagonal,
                     const EquationRows& equations) {
  const VectorXd own = own_forces(programme, solution, diagonal, equations.count > 0);
  if (equations.count == 0) return largest(residual.cwiseQuotient(own));
  return equations.imbalance(MatrixXd(programme.A.topRows(equations.count).transpose()), own,
                             residual);
}

}  // namespace signorini
