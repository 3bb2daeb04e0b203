// # A solution that was expected
//
// Between two loads of a path that go on in proportion everything is linear until a pair changes, and u and its forces can be
// foretold with all their digits. Say the forces 2 and 4 at loads of 1 and 2 foretell 6 at the load 3, but a neighbour closes
// on the way and takes a part of it. Its overlap is what the foretold u leaves, and one solve of the system says which forces
// close it.

#include "addons/certified/expected_end.hpp"

#include <memory>
#include <utility>

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Adds to the forces what closes gaps h of the rows of a system.
void close(const ActiveSetSystem& system, const VectorXd& scale, const VectorXd& h, PrimalDual& u) {
  const VectorXd closes = system.solve(-scale.cwiseProduct(h), VectorXd(0)).first;
  for (std::size_t k = 0; k < system.rows.size(); ++k) {
    const Index row = system.rows[k], at_k = static_cast<Index>(k);
    add_to(u.force(row), u.force_low(row), scale(at_k) * closes(at_k));
  }
}

/// Forces that the statuses exclude are dropped, and those of pairs that slide take their bound. The compliance gives the change of
/// the gaps; the change is small, so that errors of the compliance do not matter. Forces that change by rounding only need no solve. If
/// there is one, it takes along what was out of balance.
RefinedSolution corrected_once(const RefinementData& data, PrimalDual expected,
                               const std::vector<ContactStatus>& statuses) {
  const ActiveSet set = active_set(statuses, data.condensed.law);
  RefinedSolution result;
  result.solution = std::move(expected);
  result.system = std::make_shared<const ActiveSetSystem>(
      active_set_system(data.scaled, active_set(statuses, data.scaled.law)));
  const std::vector<Index>& rows = result.system->rows;
  PrimalDual& u = result.solution;
  const VectorXd last = u.force, last_low = u.force_low;
  const auto changed = [&] { return VectorXd((u.force - last) + (u.force_low - last_low)); };
  impose(set, u.force, u.force_low);
  const VectorXd h = gaps(data.programme, u) + data.condensed.compliance * changed();
  close(*result.system, data.scaled.scale(rows), h(rows), u);
  impose(set, u.force, u.force_low);
  for (const Index row : rows)  // a row that supports prescribe keeps no force
    if (data.programme.A.row(row).norm() == 0) u.force(row) = u.force_low(row) = 0;
  if (is_felt(data, u, changed())) {
    const VectorXd left =
        equilibrium_residual(data.programme, u) - data.programme.A.transpose() * u.force_low;
    add_displacement(u, data.solve_stiffness(left));
    result.solves = 1;
  }
  result.movement = gaps(data.programme, u);
  result.settled = true;
  return result;
}

}  // namespace

bool ends_as_expected(const std::vector<ContactStatus>& of, PrimalDual expected, RefinedSets& sets) {
  sets.here.last = corrected_once(sets.data, std::move(expected), of);
  constexpr double reserve = 0.1;  // so that errors of many steps do not add up to more than a certificate lets pass
  return sets.take(of).confirmed && sets.end.certificate.worst() <= reserve * certificate_tolerance;
}

}  // namespace signorini
