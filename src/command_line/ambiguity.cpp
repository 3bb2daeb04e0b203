#include "command_line/ambiguity.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "addons/checks/undetermined.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index, Eigen::VectorXd;

/// Largest differences between accepted outcomes, over the largest numbers [-].
struct Agreement {
  int outcomes = 0;
  double forces = 0;
  double movements = 0;
};

/// Larger differences show in the digits that are read.
constexpr double seen = 1e-6;

double difference(const VectorXd& a, const VectorXd& b, double size) {
  if (a.size() != b.size() || a.size() == 0) return 0;
  return ratio(largest(a - b), std::max({size, largest(a), largest(b)}));
}

Agreement agreement(const std::vector<Outcome>& outcomes, double length) {
  Agreement found;
  const Outcome* const first = best(outcomes);
  for (const Outcome& other : outcomes) {
    if (!other.accepted) continue;
    ++found.outcomes;
    const double size = std::max(largest(first->force), largest(first->friction));
    for (const auto part : {&Outcome::force, &Outcome::friction})
      found.forces = std::max(found.forces, difference(first->*part, other.*part, size));
    for (const auto part : {&Outcome::gap, &Outcome::slip, &Outcome::unknowns})
      found.movements = std::max(found.movements, difference(first->*part, other.*part, length));
  }
  return found;
}

/// The pair of a row, friction forces being the last.
Index pair_of(const Outcome& outcome, Index row, Index pairs) {
  return row < pairs ? row : outcome.frictional_pairs[static_cast<std::size_t>(row - pairs)];
}

/// Forces of more rows are not printed, only written as JSON.
constexpr Index largest_told = 30;

std::string bound(double value) { return number(value, "%.12g"); }

}  // namespace

std::vector<ForceRange> ranges_of(const std::vector<SharedForces>& groups) {
  std::vector<ForceRange> all;
  for (const SharedForces& group : groups)
    all.insert(all.end(), group.forces.begin(), group.forces.end());
  return all;
}

std::vector<ForceRange> undetermined_multipliers(const OneSided& form,
                                                 const DenseSolution& solution) {
  const DenseProgramme& programme = form.programme;
  const VectorXd& force = solution.refined.force;
  std::vector<ContactStatus> statuses = statuses_of(solution.active, force.size());
  for (Index row = 0; row < force.size(); ++row)
    if (force(row) != 0) statuses[static_cast<std::size_t>(row)] = ContactStatus::Stick;
  const QuadraticProgramme rows{programme.stiffness.sparseView(), programme.load,
                                programme.A.sparseView(), programme.initial_gap};
  Carried carrying = carried(rows, solution.refined, {}, std::move(statuses));
  carrying.equations = programme.equations;
  std::vector<ForceRange> all = ranges_of(undetermined_forces(carrying));
  for (ForceRange& range : all) {
    const auto [row, sign] = form.rows[static_cast<std::size_t>(range.row)];
    range = sign > 0 ? ForceRange{row, range.low, range.high}
                     : ForceRange{row, 0 - range.high, 0 - range.low};
  }
  return all;
}

void print_undetermined(std::ostream& out, const Outcome& outcome, Index pairs,
                        const std::string& what) {
  if (outcome.undetermined.empty()) return;
  const std::size_t count = outcome.undetermined.size();
  out << count << (count == 1 ? " force is" : " forces are")
      << " not determined: others give the same certificate\n";
  Index told = 0;
  for (const ForceRange& range : outcome.undetermined) {
    if (++told > largest_told) break;
    const bool normal = range.row < pairs;
    const Index row = pair_of(outcome, range.row, pairs);
    out << "  " << (normal ? what : "friction force of pair") << ' ' << row + 1;
    if (std::isnan(range.low))
      out << ": how far was not looked for\n";
    else
      out << ": from " << bound(range.low) << " to " << bound(range.high) << '\n';
  }
  if (told > largest_told) out << "  and so on, all with --json\n";
}

void write_undetermined(Json& json, const Outcome& outcome, Index pairs) {
  json.key("undetermined").array();
  for (const ForceRange& range : outcome.undetermined) {
    const bool normal = range.row < pairs;
    const Index row = pair_of(outcome, range.row, pairs);
    json.object().key("number").value(row + 1).key("of").value(normal ? "force" : "friction");
    json.key("least").value(range.low).key("largest").value(range.high).end();
  }
  json.end();
}

void print_agreement(std::ostream& out, const std::vector<Outcome>& outcomes, double length) {
  const Agreement found = agreement(outcomes, length);
  if (found.outcomes < 2) return;
  out << found.outcomes << " accepted solvers differ by " << number(found.forces, "%.1e")
      << " of the largest force and " << number(found.movements, "%.1e")
      << " of the largest movement";
  if (found.movements > seen)
    out << ": there are several solutions";
  else if (found.forces > seen)
    out << ": the forces are not determined";
  out << '\n';
}

void write_agreement(Json& json, const std::vector<Outcome>& outcomes, double length) {
  const Agreement found = agreement(outcomes, length);
  if (found.outcomes < 2) return;
  json.key("differences").object().key("solvers").value(static_cast<Index>(found.outcomes));
  json.key("force").value(found.forces).key("movement").value(found.movements).end();
}

}  // namespace command_line
