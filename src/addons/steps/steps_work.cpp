#include "addons/steps/steps.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/eigenstrain.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

Eigen::Map<const VectorXd> flat(const NodeArray& values) { return {values.data(), values.size()}; }

/// Forces that strain a body and its springs to displacements, as if it had no eigenstrain.
NodeArray straining_forces(const BodyModel& body, const NodeArray& displacement) {
  MaterialField material = body.material;
  material.eigenstrain = {};
  NodeArray forces = internal_forces(body.mesh, body.element, material, displacement);
  if (body.springs.rows() > 0)
    Eigen::Map<VectorXd>(forces.data(), forces.size()) += body.springs * flat(displacement);
  return forces;
}

/// Loads and what stands for the eigenstrain, on all nodes.
NodeArray loading_forces(const BodyModel& body) {
  NodeArray forces = nodal_loads(body.mesh, body.element, body.material, body.loads);
  if (body.material.eigenstrain)
    forces += eigenstrain_forces(body.mesh, body.element, body.material);
  return forces;
}

/// What contact does to the nodes of all bodies.
VectorXd contact_forces(const Model& model, const VectorXd& force) {
  const Index pairs = model.pairs.weight.size();
  VectorXd nodal = model.pairs.opening.transpose() * force.head(pairs);
  if (!model.law.pair.empty())
    nodal += selected_rows(model.pairs.sliding, model.law.pair).transpose() *
             force.tail(force.size() - pairs);
  return nodal;
}

VectorXd interference_now(const Model& model, double time) {
  VectorXd sum = VectorXd::Zero(model.pairs.weight.size());
  for (const LoadPart& part : model.parts)
    sum += factor_of(model.path.histories, part.history, time) * part.interference;
  return sum;
}

/// The force between two steps times the displacement.
double mean_work(const NodeArray& last, const NodeArray& now, const NodeArray& moved) {
  return 0.5 * (last + now).cwiseProduct(moved).sum();
}

/// What supports do to the nodes that they hold.
/// \param pushed  contact forces on the nodes of all bodies
NodeArray support_forces(const BodyModel& body, const NodeArray& displacement,
                         const NodeArray& load, const VectorXd& pushed) {
  const NodeArray strains = straining_forces(body, displacement);
  NodeArray forces = NodeArray::Zero(strains.rows(), 2);
  for (Index node = 0; node < forces.rows(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      if (body.unknowns.number(node, axis) < 0)
        forces(node, axis) =
            strains(node, axis) - load(node, axis) - pushed(2 * (body.first_node + node) + axis);
  return forces;
}

}  // namespace

VectorXd WorkMeter::add_bodies(const Model& model, const Step& step) {
  const VectorXd pushed = contact_forces(model, step.state.solution.force);
  VectorXd moved(2 * count_nodes(model.bodies));
  work_.strain = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    Body now{step.solution.displacements[b], loading_forces(body), {}};
    now.support = support_forces(body, now.displacement, now.load, pushed);
    const Eigen::Map<const VectorXd> u = flat(now.displacement);
    const NodeArray change = now.displacement - bodies_[b].displacement;
    work_.loads += mean_work(bodies_[b].load, now.load, change);
    work_.supports += mean_work(bodies_[b].support, now.support, change);
    work_.strain += strain_energy(body.mesh, body.element, body.material, now.displacement);
    if (body.springs.rows() > 0) work_.strain += 0.5 * u.dot(body.springs * u);
    moved.segment(2 * body.first_node, u.size()) = u;
    bodies_[b] = std::move(now);
  }
  return moved;
}

void WorkMeter::add(const Model& model, const Step& step) {
  require_input(!model.loop,
                "WorkMeter: of bodies that move, whose pairs change, work is not added up");
  const VectorXd& force = step.state.solution.force;
  const VectorXd& gap = step.solution.contact.gap;
  const VectorXd interference = interference_now(model, step.state.time);
  const bool first = bodies_.empty();
  require_input(!first || step.state.steps == 1,
                "WorkMeter: sums begin at rest without loads, with step 1 of a path, got step ",
                step.state.steps, ": add every step from the beginning");
  if (first)
    for (const BodyModel& body : model.bodies) {
      const NodeArray zero = NodeArray::Zero(body.mesh.n_nodes(), 2);
      bodies_.push_back({zero, zero, zero});
    }
  const VectorXd moved = add_bodies(model, step);
  if (first) {
    force_.setZero(force.size());
    interference_.setZero(gap.size());
    gap_ = gap - model.pairs.opening * moved + interference;  // of the meshes
  }
  const VectorXd lambda = force.head(gap.size());
  const VectorXd last_lambda = force_.head(gap.size());
  const VectorXd& slip = step.state.increment;
  work_.contacts += 0.5 * (lambda + last_lambda).dot(interference - interference_);
  work_.dissipation = step.state.dissipation.sum();
  work_.between += 0.5 * (force - force_).tail(slip.size()).dot(slip) +
                   0.5 * (lambda.dot(gap_) - last_lambda.dot(gap));
  force_ = force;
  gap_ = gap;
  interference_ = interference;
}

}  // namespace signorini
