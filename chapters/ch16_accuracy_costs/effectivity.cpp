// Chapter 16 - What the estimates are worth: estimated beside true errors.
// Run:  make ch16     Reads: nothing     Writes: ch16_effectivity.results, effectivity.md, fig_16_1.csv, fig_16_1_width.csv
// --full: six elements instead of four, and three of the problems with friction, half a minute.
// Takes longer than 5 s: ./run.sh shows its committed results.
#include "../../tests/support/effectivity.hpp"

#include <iostream>
#include <map>

#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace signorini_test;

// 1. Four problems: forces and displacements, each on four meshes of every element. The truth is a much finer mesh.
std::vector<Measured> problems_of(bool full) {
  std::vector<Measured> problems = {measured_cantilever(), measured_push(), measured_footing(),
                                    measured_pin()};
  if (full)
    for (const Measured& problem : measured_with_friction()) problems.push_back(problem);
  return problems;
}

// 2. How often the estimate lies between half and twice the error, and from where to where it goes.
struct Count {
  int holds = 0, all = 0;
  double least = HUGE_VAL, most = -HUGE_VAL;
  void add(const Measurement& one) {
    holds += one.good() ? 1 : 0;
    ++all;
    least = std::min(least, one.effectivity());
    most = std::max(most, one.effectivity());
  }
  [[nodiscard]] std::string text() const {
    return number(least, "%.3g") + " to " + (most > 100 ? "over 100" : number(most, "%.3g"));
  }
};

/// One point of the figure. \param table  gets it
void point(Table& table, const std::string& scene, const std::string& element,
           const Measurement& one) {
  const double value = std::abs(one.truth), error = std::abs(one.truth - one.estimate.value);
  const bool wrong_sign = one.effectivity() < 0;
  table.row({scene, element, number(static_cast<double>(one.nodes)),
             number(100 * error / value, "%.4g"),
             number(100 * std::abs(one.estimate.error) / value, "%.4g"), wrong_sign ? "1" : "0"});
}
const std::vector<std::string> columns = {"scene", "element", "nodes", "error", "estimate", "sign"};

// 3. The half-width of Hertz's contact on 25 meshes, which differ in fineness, in grading, and in whether nodes meet.
Count half_widths(const std::string& element, Table& curve) {
  const std::vector<Goal> width = {{"half-width", HalfWidth{}}};
  const std::vector<double> truth = {hertz_half_width(HertzProblem{}.theory())};
  Count count;
  for (const HertzMeshSpec& spec : hertz_layouts({12, 14, 16, 18, 20})) {
    const Measurement one = measured(hertz(spec, element.c_str()), width, truth).front();
    point(curve, "Hertz", element, one);
    count.add(one);
  }
  return count;
}

SolveStatus chapter(const ProgramOptions& run) {
  std::vector<std::string> elements = {"q4", "q4_bbar", "q4_incompatible", "q8"};
  if (run.full) elements.insert(elements.end(), {"t3", "t6"});
  Results results("ch16_effectivity");
  std::vector<std::string> head = {"scene", "goal"};
  head.insert(head.end(), elements.begin(), elements.end());
  Table table(head), curve(columns), widths(columns);
  std::map<std::string, Count> of_element;
  for (const Measured& problem : problems_of(run.full)) {
    const std::vector<double> truth = truth_of(problem, problem.fine);
    std::vector<std::vector<std::string>> rows;
    for (const Goal& goal : problem.goals) rows.push_back({problem.name, goal.name});
    for (const std::string& element : elements) {
      std::vector<Count> of_goal(rows.size());
      for (const Eigen::Index cells : problem.cells) {
        const std::vector<Measurement> all =
            measured(problem.scene(element, cells), problem.goals, truth);
        for (std::size_t k = 0; k < all.size(); ++k) {
          point(curve, problem.name, element, all[k]);
          of_goal[k].add(all[k]);
          of_element[element].add(all[k]);
        }
      }
      for (std::size_t k = 0; k < rows.size(); ++k) rows[k].push_back(of_goal[k].text());
    }
    for (std::vector<std::string>& row : rows) table.row(std::move(row));
    curve.blank_line();
  }
  for (const auto& [element, count] : of_element) {
    results.add("held_" + element, count.holds, "-");
    results.add("of_" + element, count.all, "-");
  }
  std::vector<std::string> last = {"Hertz", "half-width"};
  for (const std::string& element : elements) {
    const Count count = half_widths(element, widths);
    last.push_back(count.text());
    results.add("widths_" + element, count.holds, "-");
    widths.blank_line();
  }
  table.row(std::move(last));
  std::cout << table.markdown();
  results.print();
  write_file(run.out / "effectivity.md", table.markdown());
  write_file(run.out / "fig_16_1.csv", curve.csv("rel 1e-3 abs 1e-9"));
  write_file(run.out / "fig_16_1_width.csv", widths.csv("rel 1e-3 abs 1e-9"));
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch16_effectivity", "What the estimates are worth", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}
