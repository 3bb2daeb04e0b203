#include "addons/certified/certified_end.hpp"

#include <cmath>

#include "addons/certified/proofs.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// What of a force works along motions.
VectorXd along(const MatrixXd& motions, const VectorXd& force) {
  const MatrixXd Q = column_span(motions).basis;
  return Q * (Q.transpose() * force);
}

/// K u should do no work along rigid motions, but the entries of K are rounded, and somebody must carry the work that it does. Pairs
/// whose force is no larger than that hold nothing. The motions that are free without them take their part out of the residual.
VectorXd spread(const RefinementData& data, const VectorXd& residual, const VectorXd& force,
                const std::vector<Index>& rows) {
  const VectorXd inner = residual - (data.programme.load - data.programme.A.transpose() * force);
  const VectorXd work = along(data.null_vectors, inner);
  std::vector<Index> holding;
  for (const Index row : rows)
    if (std::abs(force(row)) > work.lpNorm<1>()) holding.push_back(row);
  if (holding.empty()) return residual - work;
  const MatrixXd loose = null_space(data.condensed.rigid(holding, Eigen::all));
  if (loose.cols() == 0) return residual;
  return residual - along(data.null_vectors * loose, inner);
}

/// Refines the best set once more where the certificate sees what rounding of K leaves along rigid motions.
void spread_imbalance(RefinedSets& sets) {
  if (sets.end.certificate.holds() || sets.data.null_vectors.cols() == 0 ||
      sets.end.solution.displacement.size() == 0)
    return;
  sets.data.spread = [&](const VectorXd& residual, const VectorXd& force,
                         const std::vector<Index>& rows) {
    return spread(sets.data, residual, force, rows);
  };
  sets.here.now = sets.end.solution;
  sets.refine(sets.statuses, sets.end.solution.force);
}

/// Says what the pairs do by what they do: a set whose equations depend on each other, or contradict each
/// other by as little as the certificate allows, need not be that of its numbers.
void read_off(RefinedSets& sets) {
  const std::vector<ContactStatus> taken = sets.statuses;
  const PrimalDual& solution = sets.end.solution;
  predict(sets.data.scaled,
          scaled_numbers(sets.data, solution, sets.best.movement, certificate_tolerance), 1,
          sets.statuses);
  // With cohesion a pair that nothing presses carries shear all the same: it is closed.
  const FrictionLaw& law = sets.data.condensed.law;
  const VectorXd friction = solution.force.tail(law.coefficient.size());
  for (Index k = 0; k < friction.size(); ++k) {
    const std::size_t pair = at(law.pair[at(k)]);
    if (sets.statuses[pair] == ContactStatus::Open && friction(k) != 0)
      sets.statuses[pair] = taken[pair];
  }
}

/// Whether most of what the end lacks of equilibrium is along rigid motions.
bool rigid_motions_work(const RefinedSets& sets) {
  const MatrixXd& modes = sets.data.null_vectors;
  Certificate others = sets.end.certificate;
  others.equilibrium = others.duality_gap = 0;
  if (modes.cols() == 0 || !others.holds()) return false;
  const VectorXd left = equilibrium_residual(sets.data.programme, sets.end.solution);
  return largest(along(modes, left)) > 0.5 * largest(left);
}

}  // namespace

void conclude(RefinedSets& sets, CertifiedSolution& end) {
  spread_imbalance(sets);
  const QuadraticProgramme& programme = sets.data.programme;
  const FrictionLaw& law = sets.data.condensed.law;
  ContactState& state = end.state;
  if (end.certificate.holds()) {
    if (!sets.confirmed) read_off(sets);
    drop_tension(programme, law, end);
    end.force_uncertainty = force_uncertainty(sets.data, sets.best, end.solution, sets.statuses);
    state.report.status = SolveStatus::Solved;
    state.reason.clear();
    state.unbounded_direction.resize(0);
    state.farkas_certificate.resize(0);
  } else if (state.farkas_certificate.size() > 0 &&
             !proves_infeasible(programme, state.farkas_certificate, sets.here.now.displacement)) {
    state.report.status = SolveStatus::Breakdown;
    state.farkas_certificate.resize(0);
  } else if (state.report.status == SolveStatus::Solved) {
    state.report.status = SolveStatus::Breakdown;
    state.reason =
        rigid_motions_work(sets)
            ? "rounding of the stiffness pushes along rigid motions, by more of the load than a "
              "certificate allows; hold the bodies by a support or a soft spring"
            : "the forces and displacements found do not fit the original data";
  }
  if (state.report.status == SolveStatus::Breakdown && state.reason.empty())
    state.reason =
        "the method ended without a solution, and what the pairs did last does not fit the data";
  if (sets.statuses.empty() && sets.best.movement.size() == 0) return;
  fill_state(law, sets.statuses, end.solution.force, sets.best.movement, state);
}

}  // namespace signorini
