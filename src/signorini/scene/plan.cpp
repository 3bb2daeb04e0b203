#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "signorini/contact/node_to_obstacle.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/scene.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

void check_load(const Mesh& mesh, const EdgeLoad& load) {
  static_cast<void>(boundary(mesh, load.boundary));
  pose(std::isfinite(load.pressure), "load on '", load.boundary, "': the pressure ", load.pressure,
       " is not finite");
}

void plan_body(const Body& body, Plan& plan) {
  const std::string& name = body.mesh.name;
  plan.quality.push_back(check_mesh(body.mesh));
  check_element(body.mesh, find_element(body.element));
  check_material(body.material);
  for (const EdgeLoad& load : body.loads.edges) check_load(body.mesh, load);
  plan.unknowns.push_back(number_unknowns(body.mesh, body.supports));
  const Index count = plan.unknowns.back().count;
  const bool stress = body.material.state == PlaneState::Stress;
  plan.on.push_back(text("body '", name, "': ", body.mesh.n_cells(), " cells ", body.element, ", ",
                         count, " unknowns, plane ", stress ? "stress" : "strain"));
  plan.on.push_back(
      text("supports of '", name, "': ", 2 * body.mesh.n_nodes() - count, " displacements given"));
  (body.loads.body_force ? plan.on : plan.off).push_back("body force on '" + name + "'");
  if (body.loads.edges.empty()) plan.off.push_back("edge loads on '" + name + "'");
  for (const EdgeLoad& load : body.loads.edges)
    plan.on.push_back("load on '" + load.boundary + "' of '" + name + "'");
  if (body.element == "q4" && !stress && body.material.poisson_ratio > 0.4)
    plan.notes.push_back(
        text("q4 locks for Poisson's ratio ", body.material.poisson_ratio,
             " in plane strain and bears too much load: use q4_bbar or q4_incompatible"));
}

void check_names(const Scene& scene) {
  pose(!scene.bodies.empty(), "a scene needs at least one body");
  std::set<std::string> names;
  for (const Body& body : scene.bodies)
    pose(names.insert(body.mesh.name).second, "two bodies are called '", body.mesh.name,
         "': give every mesh a name of its own");
}

/// Looks up all names, needed or not, and notes choices of a contact that nothing asks for.
void check_choices(const Scene& scene, Plan& plan) {
  static_cast<void>(find_solver(scene.solver));
  static_cast<void>(find_solver(scene.friction_solver));
  const ContactSpec usual;
  for (const ContactSpec& contact : scene.contacts) {
    const GapOperator& gap_operator = find_gap_operator(contact.gap_operator);
    const bool rigid = std::holds_alternative<Obstacle>(contact.target);
    std::string idle = rigid && contact.gap_operator != usual.gap_operator ? ", gap_operator" : "";
    if (contact.points != usual.points && (rigid || !gap_operator.takes_points)) idle += ", points";
    if (contact.quadrature != usual.quadrature && (rigid || !gap_operator.takes_quadrature))
      idle += ", quadrature";
    if (!idle.empty())
      plan.notes.push_back(text(describe(scene, contact), ": without meaning for ",
                                rigid ? "a rigid obstacle" : contact.gap_operator, ": ",
                                idle.substr(2)));
  }
}

/// Pairs of one contact, and a note if some nodes have none.
Pairs pair_up(const Scene& scene, const ContactSpec& contact, bool sliding, Plan& plan) {
  const Surface source = surface(scene, contact.source);
  const Body& body = scene.bodies[body_index(scene, contact.source)];
  GapOptions options;
  options.n_nodes = count_nodes(scene);
  options.thickness = body.material.thickness;
  options.sliding = sliding;
  options.points = contact.points;
  options.quadrature = contact.quadrature;
  if (const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target)) {
    return node_to_obstacle(source, *obstacle, options);
  }
  const Side& side = std::get<Side>(contact.target);
  const Body& other = scene.bodies[body_index(scene, side)];
  pose(body.material.thickness == other.material.thickness, describe(scene, contact),
       ": the bodies are ", body.material.thickness, " and ", other.material.thickness,
       " thick, but contact in the plane needs one thickness");
  Pairs pairs = find_gap_operator(contact.gap_operator).pair(source, surface(scene, side), options);
  if (!pairs.unpaired.empty())
    plan.notes.push_back(text(describe(scene, contact), ": ", pairs.unpaired.size(),
                              " source nodes face no target and are left out, the first is node ",
                              pairs.unpaired.front()));
  return pairs;
}

/// Whether a contact has friction. A law that allows no friction force is none.
bool rubs(const ContactSpec& contact) {
  return contact.friction &&
         (contact.friction->coefficient != 0 || contact.friction->cohesion != 0);
}

VectorXd extended(const VectorXd& head, const VectorXd& tail) {
  VectorXd both(head.size() + tail.size());
  both << head, tail;
  return both;
}

/// 0 for pairs that supports keep from sliding, else 1: friction between two supports could be anything, so
/// it is none and all of it counts as theirs.
VectorXd can_slide(const Gaps& gaps) {
  VectorXd slides(gaps.initial_slip.size());
  for (Index pair = 0; pair < slides.size(); ++pair)
    slides(pair) = gaps.initial_slip(pair) != 0 || gaps.T.row(pair).norm() > 0 ? 1 : 0;
  return slides;
}

