// Chapter 9 - A corner of the target between two nodes of the source (Lin et al., sec. 2.3).
// Run:  make ch09     Reads: nothing     Writes: ch09_corner.results, corner.md
#include <algorithm>
#include <iostream>

#include "blocks.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch09;
using namespace signorini;

std::string percent(double x) { return x < 1e-12 ? "below 1e-10" : number(100 * x, "%.2f"); }

// 1. The scene.
/// A wide block on a narrow one, whose corners lie between nodes of the wide one.
/// \param upper         cells of the wide block, 3 wide; the narrow one is 2 wide with 20 cells
/// \param source        which side it is
/// \param gap_operator  of the contact
Scene corner(Index upper, Source source, const std::string& gap_operator) {
  Scene scene = blocks(block("lower", {0.5, 0}, {2, 1}, 20, 10),
                       block("upper", {0, 1}, {3, 1}, upper, 3), source, gap_operator);
  scene.bodies[0].supports = {fixed("bottom")};
  scene.bodies[1].supports = {prescribed("top", Axis::Y, -0.01),
                              prescribed_at("top", {0, 2}, Axis::X)};
  return scene;
}

// 2. A corner of the target between two nodes of the source.
void corners(const ProgramOptions& run, Results& results) {
  Table table({"cells of the wide block", "source wide: overlap", "force", "source narrow: overlap",
               "force ", "mortar, source wide: overlap", "force  "});
  double mortar_overlap = 0;
  for (const Index cells : {7, 10, 20, 40}) {
    std::vector<std::string> row = {std::to_string(cells)};
    for (const auto& [source, name] :
         {std::pair(Source::Upper, "node_to_segment"), std::pair(Source::Lower, "node_to_segment"),
          std::pair(Source::Upper, "mortar")}) {
      const Scene scene = corner(cells, source, name);
      const SolvedScene one = solved(scene, "corner");
      const double part = overlap(scene, one) / 0.01, force = one.solution.contact.force.sum();
      row.push_back(percent(part));
      row.push_back(number(1000 * force, "%.2f"));
      if (text(name) == "mortar") mortar_overlap = std::max(mortar_overlap, part);
      if (cells != 7 || text(name) == "mortar") continue;
      const std::string side = source == Source::Upper ? "wide" : "narrow";
      if (source == Source::Upper) results.add("overlap_wide", 100 * part, "%");
      results.add("force_" + side, 1000 * force, "-");
    }
    table.row(row);
  }
  results.add("overlap_mortar", 100 * mortar_overlap, "%");
  std::cout << table.markdown();
  write_file(run.out / "corner.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch09_corner");
  corners(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch09_corner", "A corner between two nodes", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
