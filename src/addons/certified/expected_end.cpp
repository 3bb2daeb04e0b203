// # A solution that was expected
//
// Between two loads of a path that go on in proportion everything is linear until a pair changes, and u and its forces can be
// foretold with all their digits. If the forces 2 and 4 at loads of 1 and 2 foretell 6 at the load 3, no gap is left there, and
// nothing is to be done. If a neighbour has closed on the way, it overlaps in the foretold u, and closing it takes other forces: then
// the expectation was wrong, and the step is solved as any other. To correct it would take as many solves.

#include "addons/certified/expected_end.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// How other forces have to be than expected, for what the pairs do: those that the statuses exclude are dropped, those of pairs that
/// slide take their bound, and the others close the gaps that are left.
VectorXd other_forces(const RefinementData& data, const ActiveSet& set, const ActiveSetSystem& system,
                      const VectorXd& movement, const PrimalDual& expected) {
  VectorXd force = expected.force, low = expected.force_low;
  impose(set, force, low);
  const VectorXd dropped = (force - expected.force) + (low - expected.force_low);
  const VectorXd scale = data.scaled.scale(system.rows);
  const VectorXd h = (movement + data.condensed.compliance * dropped)(system.rows);
  VectorXd other = dropped;
  other(system.rows) += scale.cwiseProduct(system.solve(-scale.cwiseProduct(h), VectorXd(0)).first);
  return other;
}

/// Whether a change of forces is rounding of as many numbers as rows are closed, of forces and of what they move: see Corrections.
bool is_rounding(const RefinementData& data, const PrimalDual& u, const VectorXd& change, std::size_t closed) {
  const double moved = relative(data.condensed.compliance * change, u.displacement);
  return std::max(relative(change, u.force), moved) <= epsilon * static_cast<double>(closed + 1);
}

}  // namespace

bool ends_as_expected(const std::vector<ContactStatus>& of, const PrimalDual& expected, RefinedSets& sets) {
  constexpr double reserve = 0.1;  // so that errors of many steps do not add up to more than a certificate lets pass
  const RefinementData& data = sets.data;
  const ActiveSet set = active_set(of, data.condensed.law);
  const auto system = std::make_shared<const ActiveSetSystem>(
      active_set_system(data.scaled, active_set(of, data.scaled.law)));
  RefinedSolution last{expected, gaps(data.programme, expected), {}, system};
  last.settled = is_rounding(data, expected, other_forces(data, set, *system, last.movement, expected),
                             set.closed.size());
  if (!last.settled) return false;
  const RefinedSets::Place start = sets.here;
  sets.here.last = std::move(last);
  if (sets.take(of).confirmed && sets.end.certificate.worst() <= reserve * certificate_tolerance)
    return true;
  sets.here = start;
  sets.statuses.clear();
  sets.confirmed = false;
  return false;
}

}  // namespace signorini
