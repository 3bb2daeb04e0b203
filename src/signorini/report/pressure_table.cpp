#include "signorini/report/pressure_table.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;

void check_solved(const Solution& solution) {
  require(solution.contact.report.status == Status::Solved,
          "pressure table: the problem was not solved (", to_string(solution.contact.report.status),
          ')');
}

}  // namespace

Resultants resultants(const Pairs& pairs, const Solution& solution) {
  check_solved(solution);
  Resultants sum{Eigen::Vector2d::Zero(), 0, 0, 0};
  const ContactState& contact = solution.contact;
  const auto add = [&](Index pair, const Eigen::Vector2d& force) {
    sum.force += force;
    sum.moment += pairs.position(pair, 0) * force.y() - pairs.position(pair, 1) * force.x();
  };
  for (Index pair = 0; pair < contact.force.size(); ++pair) {
    add(pair, contact.force(pair) * pairs.normal.row(pair).transpose());
    sum.peak_pressure = std::max(sum.peak_pressure, solution.pressure(pair));
  }
  for (std::size_t k = 0; k < contact.rubbing.size(); ++k) {
    const auto normal = pairs.normal.row(contact.rubbing[k]);
    add(contact.rubbing[k],
        contact.friction(static_cast<Index>(k)) * Eigen::Vector2d(normal.y(), -normal.x()));
  }
  for (const Index pair : solution.contact.active) sum.closed_weight += pairs.weight(pair);
  return sum;
}

std::string pressure_csv(const Pairs& pairs, const Solution& solution,
                         const std::string& tolerance) {
  check_solved(solution);
  std::vector<const char*> status(static_cast<std::size_t>(solution.contact.force.size()), "open");
  for (const Index pair : solution.contact.active)
    status[static_cast<std::size_t>(pair)] = "closed";
  std::ostringstream out;
  if (!tolerance.empty()) out << "# tolerance " << tolerance << '\n';
  for (const std::string& note : solution.notes) out << "# note " << note << '\n';
  const Resultants sum = resultants(pairs, solution);
  out << std::setprecision(10) << "# force on the sources (" << sum.force.x() << ", "
      << sum.force.y() << "), moment about the origin " << sum.moment << ", closed boundary "
      << sum.closed_weight << ", peak pressure " << sum.peak_pressure
      << "\nx,y,gap,pressure,force,status\n";
  for (Index pair = 0; pair < solution.contact.force.size(); ++pair)
    out << pairs.position(pair, 0) << ',' << pairs.position(pair, 1) << ','
        << solution.contact.gap(pair) << ',' << solution.pressure(pair) << ','
        << solution.contact.force(pair) << ',' << status[static_cast<std::size_t>(pair)] << '\n';
  return out.str();
}

}  // namespace signorini
