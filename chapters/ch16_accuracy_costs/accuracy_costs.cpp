// Chapter 16 - What accuracy costs: error against seconds, and a list of prices.
// Run:  make ch16     Reads: nothing     Writes: ch16.results, prices.md, fig_16_2.csv
// --full: one mesh more of each way but the last, half a minute more.
// Takes longer than 5 s: ./run.sh shows its committed results.
#include <iostream>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "ways.hpp"

namespace {

using namespace ch16;

// A line of the figure, and its row of the list.
void follow(const Way& way, const ProgramOptions& run, Table& curves, Table& prices,
            Results& results) {
  std::vector<Point> line;
  const bool quadratic = find_element(way.element).n_nodes > 4;  // four times the nodes a cell
  for (const Index cells : {4, 8, 16, 32, 64})
    line.push_back(measured(way, quadratic ? cells / 2 : cells));
  for (const Point& p : line)
    curves.row({way.name, number(p.unknowns), number(p.error), p.solved ? "1" : "0",
                number(p.seconds, "%.2g")});
  curves.blank_line();
  if (run.full && way.solver != newton) {
    const Point p = measured(way, quadratic ? 64 : 128);
    std::cout << way.name << ", once more: " << p.unknowns << " unknowns, "
              << (p.solved ? text(p.error, " %") : "no solution") << ", " << p.seconds << " s\n";
  }
  const auto at = [&](double error, double Point::*cost) { return price(line, error, cost); };
  const auto times = [&](double Point::*cost) {
    const double factor = at(0.1, cost) / at(1, cost);
    return std::isfinite(factor) && factor > 0 ? number(factor, "%.0f") : "";
  };
  const auto cell = [](double value) { return value > 0 ? number(value, "%.0f") : "never"; };
  prices.row({way.name, cell(at(1, &Point::unknowns)), cell(at(0.1, &Point::unknowns)),
              way.solver == newton ? "" : times(&Point::operations), times(&Point::seconds)});
  const std::string key = text(&way - ways.data());
  if (line.back().solved) results.add("error_" + key, line.back().error, "%");
  if (at(0.1, &Point::unknowns) > 0)
    results.add("operations_" + key, at(0.1, &Point::operations), "-");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch16");
  Table curves({"way", "unknowns", "error", "solved", "seconds ≈"});
  Table prices({"", "unknowns for 1 %", "for 0.1 %", "operations ×", "seconds × ≈"});
  if (run.full) std::cout << "--full: one mesh more of each way but the last, half a minute\n";
  for (const Way& way : ways) follow(way, run, curves, prices, results);
  write_file(run.out / "fig_16_2.csv", curves.csv("rel 1e-4 abs 1e-6"));
  write_file(run.out / "prices.md", prices.markdown());
  std::cout << prices.markdown();
  results.headline("error_1", 0, "closed form, half-planes");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch16", "What accuracy costs", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
