#include "command_line/contact_print.hpp"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <vector>

#include "addons/equations/equations.hpp"
#include "command_line/print.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/report/pair_columns.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/bodies.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;

void print_sums(std::ostream& out, const std::string& what, const Resultants& sum, bool axial) {
  out << what << ' ' << force_in_words(sum.force, axial);
  if (!axial) out << ", moment about the origin " << sum.moment;
  out << ", closed boundary " << sum.closed_weight << ", peak pressure " << sum.peak_pressure;
  if (sum.frictional_pairs > 0) {
    out << ", normal force " << sum.normal_force << ", shear force " << sum.shear_force
        << ", dissipated work " << sum.dissipated;
    if (sum.dissipated_total != sum.dissipated) out << ", in total " << sum.dissipated_total;
  }
  out << '\n';
}

/// The columns that are worth their place where all pairs are closed and of one contact.
std::vector<PairColumn> printed(std::vector<PairColumn> columns, const Resultants& sum) {
  const auto idle = [&](const PairColumn& column) {
    const std::string& name = column.name;
    return name == "gap" || name == "status" || name == "contact" ||
           (column.of_friction && sum.frictional_pairs == 0);
  };
  columns.erase(std::remove_if(columns.begin(), columns.end(), idle), columns.end());
  return columns;
}

/// How many pairs of a contact do what, and which are closed, if they are few.
void print_closed(std::ostream& out, const std::vector<PairColumn>& columns, const Resultants& sum,
                  const std::vector<Index>& closed) {
  out << sum.closed << " of " << sum.pairs << " pairs are closed";
  if (sum.frictional_pairs > 0) out << ": " << sum.stick << " stick, " << sum.slide << " slide";
  if (sum.frictional_pairs > 0 && sum.closed > sum.stick + sum.slide)
    out << ", " << sum.closed - sum.stick - sum.slide << " cannot rub";
  out << '\n';
  if (sum.closed > largest_printed)
    out << "more than " << largest_printed << " are not printed: --csv FILE writes them\n";
  else if (sum.closed > 0)
    print_rows(out, printed(columns, sum), closed);
}

void write_sums(Json& json, const Resultants& sum) {
  json.key("force").value(Eigen::VectorXd(sum.force)).key("moment").value(sum.moment);
  json.key("target_moment").value(sum.target_moment);
  json.key("closed").value(sum.closed_weight).key("peak_pressure").value(sum.peak_pressure);
  json.key("normal_force").value(sum.normal_force);
  json.key("n_pairs").value(sum.pairs).key("n_closed").value(sum.closed);
  if (sum.frictional_pairs == 0) return;
  json.key("shear_force").value(sum.shear_force);
  json.key("n_stick").value(sum.stick).key("n_slide").value(sum.slide);
  json.key("dissipated").value(sum.dissipated);
  json.key("dissipated_total").value(sum.dissipated_total);
}

}  // namespace

std::string force_in_words(const Eigen::Vector2d& force, bool axial) {
  return axial ? text(force.y(), " along the axis") : in_brackets(force);
}

void print_rows(std::ostream& out, const std::vector<PairColumn>& columns,
                const std::vector<Index>& rows) {
  const auto cell = [&](const PairColumn& column, const std::string& text) {
    out << std::setw(std::max(14, static_cast<int>(column.name.size()) + 2)) << text;
  };
  out << '\n';
  for (const PairColumn& column : columns) cell(column, column.name);
  out << '\n';
  for (const Index row : rows) {
    for (const PairColumn& column : columns) cell(column, column.cell(row, "%.6g"));
    out << '\n';
  }
}

void print_contacts(std::ostream& out, const Model& model, const Solution& solution,
                    const PathState* state) {
  if (model.contacts.empty()) return;
  const bool axial = is_axial(model.bodies[0]);
  const std::vector<PairColumn> columns = pair_columns(model, solution, totals(state));
  const std::vector<Resultants> sums = resultants_of_contacts(model, solution, totals(state));
  if (sums.size() > 1)
    print_sums(out, "all contacts: force on the sources",
               resultants(model, solution, totals(state)), axial);
  for (std::size_t k = 0; k < sums.size(); ++k) {
    print_sums(out, "contact " + model.contacts[k] + ": force on the source", sums[k], axial);
    std::vector<Index> closed;
    for (const Index pair : solution.contact.active())
      if (model.contact_of[static_cast<std::size_t>(pair)] == k) closed.push_back(pair);
    print_closed(out, columns, sums[k], closed);
    if (k + 1 < sums.size()) out << '\n';
  }
}

void print_bonds(std::ostream& out, const Model& model, const Solution& solution) {
  if (!model.equations) return;
  const bool axial = is_axial(model.bodies[0]);
  for (const BondForces& sum : bond_forces(model, solution)) {
    out << "bond " << sum.name << ": force on the " << (sum.has_sides ? "source " : "first side ")
        << force_in_words(sum.force, axial);
    if (!axial) out << ", moment about the origin " << sum.moment;
    if (sum.has_sides)
      out << ", pressure " << sum.least_pressure << " to " << sum.largest_pressure
          << ", shear up to " << sum.largest_shear;
    out << '\n';
  }
}

void write_bonds(Json& json, const Model& model, const Solution& solution) {
  if (!model.equations) return;
  json.key("bonds").array();
  for (const BondForces& sum : bond_forces(model, solution)) {
    json.object().key("name").value(sum.name).key("force").value(Eigen::VectorXd(sum.force));
    json.key("moment").value(sum.moment);
    if (sum.has_sides) {
      json.key("least_pressure").value(sum.least_pressure);
      json.key("largest_pressure").value(sum.largest_pressure);
      json.key("largest_shear").value(sum.largest_shear);
    }
    json.end();
  }
  json.end();
}

void write_contacts(Json& json, const Model& model, const Solution& solution,
                    const PathState* state) {
  json.key("resultants").object();
  write_sums(json, resultants(model, solution, totals(state)));
  json.end().key("contacts").array();
  const std::vector<Resultants> sums = resultants_of_contacts(model, solution, totals(state));
  for (std::size_t k = 0; k < sums.size(); ++k) {
    json.object().key("name").value(model.contacts[k]);
    write_sums(json, sums[k]);
    json.end();
  }
  json.end().key("pairs").object();
  const std::vector<PairColumn> columns = pair_columns(model, solution, totals(state));
  for (const PairColumn& column : columns) {
    if (column.name == "status") json.key("closed").value(column.values);
    json.key(column.name);
    if (column.words.empty()) {
      json.value(column.values);
      continue;
    }
    std::vector<std::string> words;
    for (Index pair = 0; pair < column.values.size(); ++pair) words.push_back(column.cell(pair));
    json.value(words);
  }
  json.end().key("units").object();
  for (const PairColumn& column : columns) json.key(column.name).value(column.unit);
  json.end();
}

}  // namespace command_line
