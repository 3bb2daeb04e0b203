#include "signorini/estimate/dual.hpp"

#include <algorithm>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

KnownSet set_of(const Model& model, const Solution& solution) {
  const ContactState& contact = solution.contact;
  pose(contact.report.status == Status::Solved,
       "estimate: the problem is not solved: ", to_string(contact.report.status));
  KnownSet set = known_set(all_motions(contact), model.law);
  pose(set.sliding.empty(), "estimate: ", set.sliding.size(),
       " pairs slide against friction, and errors are estimated only where pairs with friction "
       "stick or are open; "
       "compare with a finer mesh instead, or leave friction out");
  return set;
}

}  // namespace

Dual::Dual(const Model& model, const Condensed& condensed, const Solution& solution)
    : model_(model),
      condensed_(condensed),
      solution_(solution),
      scaled_(equilibrate(condensed.problem)),
      rows_(set_of(model, solution).closed),
      closing_(scaled_, KnownSet{rows_}) {
  pose(closing_.rows().size() == rows_.size(), "estimate: of ", rows_.size(), " closed rows only ",
       closing_.rows().size(),
       " are independent: the contact forces are not unique, as with Gauss points of their own "
       "forces, and have no "
       "error that could be estimated; use the gap operator mortar, or fewer points");
}

std::pair<VectorXd, VectorXd> Dual::forces(const VectorXd& top, const VectorXd& bottom) const {
  const VectorXd scale = scaled_.scale(closing_.rows());
  auto [force, amplitude] =
      closing_.solve(scale.cwiseProduct(top),
                     bottom.size() > 0 ? VectorXd(scaled_.inverse.transpose() * bottom) : bottom);
  return {scale.cwiseProduct(force),
          bottom.size() > 0 ? VectorXd(scaled_.inverse * amplitude) : amplitude};
}

DualSolution Dual::solve(const GoalGradient& goal, Ledger& ledger) const {
  const QuadraticProgramme& programme = model_.programme;
  const std::vector<Index>& rows = closing_.rows();
  const Eigen::MatrixXd modes = mode_shapes(model_.modes);
  DualSolution dual{VectorXd::Zero(programme.load.size()), VectorXd::Zero(programme.A.rows()),
                    VectorXd::Zero(programme.load.size())};
  const auto solve = [&](const VectorXd& load) {
    ledger.count("solves", 1);
    return condensed_.factor.solve(load);
  };
  VectorXd top = VectorXd::Zero(static_cast<Index>(rows.size()));
  VectorXd bottom = VectorXd::Zero(modes.cols());
  if (goal.displacement.size() > 0) {
    dual.displacement = solve(goal.displacement);
    const VectorXd moved = programme.A * dual.displacement;
    top = moved(rows);
    bottom = -modes.transpose() * goal.displacement;
  }
  if (goal.force.size() > 0) top -= goal.force(rows);
  if (rows.empty()) return dual;
  const auto [force, amplitude] = forces(top, bottom);
  dual.force(rows) = force;
  dual.displacement -= solve(programme.A.transpose() * dual.force);
  if (modes.cols() > 0) dual.rigid = modes * amplitude;
  return dual;
}

double Dual::force_to_close(Index pair) const {
  const ContactProblem& problem = condensed_.problem;
  const std::vector<Index>& rows = closing_.rows();
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
  const std::vector<Index>& rows = closing_.rows();
  const auto found = std::find(rows.begin(), rows.end(), pair);
  require(found != rows.end(), "gap_without: pair ", pair, " is not closed");
  VectorXd unit = VectorXd::Zero(static_cast<Index>(rows.size()));
  const Index own = found - rows.begin();
  unit(own) = 1;
  const VectorXd bottom = VectorXd::Zero(condensed_.problem.rigid.cols());
  return -solution_.contact.force(pair) / forces(unit, bottom).first(own);
}

}  // namespace signorini
