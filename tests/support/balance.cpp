#include "support/balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/rounding.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini_test {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace signorini;

/// Force and moment about a point.
struct Sum {
  Vector2d middle;
  double reach;
  Vector3d sum = Vector3d::Zero();
  double largest = 0;

  void add(const Vector2d& force, double moment_about_origin) {
    Vector3d part;
    part << force, moment_about_origin - (middle.x() * force.y() - middle.y() * force.x());
    sum += part;
    largest = std::max({largest, force.norm(), std::abs(part(2)) / reach});
  }
  void add(const NodeArray& nodes, const NodeArray& forces) {
    Sum all{middle, reach};
    for (Index k = 0; k < nodes.rows(); ++k) {
      const Vector2d x = nodes.row(k).transpose() - middle;
      const Vector2d f = forces.row(k).transpose();
      all.sum += Vector3d(f.x(), f.y(), x.x() * f.y() - x.y() * f.x());
    }
    sum += all.sum;
    largest = std::max({largest, all.sum.head(2).norm(), std::abs(all.sum(2)) / reach});
  }
};

/// What supports do where they hold.
NodeArray of_supports(const Model& model, const Solution& solution, std::size_t body) {
  NodeArray force = support_forces(model, solution, body);
  const BodyModel& own = model.bodies[body];
  for (Index node = 0; node < force.rows(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      if (own.unknowns.number(node, axis) >= 0) force(node, axis) = 0;
  return force;
}

/// What rounding makes of forces that are read from displacements.
double rounding(const Model& model, const Solution& solution, const BodyModel& own) {
  const auto& K = model.programme.stiffness;
  double stiffest = 0;
  for (Index j = own.first_unknown; j < own.first_unknown + own.unknowns.count; ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, j); it; ++it)
      stiffest = std::max(stiffest, std::abs(it.value()));
  const Eigen::VectorXd u = strained(solution.refined);
  const double moved =
      std::max(u.size() > 0 ? u.cwiseAbs().maxCoeff() : 0, own.unknowns.held.cwiseAbs().maxCoeff());
  return 64 * epsilon * stiffest * moved;
}

/// What no two doubles resolve: a gap or a displacement that is given has an error of 2^-106, which makes forces of that by the
/// stiffness of the scene, also where nothing is pressed and all forces are 0.
double unresolved(const Model& model) {
  const QuadraticProgramme& given = model.programme;
  const auto most = [](const auto& values) {
    return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
  };
  const double length = std::max(most(given.initial_gap), most(model.unknowns.held));
  const Eigen::VectorXd stiff = given.stiffness.diagonal();
  // Below the smallest double over epsilon numbers have lost digits.
  return std::max(0x1p-106 * std::max(most(stiff) * length, most(given.load)),
                  std::numeric_limits<double>::min() / epsilon);
}

}  // namespace

double unbalanced(const Model& model, const Solution& solution) {
  std::vector<Sum> bodies;
  double noise = 0;  // of any body: contact hands it on to the others
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& own = model.bodies[b];
    const Vector2d middle = own.mesh.nodes.colwise().mean().transpose();
    const double reach =
        (own.mesh.nodes.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
    bodies.push_back({middle, reach});
    const NodeArray& x = own.mesh.nodes;
    bodies[b].add(x, nodal_loads(own.mesh, own.element, own.material, own.loads));
    bodies[b].add(x, spring_forces(model, solution, b));
    bodies[b].add(x, of_supports(model, solution, b));
    noise = std::max(noise, rounding(model, solution, own));
  }
  const std::vector<Resultants> sums = resultants_of_contacts(model, solution);
  // what rounding of the places makes of moments about the origin
  std::vector<double> turned(bodies.size(), 0);
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const ContactBodies& sides = model.contact_bodies[k];
    bodies[sides.source].add(sums[k].force, sums[k].moment);
    turned[sides.source] += sums[k].normal_force + std::abs(sums[k].shear_force);
    if (!sides.target) continue;
    bodies[*sides.target].add(-sums[k].force, sums[k].target_moment);
    turned[*sides.target] += sums[k].normal_force + std::abs(sums[k].shear_force);
  }
  const bool axial = is_axial(model.bodies.front());
  const double smallest = unresolved(model);
  double worst = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int k = axial ? 1 : 0; k < (axial ? 2 : 3); ++k) {
      const double far = k == 2 ? bodies[b].middle.norm() / bodies[b].reach : 0;
      const double off = std::abs(bodies[b].sum(k)) / (k == 2 ? bodies[b].reach : 1);
      const double rounded = noise + 64 * epsilon * far * turned[b];
      if (!(off <= std::max(rounded, smallest)))
        worst = std::max(worst, (off - rounded) / bodies[b].largest);
      if (std::isnan(off)) return std::numeric_limits<double>::infinity();
    }
  return worst;
}

}  // namespace signorini_test
