// # What contact does in sum
//
// A table of pairs answers where a body is pressed, a sum answers how strongly. The forces of all
// pairs add up to one force and one moment about the origin,
// \f[ F = \sum_i \left(\lambda_i n_i + \tau_i t_i\right), \qquad M = \sum_i x_i \times \left(\lambda_i n_i + \tau_i t_i\right) + \dots, \f]
// with the normal n out of the target and the tangent \f$ t = (n_y, -n_x) \f$. They act on the
// source, and the opposite ones on the target. The dots stand for what a pair knows of its own
// moment: if it is a mean of several points, its force does not act exactly at its position.
//
// With the loads and the forces of the supports these sums are in balance. A reader can check that
// by hand.

#include "signorini/report/pressure_table.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "signorini/report/pair_columns.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// Adds the force of a pair and its moments. \param tangent  0 along the normal, 1 along the tangent
//
// In axial symmetry a pair stands for a whole circle. Radial forces cancel around it, and so do the
// moments; only the force along the axis is left.
void add_force(const Pairs& pairs, Index pair, int tangent, double force, bool axial,
               Resultants& sum) {
  const Eigen::Vector2d n = pairs.normal.row(pair).transpose();
  Eigen::Vector2d f = force * (tangent == 0 ? n : Eigen::Vector2d(n.y(), -n.x()));
  if (axial) f.x() = 0;
  sum.force += f;
  if (axial) return;
  const double here = pairs.position(pair, 0) * f.y() - pairs.position(pair, 1) * f.x();
  sum.moment += here + force * pairs.moment(pair, tangent);
  sum.target_moment += -here + force * pairs.target_moment(pair, tangent);
}

// Adds every pair to the sum that it belongs to. \param sum_of  gives that of a pair
// One walk over the pairs serves all sums: the caller says to which sum a pair belongs.
//
// Normal force and shear force are sums of numbers and not of vectors. Around a curved boundary the
// normal force is larger than the force F without friction, because parts of F cancel.
template <typename SumOf>
void add_pairs(const Model& model, const Solution& solution,
               const std::optional<PathTotals>& totals, const SumOf& sum_of) {
  check_solved(solution, totals, "resultants");
  const Pairs& pairs = model.pairs;
  const ContactState& contact = solution.contact;
  const bool axial = std::any_of(model.bodies.begin(), model.bodies.end(), is_axial);
  for (Index pair = 0; pair < contact.force.size(); ++pair) {
    Resultants& sum = sum_of(pair);
    add_force(pairs, pair, 0, contact.force(pair), axial, sum);
    sum.normal_force += contact.force(pair);
    const double pressure = solution.pressure(pair);  // of a tie that is torn all are negative
    sum.peak_pressure = sum.pairs == 0 ? pressure : std::max(sum.peak_pressure, pressure);
    ++sum.pairs;
  }
  const Eigen::VectorXd lost = dissipated(contact);
  for (Index k = 0; k < lost.size(); ++k) {
    const Index pair = contact.frictional_pairs[static_cast<std::size_t>(k)];
    const ContactStatus contact_status = status_of_slip(contact, k);
    Resultants& sum = sum_of(pair);
    add_force(pairs, pair, 1, contact.friction(k), axial, sum);
    sum.shear_force += contact.friction(k);
    sum.dissipated += lost(k);
    sum.dissipated_total += totals ? totals->dissipation(k) : lost(k);
    ++sum.frictional_pairs;
    sum.stick += contact_status == ContactStatus::Stick ? 1 : 0;
    sum.slide += friction_sign(contact_status) != 0 ? 1 : 0;
  }
  for (const Index pair : contact.active()) {
    sum_of(pair).closed_weight += pairs.weight(pair);
    ++sum_of(pair).closed;
  }
}

// What a person reads of a sum is one line in front of the table. What friction adds is not
// mentioned without friction.
// If two pairs at x = 0 and x = 10, each with the weight 10, carry the forces 3 and 5 upwards, the
// line is
//
//     # force on the sources (0, 8), moment about the origin 50, closed boundary 20, peak pressure 0.5
// The total work of sliding is told if it is not that of this step.
void write_comment(std::ostream& out, const std::string& what, const Resultants& sum) {
  out << "# " << what << " (" << sum.force.x() << ", " << sum.force.y()
      << "), moment about the origin " << sum.moment << ", closed boundary " << sum.closed_weight
      << ", peak pressure " << sum.peak_pressure;
  if (sum.frictional_pairs > 0)
    out << ", normal force " << sum.normal_force << ", shear force " << sum.shear_force << ", open "
        << sum.frictional_pairs - sum.stick - sum.slide << ", stick " << sum.stick << ", slide "
        << sum.slide << ", dissipated " << sum.dissipated;
  if (sum.frictional_pairs > 0 && sum.dissipated_total != sum.dissipated)
    out << ", in total " << sum.dissipated_total;
  out << '\n';
}

// A comment ends with its line. A name that a program has given may have an end of a line in it, and
// what stands behind that would be a row of the table: it becomes a blank.
std::string on_one_line(std::string words) {
  std::replace_if(
      words.begin(), words.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return words;
}

}  // namespace

// All pairs into one sum.
Resultants resultants(const Model& model, const Solution& solution,
                      const std::optional<PathTotals>& totals) {
  Resultants sum{Eigen::Vector2d::Zero(), 0, 0, 0};
  add_pairs(model, solution, totals, [&](Index /*pair*/) -> Resultants& { return sum; });
  if (totals) sum.dissipated_total += totals->elsewhere.sum();
  return sum;
}

// A sum for each contact.
// The pair knows its contact by number, and the sums have the order of the names in the model. A
// contact that is open everywhere has a sum, too: zero.
std::vector<Resultants> resultants_of_contacts(const Model& model, const Solution& solution,
                                               const std::optional<PathTotals>& totals) {
  std::vector<Resultants> sums(model.contacts.size(), Resultants{Eigen::Vector2d::Zero(), 0, 0, 0});
  add_pairs(model, solution, totals, [&](Index pair) -> Resultants& {
    return sums[model.contact_of[static_cast<std::size_t>(pair)]];
  });
  for (Index k = 0; totals && k < totals->elsewhere.size(); ++k)
    sums[static_cast<std::size_t>(k)].dissipated_total += totals->elsewhere(k);
  return sums;
}

// Notes of the solution and sums come first, as comments, which gnuplot passes over. Then the
// columns.
// One contact without friction has one line of sums; several have one for all and one each. With
// friction even a single contact is named.
std::string pressure_csv(const Model& model, const Solution& solution, const std::string& tolerance,
                         const std::optional<PathTotals>& totals) {
  const std::vector<PairColumn> columns = pair_columns(model, solution, totals);
  const Resultants sum = resultants(model, solution, totals);
  std::ostringstream out;
  out << std::setprecision(10);
  if (!tolerance.empty()) out << "# tolerance " << tolerance << '\n';
  for (const std::string& note : solution.notes) out << "# note " << on_one_line(note) << '\n';
  const bool several = model.contacts.size() > 1;
  const bool named = several || sum.frictional_pairs > 0;
  if (several || !named) write_comment(out, "force on the sources", sum);
  if (named) {
    const std::vector<Resultants> each = resultants_of_contacts(model, solution, totals);
    for (std::size_t k = 0; k < each.size(); ++k)
      write_comment(out, on_one_line("contact " + model.contacts[k] + ": force on the source"),
                    each[k]);
  }
  return out.str() + csv_head(columns) + csv_lines(columns);
}

}  // namespace signorini
