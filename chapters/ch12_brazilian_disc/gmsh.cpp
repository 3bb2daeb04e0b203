// Chapter 12 - A disc from a file of Gmsh.
// Run:  make ch12     Reads: disc.msh     Writes: ch12_gmsh.results

#include "closed_form/hertz_fit.hpp"
#include "from_gmsh.hpp"
#include "reading.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch12;

// What the disc of the file is good for.
void solve_file(const std::filesystem::path& file, Results& results) {
  const SolvedScene run = solved(disc_of_file(file), "the disc of " + file.filename().string());
  const Contact low = contact_of(run, false);
  const double peak = fit_hertz(low.x, low.pressure).peak_pressure;
  results.add("gmsh_nodes", static_cast<double>(run.model.bodies[0].mesh.n_nodes()), "-");
  results.add("gmsh_middle_error", 100 * (middle(run)[0] / exact_across(R) - 1), "%");
  results.add("gmsh_peak_error", 100 * (peak / hertz_peak_pressure(plate) - 1), "%");
  results.add("gmsh_axis_error", 100 * axis_error(run), "%");
  results.add("gmsh_sign_change", sign_change(diameter_of(run)), "mm");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch12_gmsh");
  solve_file(std::filesystem::path(SIGNORINI_CHAPTER_DATA) / "disc.msh", results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch12_gmsh", "A disc from Gmsh", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