void add_friction(const Scene& scene, const ContactSpec& contact, const Gaps& gaps, Plan& plan) {
  const Friction law = contact.friction.value_or(Friction{});
  for (const auto& [name, value] :
       {std::pair("friction coefficient", law.coefficient), std::pair("cohesion", law.cohesion)})
    pose(std::isfinite(value) && value >= 0, describe(scene, contact), ": the ", name,
         " must be a number >= 0, got ", value);
  FrictionLaw& all = plan.law;
  const VectorXd slides = can_slide(gaps);
  for (Index k = 0; k < slides.size(); ++k) all.pair.push_back(static_cast<Index>(all.pair.size()));
  all.coefficient = extended(all.coefficient, law.coefficient * slides);
  all.cohesion = extended(all.cohesion, law.cohesion * gaps.pairs.weight.cwiseProduct(slides));
  if (rubs(contact))
    plan.on.push_back(text("friction of the ", describe(scene, contact), ": coefficient ",
                           law.coefficient, ", cohesion ", law.cohesion, ", ",
                           gaps.pairs.weight.size(), " slips"));
}

void plan_contact(const Scene& scene, Plan& plan) {
  const Unknowns unknowns = joined(plan.unknowns);
  plan.gaps.A.resize(0, unknowns.count);
  plan.gaps.pairs.opening.resize(0, 2 * count_nodes(scene));
  plan.gaps.pairs.sliding.resize(0, 2 * count_nodes(scene));
  plan.solver = scene.solver;
  if (scene.contacts.empty()) {
    plan.off.emplace_back("contact");
    return;
  }
  const bool sliding = std::any_of(scene.contacts.begin(), scene.contacts.end(), rubs);
  if (!sliding) plan.off.emplace_back("friction");
  for (const ContactSpec& contact : scene.contacts) {
    Gaps gaps = reduce(pair_up(scene, contact, sliding, plan), surface(scene, contact.source),
                       unknowns, describe(scene, contact));
    plan.on.push_back(text(describe(scene, contact), ": ", gaps.pairs.weight.size(),
                           " candidate pairs",
                           std::holds_alternative<Obstacle>(contact.target)
                               ? ", no mesh and no search for the obstacle"
                               : " by " + contact.gap_operator));
    if (sliding) add_friction(scene, contact, gaps, plan);
    plan.gaps = stacked(plan.gaps, gaps);
  }
  if (sliding) plan.solver = scene.friction_solver;
  plan.on.push_back("solver " + plan.solver +
                    " on the condensed problem, certified from K, p, A, g");
  const VectorXd& initial_gap = plan.gaps.pairs.initial_gap;
  const double lowest = initial_gap.size() > 0 ? initial_gap.minCoeff() : 0;
  if (lowest < 0)
    plan.notes.push_back(text("the two sides overlap by ", -lowest, " before loading"));
}

/// What contact can stop: gaps from closing, and with friction slips, but not those of smooth contacts.
NodalRows felt_by_contact(const Plan& plan) {
  if (plan.law.pair.empty()) return plan.gaps.A;
  const VectorXd law = plan.law.coefficient + plan.law.cohesion;
  const VectorXd rough = (law.array() > 0).cast<double>();
  return below(plan.gaps.A, NodalRows(rough.asDiagonal() * plan.gaps.T));
}

/// Rigid motions that no support forbids are unknowns if contact can stop them, and errors if not.
void plan_modes(const Scene& scene, Plan& plan) {
  const std::vector<Index> first = first_unknowns(plan.unknowns);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (FreeMotion& mode : free_motions(scene.bodies[b].mesh, plan.unknowns[b])) {
      const Eigen::VectorXd own = std::move(mode.shape);
      mode.shape.setZero(plan.gaps.A.cols());
      mode.shape.segment(first[b], own.size()) = own;
      plan.on.push_back(mode.sentence + ": only contact holds it, one amplitude");
      plan.modes.push_back(std::move(mode));
    }
  const std::vector<std::string> loose = motions_without_contact(felt_by_contact(plan), plan.modes);
  std::string all;
  for (const std::string& motion : loose) all += (all.empty() ? "" : "; ") + motion;
  pose(loose.empty(), all,
       scene.contacts.empty() ? ": add a support" : ", and no contact stops that: add a support");
}

}  // namespace

Plan plan(const Scene& scene) {
  Plan plan;
  check_names(scene);
  for (const Body& body : scene.bodies) plan_body(body, plan);
  check_choices(scene, plan);
  plan_contact(scene, plan);
  plan_modes(scene, plan);
  return plan;
}

std::ostream& operator<<(std::ostream& out, const Plan& plan) {
  for (const std::string& line : plan.on) out << "  on    " << line << '\n';
  for (const std::string& line : plan.off) out << "  off   " << line << '\n';
  for (const std::string& line : plan.notes) out << "  note  " << line << '\n';
  return out;
}

}  // namespace signorini
