// Everything is recomputed from the data of the problem.
#include "support/classes/checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"

namespace signorini_test {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

std::string differs(const char* what, const VectorXd& got, const VectorXd& known, double otherwise,
                    double accuracy) {
  if (known.size() == 0) return {};
  const double size = known.isZero(0) ? otherwise : known.cwiseAbs().maxCoeff();
  const double error = (got - known).cwiseAbs().maxCoeff();
  return error <= accuracy * size ? "" : text(what, " is wrong by ", error, " of ", size);
}

namespace {

/// G y in twice the working precision.
VectorXd product(const Eigen::MatrixXd& G, const VectorXd& y) {
  VectorXd result(G.rows());
  for (Index i = 0; i < G.rows(); ++i) {
    ExactSum sum;
    for (Index j = 0; j < G.cols(); ++j) sum.add_product(G(i, j), y(j));
    result(i) = sum.value();
  }
  return result;
}

/// The certificate of a problem without symmetry: each row against the sizes of its own terms.
double worst(const ContactProblem& problem, const ContactState& state) {
  if (is_symmetric(problem)) return certify(problem, state).worst();
  const VectorXd gap = product(problem.compliance, state.force) + problem.free_gap;
  const VectorXd size =
      problem.compliance.cwiseAbs() * state.force.cwiseAbs() + problem.free_gap.cwiseAbs();
  const double largest = std::max(state.force.cwiseAbs().maxCoeff(), 1e-300);
  double error = 0;
  for (Index i = 0; i < gap.size(); ++i) {
    const double length = std::max(size(i), 1e-300);
    error = std::max({error, -gap(i) / length, -state.force(i) / largest,
                      std::abs(gap(i) - state.gap(i)) / length,
                      std::abs(gap(i) / length * state.force(i) / largest)});
  }
  return error;
}

/// Forces and gaps in one unit, pair by pair, against what is known.
std::string check_known(const Instance& instance, const ContactState& state) {
  const VectorXd root = instance.problem.compliance.diagonal().unaryExpr(
      [](double g) { return g > 0 ? std::sqrt(g) : 1.0; });
  const double size = instance.problem.free_gap.cwiseQuotient(root).cwiseAbs().maxCoeff();
  const bool forces = instance.force.size() > 0;
  const std::string wrong = differs(
      "force", state.force.cwiseProduct(root),
      forces ? VectorXd(instance.force.cwiseProduct(root)) : VectorXd(), size, instance.accuracy);
  if (!wrong.empty() || instance.gap.size() == 0) return wrong;
  return differs("gap", state.gap.cwiseQuotient(root), instance.gap.cwiseQuotient(root), size,
                 instance.accuracy);
}

}  // namespace

std::string check_solved(const Instance& instance, const ContactState& state) {
  const Index n = instance.problem.free_gap.size();
  if (state.force.size() != n || state.gap.size() != n)
    return text("says solved, but returns ", state.force.size(), " forces and ", state.gap.size(),
                " gaps for ", n, " pairs");
  if (n == 0) return {};
  if (!state.force.allFinite() || !state.gap.allFinite()) return "says solved with no numbers";
  const double error = worst(instance.problem, state);
  if (!(error <= certificate_tolerance)) return text("says solved, but its certificate is ", error);
  if (state.force.minCoeff() < 0 || state.gap.minCoeff() < 0)
    return "says solved, but returns a negative force or gap";
  for (std::size_t k = 0; k < state.active.size(); ++k)
    if (state.gap(state.active[k]) != 0 || (k > 0 && state.active[k] <= state.active[k - 1]))
      return "lists pairs as closed that are open, or lists them without order";
  return check_known(instance, state);
}

std::string check_farkas(const ContactProblem& problem, const VectorXd& y) {
  const Index n = problem.free_gap.size();
  if (y.size() != n) return text("proves infeasibility with ", y.size(), " numbers for ", n);
  if (!y.allFinite() || y.minCoeff() < 0) return "proves infeasibility with a negative weight";
  const double rounding = 1e3 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  const bool symmetric = is_symmetric(problem);
  const VectorXd moved = product(problem.compliance.transpose(), y);
  const VectorXd root = problem.compliance.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd size = symmetric ? VectorXd(root * root.dot(y))  // |G_ij| <= root_i root_j
                                  : VectorXd(problem.compliance.cwiseAbs().transpose() * y);
  for (Index i = 0; i < n; ++i)
    if ((symmetric ? std::abs(moved(i)) : moved(i)) > rounding * size(i))
      return text("proves infeasibility with a y that moves pair ", i, " by ", moved(i));
  const double work = problem.free_gap.dot(y);
  if (work < -rounding * problem.free_gap.cwiseAbs().dot(y)) return {};
  return text("proves infeasibility with d.y = ", work);
}

std::string check_feasible(const Certificate& certificate) {
  const double error =
      std::max({certificate.penetration, certificate.tension, certificate.equilibrium});
  return error <= certificate_tolerance ? ""
                                        : text("says feasible, but overlaps or pulls by ", error);
}

}  // namespace signorini_test
