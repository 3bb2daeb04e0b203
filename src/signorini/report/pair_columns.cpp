// # What is known of a pair
//
// A pair has a place, a gap, a pressure, a force, and with friction a shear, a slip and a motion.
// Tables, files for viewers and the printed output all list these. They are collected once, as
// columns with a name, a unit and one number per pair, so that everything that lists pairs has the
// same names and the same signs.
//
// A column of words is one of numbers too: the numbers count in a list of words. A pair for which a
// column means nothing has "not a number" there, and an empty cell in a table.

#include "signorini/report/pair_columns.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A number for each frictional pair in the place of those that all pairs have.
// Only some pairs may have friction. The state has their numbers in the order of the frictional
// pairs; a column has one for each pair.
VectorXd of_frictional(const ContactState& contact, const VectorXd& values, VectorXd all) {
  for (std::size_t k = 0; k < contact.frictional_pairs.size(); ++k)
    all(contact.frictional_pairs[k]) = values(static_cast<Index>(k));
  return all;
}

/// A number for each frictional pair, and another for all others.
VectorXd of_frictional(const ContactState& contact, const VectorXd& values, double other) {
  return of_frictional(contact, values, VectorXd::Constant(contact.force.size(), other));
}

// Words between commas: quoted if they have commas or quotes of their own, or what begins a comment.
// Names of contacts are the user's, and may have commas in them. A quote within a word is written
// twice, as spreadsheets expect it.
std::string csv_word(const std::string& word) {
  if (word.find_first_of("#,\"\n\r") == std::string::npos) return word;
  std::string quoted = "\"";
  for (const char c : word) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

// \param slip  in total, as displacements tell it of pairs without friction
// Friction has five columns, and load steps two more. The shear traction is the friction force over
// the weight of the pair, as the pressure is the contact force over it. The motion is a word: one
// of the four that a pair can do.
//
// A step of a path has two slips: since the step before, and since the beginning. For a pair
// without friction only the second is known: displacements tell the whole, not the part of a step.
void add_friction(const Model& model, const Solution& solution,
                  const std::optional<PathTotals>& totals, const VectorXd& slip,
                  std::vector<PairColumn>& columns) {
  const ContactState& contact = solution.contact;
  VectorXd contact_status(contact.friction.size());
  for (Index k = 0; k < contact_status.size(); ++k)
    contact_status(k) = static_cast<double>(status_of_slip(contact, k));
  std::vector<std::string> statuses;
  for (const ContactStatus word : {ContactStatus::Open, ContactStatus::Stick,
                                   ContactStatus::SlipForward, ContactStatus::SlipBackward})
    statuses.emplace_back(to_string(word));
  columns.push_back({"shear_traction", "force/length^2", "contact_shear_traction",
                     shear_tractions(model, solution)});
  columns.push_back({"shear_force", "force", "", of_frictional(contact, contact.friction, 0)});
  const VectorXd unknown = VectorXd::Constant(slip.size(), none);  // where steps keep only totals
  columns.push_back({"slip", "length", "contact_slip",
                     of_frictional(contact, increment(contact), totals ? unknown : slip)});
  columns.push_back({"motion", "-", "contact_motion", of_frictional(contact, contact_status, none),
                     std::move(statuses)});
  columns.push_back(
      {"dissipated", "force*length", "", of_frictional(contact, dissipated(contact), 0)});
  if (!totals) return;
  columns.push_back(
      {"slip_total", "length", "contact_slip_total", of_frictional(contact, totals->slip, slip)});
  columns.push_back(
      {"dissipated_total", "force*length", "", of_frictional(contact, totals->dissipation, 0)});
}

}  // namespace

// A state that is no solution has forces and gaps as well. To list them as if they were the answer
// would be a trap, so who asks is stopped.
void check_solved(const Solution& solution, const std::optional<PathTotals>& totals,
                  const char* function) {
  const ContactState& contact = solution.contact;
  require_argument(contact.report.status == SolveStatus::Solved, function,
                   ": the problem was not solved (", to_string(contact.report.status), ')');
  const auto n_slips = static_cast<Index>(contact.frictional_pairs.size());
  const auto n_statuses = static_cast<Index>(contact.contact_status.size());
  require_argument(contact.friction.size() == n_slips && contact.slip.size() == n_slips &&
                       n_statuses == contact.force.size(),
                   function, ": expected friction and slip of ", n_slips, " pairs and the status of ",
                   contact.force.size(), ", got ", contact.friction.size(), ", ",
                   contact.slip.size(), " and ", n_statuses);
  require_argument(!totals || (totals->slip.size() == contact.friction.size() &&
                               totals->dissipation.size() == contact.friction.size()),
                   function, ": the solution has ", contact.friction.size(),
                   " slips, but the state of its path ", totals ? totals->slip.size() : 0);
}

