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
  const Index n = instance.problem.free_gap.size();
  const VectorXd root = instance.problem.compliance.diagonal().head(n).unaryExpr(
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

/// What else is known with friction and rigid modes.
std::string check_effects(const Instance& instance, const ContactState& state) {
  const FrictionLaw& law = instance.problem.law;
  if (state.frictional_pairs != law.pair) return "says solved, but lists other pairs that rub";
  if (state.slip.size() != state.friction.size() ||
      state.friction.size() != static_cast<Index>(law.pair.size()))
    return "says solved, but friction and slips are not those of the pairs that rub";
  if (state.amplitude.size() != instance.problem.resultant.size())
    return "says solved, but has no amplitude for each rigid mode";
  if (!instance.contact_status.empty() && state.contact_status != instance.contact_status)
    return "says solved, but pairs move in other ways";
  std::string wrong = differs("friction", state.friction, instance.friction,
                              state.force.cwiseAbs().maxCoeff(), instance.accuracy);
  if (wrong.empty())
    wrong = differs("amplitude", state.amplitude, instance.amplitude, 1, instance.accuracy);
  if (!wrong.empty() || instance.solutions.empty()) return wrong;
  VectorXd forces(state.force.size() + state.friction.size());
  forces << state.force, state.friction;
  if (std::none_of(instance.solutions.begin(), instance.solutions.end(), [&](const VectorXd& one) {
        return (forces - one).norm() <= instance.accuracy * one.norm();
      }))
    return text("says solved, but is none of the ", instance.solutions.size(), " solutions");
  if (instance.solutions.size() > 1 && state.uniqueness == Uniqueness::Proved)
    return text("proves that there is one solution, but there are ", instance.solutions.size());
  return {};
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
  if (static_cast<Index>(state.contact_status.size()) != n)
    return text("says solved, but returns ", state.contact_status.size(), " statuses for ", n, " pairs");
  for (const Index pair : state.active())
    if (state.gap(pair) != 0) return "says that pairs are closed whose gap is open";
  const std::string wrong = check_known(instance, state);
  return wrong.empty() ? check_effects(instance, state) : wrong;
}

std::string check_farkas(const ContactProblem& problem, const VectorXd& y) {
  const Index n = problem.free_gap.size();
  if (y.size() != n) return text("proves infeasibility with ", y.size(), " numbers for ", n);
  if (!y.allFinite() || y.minCoeff() < 0) return "proves infeasibility with a negative weight";
  const double rounding = 1e3 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  const bool symmetric = is_symmetric(problem);
  const Eigen::MatrixXd G = problem.compliance.topRows(n).transpose();  // its slips too
  const VectorXd moved = product(G, y);
  const VectorXd root = problem.compliance.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd size = symmetric ? VectorXd(root * root.head(n).dot(y))  // |G_ij| <= root_i root_j
                                  : VectorXd(G.cwiseAbs() * y);
  for (Index k = 0; k < problem.rigid.cols(); ++k) {
    const VectorXd mode = problem.rigid.col(k).head(n);
    if (std::abs(mode.dot(y)) > rounding * mode.cwiseAbs().dot(y))
      return text("proves infeasibility with a y that rigid mode ", k, " works on");
  }
  for (Index i = 0; i < moved.size(); ++i)
    if ((symmetric ? std::abs(moved(i)) : moved(i)) > rounding * size(i))
      return text("proves infeasibility with a y that moves pair ", i, " by ", moved(i));
  const double work = problem.free_gap.dot(y);
  if (work < -rounding * problem.free_gap.cwiseAbs().dot(y)) return {};
  return text("proves infeasibility with d.y = ", work);
}

std::string check_unbounded_direction(const ContactProblem& problem, const VectorXd& amplitude) {
  if (amplitude.size() != problem.resultant.size() || !amplitude.allFinite())
    return "proves that the body escapes with no amplitude for each rigid mode";
  const Index n = problem.free_gap.size();
  const VectorXd moved = problem.rigid * amplitude;
  VectorXd least = VectorXd::Zero(n);  // what each gap must open by
  double taken = 0;                    // by cohesion
  for (std::size_t k = 0; k < problem.law.pair.size(); ++k) {
    const Index row = n + static_cast<Index>(k);
    least(problem.law.pair[k]) = problem.law.coefficient(row - n) * std::abs(moved(row));
    taken += problem.law.cohesion(row - n) * std::abs(moved(row));
  }
  // A row may have a unit of its own: beside the largest movement of any row of norm 1.
  const VectorXd norm = problem.rigid.rowwise().norm().cwiseMax(1e-300);
  const double largest = moved.cwiseQuotient(norm).cwiseAbs().maxCoeff();
  const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * largest;
  for (Index i = 0; i < n; ++i)
    if (moved(i) < least(i) - rounding * norm(i))
      return text("proves that the body escapes by a motion that pair ", i, " stops");
  const double work = problem.resultant.dot(amplitude);
  return work < -taken ? "" : text("proves that the body escapes, but its load works ", work);
}

std::string check_feasible(const Certificate& certificate) {
  const double error =
      std::max({certificate.penetration, certificate.tension, certificate.equilibrium});
  return error <= certificate_tolerance ? ""
                                        : text("says feasible, but overlaps or pulls by ", error);
}

}  // namespace signorini_test
