// Chapter 13 - Points of integration that carry forces of their own (Lin et al., sec. 2.4).
// Run:  make ch13     Reads: nothing     Writes: ch13_points.results
#include <cmath>

#include "base.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace {

using namespace ch13;

// The paper's points of integration, two on every edge, that carry forces of their own. The corner node
// feels only the last two: what they may carry follows from the forces of the last two nodes.
void points(Results& results) {
  Scene scene = on_soil(coarse, {});
  scene.contacts.front().gap_operator = "gauss_points";
  // It does not mind gaps that depend on each other.
  scene.solver = quasi_active_set();
  const SolvedScene now = solved(scene, "the footing on points");
  const Base nodal = base_of(settle(coarse, {}));
  const Index n = nodal.force.size();
  const double outer = (1 + std::sqrt(1 / 3.0)) / 2, inner = 1 - outer;  // places on the edge
  const double corner = nodal.force(n - 1), next = nodal.force(n - 2);
  const double most = corner / outer;  // the inner point carries nothing
  const double least = (outer * corner - inner * next) / (outer * outer - inner * inner);
  const double weight = nodal.width(n - 1);  // of a point: half of the edge
  results.add("points_forces", (base_of(now).force - nodal.force).norm() / nodal.force.norm(), "-",
              Repeats::No);
  results.add("points", static_cast<double>(now.solution.pressure.size()), "-");
  results.add("points_nodes", static_cast<double>(n), "-");
  results.add("points_least", least / weight / q, "q");
  results.add("points_most", most / weight / q, "q");
  results.add("points_inner_most", (corner - outer * least) / inner / weight / q, "q");
  const double h = 2 * weight;
  results.add("points_closed_form", rigid_strip_pressure(strip, a - inner * h) / q, "q");
  results.add("points_inner_closed_form", rigid_strip_pressure(strip, a - outer * h) / q, "q");
  results.add("points_pressed", static_cast<double>(now.solution.contact.active().size()), "-",
              Repeats::No);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch13_points");
  points(results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch13_points", "Points with forces of their own", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}
