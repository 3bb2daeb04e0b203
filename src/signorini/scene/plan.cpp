#include <cmath>
#include <ostream>

#include "signorini/complementarity/solvers.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {
namespace {

void check_load(const Mesh& mesh, const EdgeLoad& load) {
  static_cast<void>(boundary(mesh, load.boundary));
  pose(std::isfinite(load.pressure), "load on '", load.boundary, "': the pressure ", load.pressure,
       " is not finite");
}

void plan_body(const Scene& scene, Plan& plan) {
  const bool stress = scene.material.state == PlaneState::Stress;
  plan.on.push_back(text("body '", scene.mesh.name, "': ", scene.mesh.n_cells(), " cells ",
                         scene.element, ", ", plan.unknowns.count, " unknowns, plane ",
                         stress ? "stress" : "strain"));
  plan.on.push_back(
      text("supports: ", 2 * scene.mesh.n_nodes() - plan.unknowns.count, " displacements given"));
  (scene.loads.body_force ? plan.on : plan.off).emplace_back("body force");
  if (scene.loads.edges.empty()) plan.off.emplace_back("edge loads");
  for (const EdgeLoad& load : scene.loads.edges)
    plan.on.push_back("load on '" + load.boundary + "'");
  const bool plain = scene.element == "q4";
  if (plain && !stress && scene.material.poisson_ratio > 0.4)
    plan.notes.push_back(text("q4 locks for Poisson's ratio ", scene.material.poisson_ratio,
                              " in plane strain and bears too much load: use q4_bbar or q8"));
}

void plan_contact(const Scene& scene, Plan& plan) {
  plan.gaps.A.resize(0, plan.unknowns.count);
  if (!scene.contact) {
    plan.off.emplace_back("contact");
    return;
  }
  plan.gaps = node_to_obstacle(scene.mesh, scene.contact->boundary, scene.contact->obstacle,
                               plan.unknowns, scene.material.thickness);
  const Eigen::Index n_pairs = plan.gaps.initial_gap.size();
  plan.on.push_back(text("contact of '", scene.contact->boundary, "' with a rigid ",
                         scene.contact->obstacle.name, ": ", n_pairs,
                         " candidate pairs, no mesh and no search for the obstacle"));
  plan.on.push_back("solver " + scene.solver +
                    " on the condensed problem, certified from K, p, A, g");
  const double lowest = n_pairs > 0 ? plan.gaps.initial_gap.minCoeff() : 0;
  if (lowest < 0)
    plan.notes.push_back(text("the body overlaps the obstacle by ", -lowest, " before loading"));
}

}  // namespace

Plan plan(const Scene& scene) {
  Plan plan;
  plan.quality = check_mesh(scene.mesh);
  check_element(scene.mesh, find_element(scene.element));
  static_cast<void>(find_solver(scene.solver));
  check_material(scene.material);
  for (const EdgeLoad& load : scene.loads.edges) check_load(scene.mesh, load);
  plan.unknowns = number_unknowns(scene.mesh, scene.supports);
  plan_body(scene, plan);
  plan_contact(scene, plan);
  std::string free;
  for (const std::string& motion : free_motions(scene.mesh, plan.unknowns))
    free += (free.empty() ? "" : "; ") + motion;
  pose(free.empty(), free, ". Contact can only push and is not counted on: add a support");
  return plan;
}

std::ostream& operator<<(std::ostream& out, const Plan& plan) {
  for (const std::string& line : plan.on) out << "  on    " << line << '\n';
  for (const std::string& line : plan.off) out << "  off   " << line << '\n';
  for (const std::string& line : plan.notes) out << "  note  " << line << '\n';
  return out;
}

}  // namespace signorini
