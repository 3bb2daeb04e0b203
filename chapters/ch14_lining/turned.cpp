// Chapter 14 - The rock's mesh turned by half a cell: what straight sides do to a gap.
// Run:  make ch14     Reads: nothing     Writes: ch14_turned.results, turned.md, turned_all.md
#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "readings.hpp"
#include "rings.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch14;

// The rock's mesh turned by half a cell, and either side as the source.
void turned_meshes(const ProgramOptions& run, Results& results) {
  const char* operators[] = {"node_to_segment", "gauss_points", "mortar"};
  Table all(
      {"element", "cells", "operator", "source", "first gaps [cm]", "u(a) [cm]", "pressure [MPa]"});
  Table pressures({"element", "cells", "source", operators[0], operators[1], operators[2]});
  const auto range = [](const Eigen::VectorXd& x, const char* format) {
    return number(x.minCoeff(), format) + " to " + number(x.maxCoeff(), format);
  };
  Rings rings;
  rings.turn = 0.5;  // cells
  for (const auto& [element, cells] :
       {std::pair{"q4_incompatible", 9}, {"q4_incompatible", 36}, {"q8", 9}})
    for (const char* source : {"lining", "rock"}) {
      std::vector<std::string> row = {element, number(cells), source};
      for (const char* gap_operator : operators) {
        rings.element = element;
        rings.cells_angle = cells;
        rings.gap_operator = gap_operator;
        Scene scene = scene_of(rings);
        ContactSpec& contact = scene.contacts[0];
        if (contact.source.body != source)
          std::swap(contact.source, std::get<Side>(contact.target));
        const SolvedScene now = solved(scene, "the turned lining");
        row.push_back(range(now.solution.pressure, "%.0f"));
        all.row({element, number(cells), gap_operator, source,
                 range(now.model.pairs.initial_gap, "%.3f"), range(inner_rim(now), "%.4f"),
                 row.back()});
      }
      pressures.row(row);
    }
  std::cout << all.markdown();
  write_file(run.out / "turned.md", pressures.markdown());
  write_file(run.out / "turned_all.md", all.markdown());
  const double half_cell = quarter_turn / 18;
  results.add("sagitta", 68.15 * (1 - std::cos(half_cell)), "cm");
  results.add("gap_over_chord", 68.15 * std::cos(half_cell) - 68, "cm");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch14_turned");
  turned_meshes(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch14_turned", "Meshes that do not match", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
