#include "command_line/probe_print.hpp"

#include <algorithm>
#include <numeric>
#include <ostream>

#include "addons/along/probes.hpp"
#include "command_line/contact_print.hpp"
#include "command_line/print.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;

/// Where a probe is, in words.
std::string where(const Probe& probe) {
  if (!probe.of.empty()) return text("of '", probe.of, "' of '", probe.body, "'");
  if (!probe.along.empty()) return text("along '", probe.along, "' of '", probe.body, "'");
  return text(probe.line ? "on a line in '" : "in '", probe.body, "'");
}

/// The rows of a probe in all steps, behind their times.
std::vector<PairColumn> along_the_path(const std::vector<ProbedStep>& steps, std::size_t probe) {
  std::vector<PairColumn> table = steps.front().of_probes[probe];
  table.insert(table.begin(), {"time", "time", "", Eigen::VectorXd::Zero(1)});
  for (PairColumn& column : table) column.values.resize(static_cast<Index>(steps.size()));
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto row = static_cast<Index>(k);
    table[0].values(row) = steps[k].time;
    for (std::size_t c = 1; c < table.size(); ++c)
      table[c].values(row) = steps[k].of_probes[probe][c - 1].values(0);
  }
  return table;
}

/// The columns that have a value at one place or more.
std::vector<PairColumn> that_say_something(std::vector<PairColumn> columns) {
  const auto idle = [](const PairColumn& column) { return column.values.array().isNaN().all(); };
  columns.erase(std::remove_if(columns.begin(), columns.end(), idle), columns.end());
  return columns;
}

}  // namespace

void keep_probes(SceneRun& run, const Model& model, const Step& step) {
  const bool printed = static_cast<Index>(run.probed_steps.size()) <= largest_printed;
  if (run.file.probes.empty() || !printed) return;
  run.probed_steps.push_back(
      {step.state.time, probed(model, step.solution, run.file.probes, totals(&step.state))});
}

void print_probes(std::ostream& out, const SceneRun& run) {
  const std::vector<Probe>& probes = run.file.probes;
  if (probes.empty()) return;
  auto all = probed(*run.model, *run.solution, probes, totals(run.state()));
  const std::vector<ProbedStep>& steps = run.probed_steps;
  const bool few = steps.size() > 1 && static_cast<Index>(steps.size()) <= largest_printed;
  for (std::size_t k = 0; k < all.size(); ++k) {
    out << "\nprobe '" << probes[k].name << "' " << where(probes[k]) << '\n';
    if (few && all[k].front().values.size() == 1) all[k] = along_the_path(steps, k);
    std::vector<Index> rows(static_cast<std::size_t>(all[k].front().values.size()));
    std::iota(rows.begin(), rows.end(), 0);
    if (static_cast<Index>(rows.size()) > largest_printed)
      out << "more than " << largest_printed
          << " places are not printed: --probes FILE writes them\n";
    else
      print_rows(out, that_say_something(all[k]), rows);
  }
}

std::string probes_csv(const std::vector<Probe>& probes, const Model& model,
                       const Solution& solution, const PathState* state) {
  const std::vector<PairColumn> table =
      table_of(probes, probed(model, solution, probes, totals(state)));
  return csv_head(table) + csv_lines(table);
}

void write_probes(Json& json, const std::vector<Probe>& probes, const Model& model,
                  const Solution& solution, const PathState* state) {
  if (probes.empty()) return;
  const auto all = probed(model, solution, probes, totals(state));
  json.key("probes").array();
  for (std::size_t k = 0; k < all.size(); ++k) {
    json.object().key("name").value(probes[k].name).key("body").value(probes[k].body);
    json.key("columns").object();
    for (const PairColumn& column : all[k]) json.key(column.name).value(column.values);
    json.end().key("units").object();
    for (const PairColumn& column : all[k]) json.key(column.name).value(column.unit);
    json.end().end();
  }
  json.end();
}

}  // namespace command_line
