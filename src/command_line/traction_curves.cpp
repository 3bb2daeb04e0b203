#include "command_line/traction_curves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "command_line/scene_run.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/pair_columns.hpp"
#include "signorini/scene/bodies.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;

/// Where the source of a contact begins; its first nodes may be held and have no pair. A relation begins with its first pair.
Eigen::RowVector2d start_of(const SceneRun& run, Index first) {
  const Model& model = *run.model;
  const std::size_t contact = model.contact_of[static_cast<std::size_t>(first)];
  if (model.contact_bodies[contact].acts_elsewhere) return model.pairs.position.row(first);
  const Side& source = run.file.scene.contacts[contact].source;
  const Mesh& mesh = model.bodies[body_index(model.bodies, source)].mesh;
  return mesh.nodes.row(boundary_nodes(mesh, source.boundary).front());
}

/// The bound on the shear traction of every pair; not a number where none is.
Eigen::VectorXd shear_bounds(const Model& model, const Solution& solution) {
  const FrictionLaw& law = model.law;
  Eigen::VectorXd bound =
      Eigen::VectorXd::Constant(solution.pressure.size(), std::numeric_limits<double>::quiet_NaN());
  Eigen::VectorXd cohesion = Eigen::VectorXd::Zero(bound.size());
  for (std::size_t k = 0; k < law.pair.size(); ++k) {
    const Index pair = law.pair[k], row = static_cast<Index>(k);
    bound(pair) = law.coefficient(row) * solution.pressure(pair);
    cohesion(pair) = law.cohesion(row) / model.pairs.weight(pair);
  }
  for (const Index pair : solution.contact.active()) bound(pair) += cohesion(pair);
  return bound;
}

}  // namespace

std::vector<TractionCurve> traction_curves(const SceneRun& run) {
  const Model& model = *run.model;
  const Pairs& pairs = model.pairs;
  const Eigen::VectorXd& pressure = run.solution->pressure;
  const Eigen::VectorXd shear = shear_tractions(model, *run.solution);
  const Eigen::VectorXd bound = shear_bounds(model, *run.solution);
  std::vector<TractionCurve> curves;
  for (Index first = 0, end; first < pressure.size(); first = end) {
    const std::size_t contact = model.contact_of[static_cast<std::size_t>(first)];
    TractionCurve curve;
    curve.name = model.contacts[contact];
    Eigen::AlignedBox<double, 1> closed;
    double way = 0;
    Eigen::RowVector2d before = start_of(run, first);
    for (end = first;
         end < pressure.size() && model.contact_of[static_cast<std::size_t>(end)] == contact;
         ++end) {
      way += (pairs.position.row(end) - before).norm();
      before = pairs.position.row(end);
      if (pressure(end) > 0) closed.extend(Eigen::Matrix<double, 1, 1>(way));
      curve.most = std::max(curve.most, pressure(end));
      curve.frictional = curve.frictional || !std::isnan(bound(end));
      curve.csv += shortest(way) + ',' + shortest(pressure(end));
      if (!std::isnan(bound(end)))
        curve.csv += ',' + shortest(shear(end)) + ',' + shortest(bound(end));
      curve.csv += '\n';
    }
    const double length = closed.isEmpty() ? 0 : closed.sizes()(0);
    const double margin = length > 0 ? length / 3 : way / 10;
    curve.from = closed.isEmpty() ? 0 : std::max(0.0, closed.min()(0) - margin);
    curve.to = closed.isEmpty() ? way : std::min(way, closed.max()(0) + margin);
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace command_line
