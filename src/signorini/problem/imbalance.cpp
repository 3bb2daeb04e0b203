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

/// The largest sqrt(K_ii) |u_i| of all unknowns, or with equations of those that K joins with each one; the others then leave
/// rounding of u, which has two parts.
VectorXd stretches(const QuadraticProgramme& programme, const VectorXd& own, bool equations) {
  VectorXd stretch = VectorXd::Constant(own.size(), largest(own));
  if (!equations) return stretch;
  const QuadraticProgramme free{programme.stiffness, programme.load, RowMatrix(0, own.size()), {}};
  for (const SystemParts& parts : unconnected_systems(free, {}, {}, epsilon))
    stretch(parts.unknowns)
        .setConstant(std::max(epsilon * largest(own), largest(own(parts.unknowns))));
  return stretch;
}

/// What every unknown has itself.
VectorXd own_forces(const QuadraticProgramme& programme, const PrimalDual& solution,
                    bool equations) {
  const VectorXd root = programme.stiffness.diagonal().cwiseMax(0.0).cwiseSqrt();
  VectorXd own = programme.load.cwiseAbs();
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

/// Of a combination of equations, what each unknown feels of it over what the unknown has.
/// \return the second largest share over the largest, and the unknown with that; infinity if nothing feels it
std::pair<double, Index> most_felt(VectorXd share) {
  Index unknown = 0;
  const double most = share.maxCoeff(&unknown);
  if (!(most > 0)) return {std::numeric_limits<double>::infinity(), unknown};
  share(unknown) = 0;
  return {share.maxCoeff() / most, unknown};
}

/// Takes from the columns of E, combinations of equations, what they have of an unknown by one that has it. What is left of an
/// entry is 0 where it may be rounding.
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

/// What remains of a residual when forces of the equations take it, one unknown after the other, to those that feel less of it,
/// each measured by what it has. \param E  the equations as columns
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

double own_imbalance(const QuadraticProgramme& programme, const PrimalDual& solution,
                     const VectorXd& residual, Index equations) {
  const VectorXd own = own_forces(programme, solution, equations > 0);
  if (equations == 0) return largest(residual.cwiseQuotient(own));
  return rebalanced(MatrixXd(programme.A.topRows(equations).transpose()), own, residual);
}

}  // namespace signorini
