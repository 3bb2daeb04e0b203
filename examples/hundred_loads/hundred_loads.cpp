// A hundred loads on the cantilever of a scene file, with one factor.
// Run:  hundred_loads ../cantilever.toml
#include <iostream>

#include "signorini/report/pressure_table.hpp"
#include "signorini/scene_file/scene_file.hpp"

using namespace signorini;

int main(int argc, char** argv) try {
  pose(argc == 2, "expected one scene file, got ", argc - 1);
  const SceneFile file = read_scene(argv[1]);
  at_file(file, [&] {
    // 1. Once: matrices, the factor, and the compliance of all candidate pairs.
    Ledger ledger;
    Model model = build(file.scene, ledger);
    Condensed condensed = condense(model, ledger);
    const Loads full = model.bodies[0].loads;

    // 2. A hundred times: the load, two triangular solves, and contact on the condensed problem.
    std::cout << "load,closed,force\n";
    for (int percent = 1; percent <= 100; ++percent) {
      Loads part = full;
      for (EdgeLoad& load : part.edges) load.pressure *= percent / 100.0;
      change_loads({part}, model, condensed);
      const Solution solution = solve(model, condensed, ledger);
      require_solved(solution, text("the beam under ", percent, " percent"));
      std::cout << percent / 100.0 << ',' << solution.contact.active.size() << ','
                << resultants(model.pairs, solution).force.y() << '\n';
    }
  });
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
