/// \file
/// The printed method on the example: steps, residuals and pressures, beside those of this book.
#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "as_printed.hpp"
#include "hertz_run.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"

namespace signorini {

/// How far a number of steps can be relied on.
enum class Steps {
  Exact,   ///< the same wherever the program is built
  About,   ///< a J on the way is nearly singular: rounding adds or takes a step
  Chance,  ///< J is singular at the solution: rounding decides
};

/// A row of the table.
struct PrintedCase {
  int points;       ///< Gauss points on an edge, 0 for nodes
  bool match;       ///< whether the meshes do
  double yielding;  ///< of PrintedEquations
  Steps steps;      ///< what they are worth
};

/// Adds a block to the data of a figure. \param table  of x and p \param run  at its end
/// \param peak  q_0
inline void add_pressures(Table& table, const PrintedRun& run, double peak) {
  std::vector<std::pair<double, double>> at;
  for (Eigen::Index i = 0; i < run.pressure.size(); ++i)
    if (run.model.pairs.position(i, 0) < 1.3)
      at.emplace_back(run.model.pairs.position(i, 0), run.pressure(i) / peak);
  std::sort(at.begin(), at.end());
  for (const auto& [x, p] : at) table.row({x, p});
  table.blank_line();
}

/// Adds a block to the data of a figure. \param table  of step and residual \param values  of it
inline void add_residuals(Table& table, const std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) table.row({static_cast<double>(k), values[k]});
  table.blank_line();
}

/// Root mean square of the error of the pressures at x < 0.7 b, all of them alike. \param run  at its end
/// \param theory  closed form \return in percent of q_0
inline double rms_error(const PrintedRun& run, const LineContact& theory) {
  double sum = 0, count = 0;
  for (Eigen::Index i = 0; i < run.pressure.size(); ++i) {
    const double x = run.model.pairs.position(i, 0);
    if (x >= 0.7 * hertz_half_width(theory)) continue;
    sum += std::pow(run.pressure(i) - hertz_pressure(theory, x), 2);
    ++count;
  }
  return 100 * std::sqrt(sum / count) / hertz_peak_pressure(theory);
}

/// Writes printed.md and the data of figures 11.3 and 11.4.
/// \param folder   to write to
/// \param results  to add to
/// \param ours     the example, solved by the condensed Newton method
inline void study_as_printed(const std::filesystem::path& folder, Results& results,
                             const HertzRun& ours) {
  const LineContact theory = ours.now.theory();
  const double b = hertz_half_width(theory), q0 = hertz_peak_pressure(theory);
  Table table({"pressures at", "meshes", "J", "closed", "independent", "steps", "steps, scaled",
               "largest p/q0", "rms p [%]"});
  Table residuals({"step", "residual"}), chance({"step", "residual"}), pressures({"x", "p"});
  const HertzCase example;
  const double h = example.mesh.core / static_cast<double>(example.mesh.disc_cells);
  const double soft = 0.1 * h / theory.modulus;
  for (const PrintedCase& now : {PrintedCase{2, true, 0, Steps::Chance},
                                 {2, true, soft, Steps::Exact},
                                 {2, false, 0, Steps::About},
                                 {0, true, 0, Steps::Exact},
                                 {0, false, 0, Steps::Exact}}) {
    HertzCase hertz = now.match ? example : not_matching();
    hertz.gap_operator = now.points > 0 ? "gauss_points" : "mortar";
    hertz.points = now.points;
    std::vector<std::string> row = {now.points > 0 ? "Gauss points" : "nodes",
                                    now.match ? "match" : "do not",
                                    now.yielding > 0 ? "mended" : "as printed"};
    if (now.steps == Steps::Chance) {
      const PrintedRun first = run_as_printed(hertz, {1, now.yielding, 40});
      add_residuals(chance, first.residuals);
      hertz.load *= 1 + 1e-12;
      const PrintedRun second = run_as_printed(hertz, {1, now.yielding, 40});
      results.add("steps_chance", first.steps(), "-", Repeats::No);
      results.add("steps_chance_other", second.steps(), "-", Repeats::No);
      row.insert(row.end(), {"", "", "by chance", "by chance", "", ""});
    } else {
      const PrintedRun mm = run_as_printed(hertz, {1, now.yielding, now.points > 0 ? 30 : 20});
      const PrintedRun scaled =
          run_as_printed(hertz, {b / theory.modulus, now.yielding, now.points > 0 ? 20 : 13});
      if (std::max(mm.residuals.back(), scaled.residuals.back()) > 1e-11)
        throw NotSolved("the printed method does not come to its floor");
      const ClosedRows closed = closed_rows(mm);
      const int steps = mm.steps();
      row.insert(row.end(),
                 {std::to_string(closed.count), std::to_string(closed.independent),
                  now.steps == Steps::About ? text("about ", (steps + 5) / 10 * 10)
                                            : std::to_string(steps),
                  std::to_string(scaled.steps()), number(mm.pressure.maxCoeff() / q0, "%.3f"),
                  number(rms_error(mm, theory), "%.2f")});
      if (now.points > 0) {
        const std::string key = now.match ? "mended" : "points";
        results.add("peak_" + key, mm.pressure.maxCoeff() / q0, "-");
        results.add("peak_" + key + "_scaled", scaled.pressure.maxCoeff() / q0, "-");
        add_pressures(pressures, mm, q0);
        if (now.match) {
          results.add("closed", static_cast<double>(closed.count), "-");
          results.add("independent", static_cast<double>(closed.independent), "-");
        }
      } else if (now.match) {
        results.add("steps_nodes", steps, "-");
        results.add("steps_nodes_scaled", scaled.steps(), "-");
      }
      if (now.points > 0 || now.match) add_residuals(residuals, mm.residuals);
    }
    table.row(row);
  }
  table.row({"nodes", "match", "condensed", std::to_string(ours.run.solution.contact.active.size()),
             std::to_string(ours.run.solution.contact.active.size()), "",
             std::to_string(ours.run.solution.contact.report.iterations),
             number(*std::max_element(ours.pressure.begin(), ours.pressure.end()) / q0, "%.3f"),
             number(pressure_error(ours), "%.2f")});
  const double start = ours.run.model.programme.load.norm();
  std::vector<double> condensed = {start};
  for (const Iteration& step : ours.run.solution.contact.report.history)
    condensed.push_back(start * step.residual);
  condensed.push_back(start * std::max(1e-16, ours.run.solution.certificate.worst()));
  add_residuals(residuals, condensed);
  residuals.row({16.0, 6.13e-9});  // the paper
  for (std::size_t k = 0; ours.x[k] < 1.3; ++k) pressures.row({ours.x[k], ours.pressure[k] / q0});
  pressures.blank_line();
  for (int k = 0; k <= 130; ++k) pressures.row({0.01 * k, hertz_pressure(theory, 0.01 * k) / q0});
  write_file(folder / "printed.md", table.markdown());
  write_file(folder / "fig_11_3.csv", residuals.csv("rel 0.9 abs 1e-10"));
  write_file(folder / "fig_11_3_chance.csv", chance.csv("rel 1 abs 1e300"));
  write_file(folder / "fig_11_4.csv", pressures.csv("rel 1e-5 abs 1e-6"));
}

}  // namespace signorini
