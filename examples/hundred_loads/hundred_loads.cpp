// A hundred loads on the cantilever of a scene file, with one factor.
// Run:  hundred_loads ../cantilever.toml
#include <iostream>

#include "addons/files/scene_file.hpp"
#include "addons/steps/steps.hpp"
#include "signorini/report/pressure_table.hpp"

using namespace signorini;

int main(int argc, char** argv) try {
  require_input(argc == 2, "expected one scene file, got ", argc - 1);
  SceneFile file = read_scene(argv[1]);
  at_file(file, [&] {
    // 1. The pressure grows with a history, in a hundred steps.
    for (EdgeLoad& load : file.scene.bodies[0].loads.edges) load.history = "part";
    file.scene.path = Path{equal_steps(100), {proportional("part")}};

    // 2. Once: matrices, the factor, and the compliance of all candidate pairs. A hundred times: contact on the condensed
    // problem, and at most four triangular solves to refine it.
    std::cout << "load,closed,force\n";
    const PathEnd end = solve_steps(file.scene, [](const Model& model, const Step& step) {
      std::cout << step.state.time << ',' << step.solution.contact.active().size() << ','
                << resultants(model, step.solution).force.y() << '\n';
    });
    if (end.status != SolveStatus::Solved) throw NotSolved(end.reason);
  });
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
