#include "addons/estimate/dual.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "signorini/core/errors.hpp"
#include "signorini/scene/motions.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

ActiveSet set_of(const Solution& solution, const ScaledProblem& scaled) {
  const ContactState& contact = solution.contact;
  require_input(contact.report.status == SolveStatus::Solved,
                "estimate: the problem is not solved: ", to_string(contact.report.status));
  return active_set(contact.contact_status, scaled.law);
}

}  // namespace

Dual::Dual(const Model& model, const Condensed& condensed, const Solution& solution)
    : model_(model),
      condensed_(condensed),
      solution_(solution),
      scaled_(equilibrate(condensed.problem)),
      set_(set_of(solution, scaled_)) {
  const auto unique = [](bool holds) {
    require_input(
        holds,
        "estimate: the contact forces of the closed pairs are not unique, as where there are more "
        "of them than "
        "nodes to press on, and have no error that could be estimated; use the gap operator "
        "mortar, or fewer points");
  };
  if (slides()) {
    transposed_ = LuFactor(active_set_matrix(scaled_, set_.closed, set_).transpose());
    unique(transposed_.rcond() > std::numeric_limits<double>::epsilon());
  } else {
    system_ = active_set_system(scaled_, set_);
    unique(system_->rows.size() == set_.closed.size());
    set_.closed = system_->rows;
  }
}

std::pair<VectorXd, VectorXd> Dual::forces(const VectorXd& top, const VectorXd& bottom) const {
  const VectorXd scale = scaled_.scale(set_.closed);
  const VectorXd scaled_bottom =
      bottom.size() > 0 ? VectorXd(scaled_.inverse.transpose() * bottom) : bottom;
  VectorXd force, amplitude;
  if (system_) {
    std::tie(force, amplitude) = system_->solve(scale.cwiseProduct(top), scaled_bottom);
  } else {
    VectorXd right(top.size() + scaled_bottom.size());
    right << scale.cwiseProduct(top), scaled_bottom;
    const VectorXd both = transposed_.solve(right);
    force = both.head(top.size());
    amplitude = both.tail(scaled_bottom.size());
  }
  return {scale.cwiseProduct(force),
          bottom.size() > 0 ? VectorXd(scaled_.inverse * amplitude) : amplitude};
}

DualSolution Dual::solve(const GoalGradient& goal, Ledger& ledger) const {
  const QuadraticProgramme& programme = model_.programme;
  const std::vector<Index>& rows = set_.closed;
  const Eigen::MatrixXd modes = mode_shapes(model_.modes);
  DualSolution dual{VectorXd::Zero(programme.load.size()), VectorXd::Zero(programme.A.rows()),
                    VectorXd::Zero(programme.load.size())};
  const auto solve = [&](const VectorXd& load) {
    ledger.count("solves", 1);
    return condensed_.factor.solve(load);
  };
  VectorXd missing = VectorXd::Zero(programme.A.rows());  // A z - w so far
  VectorXd bottom = VectorXd::Zero(modes.cols());
  if (goal.displacement.size() > 0) {
    dual.displacement = solve(goal.displacement);
    missing = programme.A * dual.displacement;
    if (modes.cols() > 0) bottom = -modes.transpose() * goal.displacement;
  }
  if (goal.force.size() > 0) missing -= goal.force;
  for (const SlidingPair& pair : set_.sliding) {
    const double slope = pair.slope * scaled_.scale(pair.slip) / scaled_.scale(pair.gap);
    missing(pair.gap) += slope * missing(pair.slip);
  }
  const VectorXd top = missing(rows);
  if (rows.empty()) return dual;
  const auto [force, amplitude] = forces(top, bottom);
  dual.force(rows) = force;
  dual.displacement -= solve(programme.A.transpose() * dual.force);
  if (modes.cols() > 0) dual.rigid = modes * amplitude;
  return dual;
}

double Dual::force_to_close(Index pair) const {
  const ContactProblem& problem = condensed_.problem;
  const std::vector<Index>& rows = set_.closed;
  double flexibility = problem.compliance(pair, pair);
  if (!rows.empty()) {
    const VectorXd coupling = problem.compliance.col(pair)(rows);
    const VectorXd carried =
        problem.rigid.cols() > 0 ? VectorXd(problem.rigid.row(pair).transpose()) : VectorXd();
    const auto [force, amplitude] = forces(-coupling, -carried);
    flexibility += coupling.dot(force);
    if (carried.size() > 0) flexibility += carried.dot(amplitude);
  }
  return -solution_.contact.gap(pair) / flexibility;
}

double Dual::gap_without(Index pair) const {
  const std::vector<Index>& rows = set_.closed;
  const auto found = std::find(rows.begin(), rows.end(), pair);
  require_argument(found != rows.end(), "gap_without: pair ", pair, " is not closed");
  VectorXd unit = VectorXd::Zero(static_cast<Index>(rows.size()));
  const Index own = found - rows.begin();
  unit(own) = 1;
  const VectorXd bottom = VectorXd::Zero(condensed_.problem.rigid.cols());
  return -solution_.contact.force(pair) / forces(unit, bottom).first(own);
}

}  // namespace signorini
