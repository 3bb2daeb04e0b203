#include <ostream>
#include <set>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini {
namespace {

using Eigen::Index;

void check_names(const Scene& scene) {
  pose(!scene.bodies.empty(), "a scene needs at least one body");
  std::set<std::string> names;
  for (const Body& body : scene.bodies)
    pose(names.insert(body.mesh.name).second, "two bodies are called '", body.mesh.name,
         "': give every mesh a name of its own");
  static_cast<void>(find_solver(scene.solver));  // needed or not
}

void plan_body(const Body& body, Plan& plan) {
  const std::string& name = body.mesh.name;
  plan.quality.push_back(check_mesh(body.mesh));
  const Element& element = find_element(body.element);
  check_element(body.mesh, element);
  check_material(body.material);
  Unknowns unknowns = number_unknowns(body.mesh, body.supports, body.material.state);
  const Index count = unknowns.count;
  const PlaneState state = body.material.state;
  plan.on.push_back(text("body '", name, "': ", body.mesh.n_cells(), " cells ", body.element, ", ",
                         count, " unknowns, ", to_string(state)));
  plan.on.push_back(
      text("supports of '", name, "': ", 2 * body.mesh.n_nodes() - count, " displacements given"));
  if (body.element == "q4" && state != PlaneState::Stress && body.material.poisson_ratio > 0.4)
    plan.notes.push_back(text("q4 locks for Poisson's ratio ", body.material.poisson_ratio, " in ",
                              to_string(state),
                              " and bears too much load: use q4_bbar or q4_incompatible"));
  const bool first = plan.bodies.empty();
  const Index first_node = first ? 0 : count_nodes(plan.bodies);
  const Index first_unknown =
      first ? 0 : plan.bodies.back().first_unknown + plan.bodies.back().unknowns.count;
  plan.bodies.push_back({body.mesh, element, body.material, body.loads, std::move(unknowns),
                         first_node, first_unknown});
}

/// What supports leave: the unknowns of all bodies, and their rigid motions.
void plan_unknowns(Plan& plan) {
  std::vector<Unknowns> unknowns;
  for (const BodyModel& body : plan.bodies) unknowns.push_back(body.unknowns);
  plan.unknowns = joined(unknowns);
  for (const BodyModel& body : plan.bodies)
    for (FreeMotion& mode : free_motions(body.mesh, body.unknowns, body.material.state)) {
      const Eigen::VectorXd own = std::move(mode.shape);
      mode.shape.setZero(plan.unknowns.count);
      mode.shape.segment(body.first_unknown, own.size()) = own;
      plan.modes.push_back(std::move(mode));
    }
}

}  // namespace

Plan plan(const Scene& scene) {
  Plan plan;
  check_names(scene);
  for (const Body& body : scene.bodies) plan_body(body, plan);
  plan_unknowns(plan);
  plan.gaps.A.resize(0, plan.unknowns.count);
  plan.solver = scene.solver;
  for (const Effect& effect : effects())
    if (effect.present(scene, plan)) {
      effect.price(scene, plan);
      plan.effects.push_back(&effect);
    } else {
      plan.off.emplace_back(effect.name);
    }
  if (plan.gaps.A.rows() > 0)
    plan.on.push_back("solver " + plan.solver +
                      " on the condensed problem, certified from K, p, A, g");
  return plan;
}

std::ostream& operator<<(std::ostream& out, const Plan& plan) {
  for (const std::string& line : plan.on) out << "  on    " << line << '\n';
  for (const std::string& line : plan.off) out << "  off   " << line << '\n';
  for (const std::string& line : plan.notes) out << "  note  " << line << '\n';
  return out;
}

}  // namespace signorini
