// What the estimator is worth: estimated over true error of goals of four problems, on meshes of rising fineness.
// Run:  make effectivity     Reads: nothing     Writes: effectivity.csv, half_width.csv
// Without --full on small meshes: a test of this program, not a measurement.
#include <iomanip>
#include <iostream>
#include <sstream>

#include "bench/effectivity_scenes.hpp"
#include "signorini/estimate/estimate.hpp"
#include "signorini/scene/readings.hpp"

namespace {
using namespace signorini;
using namespace signorini::bench;
}  // namespace
int main(int argc, char** argv) {
  const std::string which = argc > 1 ? argv[1] : "";
  const int levels = argc > 2 ? std::atoi(argv[2]) : 4;
  const int ref = argc > 3 ? std::atoi(argv[3]) : 4;
  for (const EffectivityProblem& problem : {cantilever_problem(), hertz_problem(), pushed_problem(),
                                            footing_problem(), pin_problem()}) {
    if (!which.empty() && which != problem.name) continue;
    std::vector<double> truth, coarser;
    for (int l : {ref - 1, ref}) {
      const SolvedScene run = solved(problem.scene("q8", l), problem.name);
      (l == ref ? truth : coarser).clear();
      for (const Goal& g : problem.goals)
        (l == ref ? truth : coarser).push_back(value(run.model, run.solution, g));
    }
    if (problem.name == "Hertz") {
      LineContact t{
          50, contact_modulus(plane_strain_modulus(4000, .35), plane_strain_modulus(4000, .35)),
          41.76};
      truth[0] = hertz_half_width(t);
      truth[1] = hertz_peak_pressure(t);
    }
    for (size_t k = 0; k < truth.size(); ++k)
      std::cout << problem.name << " " << problem.goals[k].name << " truth " << std::setprecision(9)
                << truth[k] << " coarser " << coarser[k] << "\n";
    for (const std::string element : {"q4", "q4_bbar", "q4_incompatible", "t3", "q8", "t6"})
      for (int level = 0; level < levels; ++level) {
        const SolvedScene run = solved(problem.scene(element, level), problem.name);
        Ledger ledger;
        const auto all = estimates(run.model, run.condensed, run.solution, problem.goals, ledger);
        Eigen::Index nodes = 0;
        for (auto& b : run.model.bodies) nodes += b.mesh.n_nodes();
        double total = 0;
        for (auto& e : run.solution.ledger.entries())
          if (e.path.find('/') == std::string::npos) total += e.seconds;
        for (size_t k = 0; k < all.size(); ++k) {
          const Estimate& e = all[k];
          const double err = truth[k] - e.value, s = 100 / std::abs(truth[k]);
          std::printf(
              "%-10s %-15s %6ld %-12s err %+9.4f%% est %+9.4f%% eff %6.2f | int %+.4f gap %+.4f "
              "read %+.4f V %+.4f alg %.0e%s\n",
              problem.name.c_str(), element.c_str(), (long)nodes, e.goal.c_str(), err * s,
              e.error * s, (e.is_signed ? e.error / err : e.error / std::abs(err)),
              e.parts.interior * s, e.parts.gap * s, e.parts.reading * s, e.parts.free_boundary * s,
              e.algebraic * s,
              k + 1 == all.size() ? (" t " + std::to_string(ledger.seconds("estimate") / total) +
                                     " of " + std::to_string(total))
                                        .c_str()
                                  : "");
        }
      }
  }
}
