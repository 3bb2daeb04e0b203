// What the effects cost that a scene does not call for: the same problem solved three ways, for docs/absent_effects.sh.
// Run:  absent_effects hand|scene|named [CELLS]
//   hand   the rooms called one by one, without a scene
//   scene  solve(scene)
//   named  solve(scene) where every effect is named and none is wanted
// Prints forces and displacements to the last bit.
#include <iomanip>
#include <iostream>

#include "addons/certified/certified_solve.hpp"
#include "addons/checks/loose_nodes.hpp"
#include "addons/checks/undetermined.hpp"
#include "addons/frontal/frontal_factor.hpp"
#include "signorini/contact/node_to_obstacle.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/free_motions.hpp"
#include "signorini/fem/joints.hpp"
#include "signorini/scene/scene.hpp"
#include "support/cantilever.hpp"

namespace {

using namespace signorini;
using Eigen::VectorXd;

void print(const VectorXd& force, const NodeArray& displacements) {
  std::cout << std::hexfloat;
  for (const double value : force) std::cout << value << '\n';
  for (const double value : displacements.reshaped()) std::cout << value << '\n';
}

/// Every effect by name, with numbers that ask for nothing.
Scene named(Scene scene) {
  Body& body = scene.bodies[0];
  const Eigen::Vector2d zero = Eigen::Vector2d::Zero();
  body.springs = {{"top", zero}};
  body.temperature = Temperature{};
  body.loads.points = {{{0, 0}, zero}};
  scene.contacts[0].friction = Friction{0, 0};
  scene.contacts[0].interference = 0;
  scene.contacts[0].adjust = 0;
  return scene;
}

/// What a scene of one held body on an obstacle comes to.
void by_hand(const Scene& scene) {
  const Body& body = scene.bodies[0];
  const ContactSpec& contact = scene.contacts[0];
  const Mesh mesh = body.mesh;
  const Element& element = find_element(body.element);
  Ledger ledger;
  static_cast<void>(check_mesh(mesh));
  check_element(mesh, element);
  const Unknowns unknowns = number_unknowns(mesh, body.supports);
  const std::vector<MeshPiece> parts = pieces(mesh);
  require_input(parts.size() == 1 && loose_nodes(mesh).empty(), "the body hangs together badly");
  require_input(free_motions(mesh, parts, unknowns).empty(), "the body is loose");
  const Surface source{mesh, contact.source.boundary};
  GapOptions options;
  options.n_nodes = mesh.n_nodes();
  options.depth = depth_of(body.material);
  Gaps gaps = reduce(node_to_obstacle(source, std::get<Obstacle>(contact.target), options), source,
                     unknowns);
  LinearSystem system = assemble(mesh, element, body.material, unknowns, body.loads);
  QuadraticProgramme programme;
  programme.stiffness.swap(system.stiffness);
  programme.load.swap(system.load);
  programme.A.swap(gaps.A);
  programme.initial_gap = gaps.pairs.initial_gap;
  const FrontalFactor factor(programme.stiffness,
                             separator_tree(programme.stiffness, unknown_positions(mesh, unknowns)),
                             ledger);
  ContactProblem problem;
  const VectorXd free = factor.solve(programme.load);
  problem.compliance = factor.compliance(programme.A);
  problem.free_gap = signorini::gaps(programme, {free, {}, VectorXd::Zero(programme.A.rows())});
  const CondensedProgramme small{problem, free,
                                 [&](const VectorXd& load) { return factor.solve(load); }};
  const CertifiedSolution end = certified_solve(programme, small, {}, scene.solver, {}, ledger);
  // Of every solution it is asked whether its forces are determined.
  static_cast<void>(
      undetermined_forces(carried(programme, end.solution, {}, end.state.contact_status)));
  print(end.state.force, expand(unknowns, end.solution.displacement));
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string way = argc > 1 ? argv[1] : "";
  require_input(way == "hand" || way == "scene" || way == "named",
                "absent_effects hand|scene|named [CELLS]");
  const Eigen::Index cells = argc > 2 ? std::stol(argv[2]) : 6;
  const Scene scene = signorini_test::cantilever("q4_incompatible", 10 * cells, cells);
  if (way == "hand") {
    by_hand(scene);
    return 0;
  }
  const Solution solution = solve(way == "named" ? named(scene) : scene);
  print(solution.contact.force, solution.displacements[0]);
} catch (const std::exception& error) {
  std::cerr << "absent_effects: " << error.what() << '\n';
  return 1;
}