// The weight turns a force into a traction. It is the area of the pair's part of the boundary.
VectorXd shear_tractions(const Model& model, const Solution& solution) {
  const ContactState& contact = solution.contact;
  return of_frictional(contact, contact.friction, 0).cwiseQuotient(model.pairs.weight);
}

// One cell, whether the column has numbers or words.
std::string PairColumn::cell(Index pair, const char* format) const {
  const double value = values(pair);
  if (std::isnan(value)) return "";
  return words.empty() ? number(value, format) : words[static_cast<std::size_t>(value)];
}

// A column that a scene has not is left out rather than filled with zeros: a table without friction
// does not mention friction. Slip is the exception, because bodies slide along each other also
// without friction.
// The signs of all columns:
//
// | column | is positive if |
// |:---|:---|
// | gap | the pair is open |
// | pressure, force | the pair is pressed |
// | slip | the source moves to the right, looking out of the target |
// | shear_traction, shear_force | the source is pushed to the right, looking out of the target |
// | dissipated | a pair slides: friction acts against its slip |
std::vector<PairColumn> pair_columns(const Model& model, const Solution& solution,
                                     const std::optional<PathTotals>& totals) {
  check_solved(solution, totals, "pair_columns");
  const ContactState& contact = solution.contact;
  const Index n_pairs = contact.force.size();
  VectorXd closed = VectorXd::Zero(n_pairs);
  for (const Index pair : contact.active()) closed(pair) = 1;
  std::vector<PairColumn> columns;
  columns.push_back({"x", "length", "", model.pairs.position.col(0)});
  columns.push_back({"y", "length", "", model.pairs.position.col(1)});
  columns.push_back({"gap", "length", "contact_gap", contact.gap});
  columns.push_back({"pressure", "force/length^2", "contact_pressure", solution.pressure});
  columns.push_back({"force", "force", "", contact.force});
  columns.push_back({"status", "-", "contact_status", closed, {"open", "closed"}});
  const std::size_t smooth = columns.size();
  const bool moves = !solution.displacements.empty();  // forces alone may have been given
  // Along rows of bodies that have moved, displacements in total are no slip.
  const VectorXd slip = moves && !model.standing ? slips(model, solution.displacements)
                                                 : VectorXd::Constant(n_pairs, none);
  if (!contact.frictional_pairs.empty())
    add_friction(model, solution, totals, slip, columns);
  else if (moves && !totals)
    columns.push_back({"slip", "length", "contact_slip", slip});
  else if (moves)
    columns.push_back({"slip_total", "length", "contact_slip_total", slip});
  for (std::size_t k = smooth; k < columns.size(); ++k)
    columns[k].of_friction = columns[k].field.find("slip") == std::string::npos;
  if (model.contacts.size() > 1) {
    VectorXd number(n_pairs);
    for (Index pair = 0; pair < n_pairs; ++pair)
      number(pair) = static_cast<double>(model.contact_of[static_cast<std::size_t>(pair)]);
    columns.push_back({"contact", "-", "contact_number", number, model.contacts});
  }
  return columns;
}

// The rest is the comma separated form of it.
//
//     x,y,gap,pressure,force,status
//     0,0,0,0.3,3,closed
std::string csv_head(const std::vector<PairColumn>& columns) {
  std::string line;
  for (const PairColumn& column : columns) line += (line.empty() ? "" : ",") + column.name;
  return line + '\n';
}

std::string csv_lines(const std::vector<PairColumn>& columns) {
  std::string lines;
  const Index n_pairs = columns.empty() ? 0 : columns.front().values.size();
  for (Index pair = 0; pair < n_pairs; ++pair)
    for (const PairColumn& column : columns)
      lines += csv_word(column.cell(pair)) + (&column == &columns.back() ? '\n' : ',');
  return lines;
}

}  // namespace signorini
