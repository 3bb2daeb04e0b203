// Let x have the stiffness 1 and the load 1, let z have neither, and let z = 0.7 x. The solution is x = 1, z = 0.7, and the equation
// has the force 0. If it is computed as 1e-17, z lacks 1e-17 and has nothing else: its share is 1. But the equation may have any
// force: with 0 in its place z lacks nothing, and what changes at x, 0.7e-17, is compared with the load 1.
#include "addons/programme/equation_imbalance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Handing a residual on helps if it arrives where it matters less. So of a column of shares two
/// numbers count: who feels it most, and how much less the next one feels, relative to that.
std::pair<double, Index> most_felt(VectorXd share) {
  Index unknown = 0;
  const double most = share.maxCoeff(&unknown);
  if (!(most > 0)) return {std::numeric_limits<double>::infinity(), unknown};
  share(unknown) = 0;
  return {share.maxCoeff() / most, unknown};
}

/// Gaussian elimination in the equations: once one of them has served an unknown, the others must
/// not disturb it again. Rounding that is left of an entry would later be divided by, so it becomes
/// 0.
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

}  // namespace

// Takes the unknowns in the order in which it helps most. In the example z is first: its share of
// the equation is about 3e17 times that of x. The result is never worse than without any handing
// on.
double equation_imbalance(MatrixXd E, const VectorXd& own, VectorXd residual) {
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

}  // namespace signorini
