#include "addons/estimate/outline.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "addons/estimate/bulges.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;

/// A boundary whose mean displacement is asked for.
struct Mean {
  std::string boundary;
  int axis;
  double area;
  double value;
};

std::optional<Mean> mean_of(const BodyModel& body, const Goal& goal, const NodeArray& u) {
  const auto* moved = std::get_if<Displacement>(&goal.quantity);
  const bool own = moved != nullptr && !moved->boundary.empty() &&
                   (moved->body.empty() || moved->body == body.mesh.name) &&
                   body.mesh.boundaries.count(moved->boundary) != 0;
  if (!own) return {};
  const VectorXd share = boundary_weights(body.mesh, moved->boundary, depth_of(body.material));
  const int axis = static_cast<int>(moved->axis);
  const VectorXd along = u(boundary_nodes(body.mesh, moved->boundary), axis);
  return Mean{moved->boundary, axis, share.sum(), share.dot(along) / share.sum()};
}

CellNodes nodal(const Cell& cell, const NodeArray& field) {
  CellNodes values(cell.element.n_nodes, 2);
  for (Index k = 0; k < values.rows(); ++k) values.row(k) = field.row(cell.node(k));
  return values;
}

/// The names of the boundaries that a side belongs to.
using NamesOfSide = std::map<std::pair<Index, int>, std::vector<std::string>>;

NamesOfSide names_of_sides(const Mesh& mesh) {
  NamesOfSide names;
  for (const auto& [name, sides] : mesh.boundaries)
    for (const CellSide& side : sides) names[{side.cell, side.side}].push_back(name);
  return names;
}

/// What a density on a boundary, force or share of a mean, does to a field.
template <typename Density>
double moved_to_curve(const Beside& at, const CellNodes& field, const Density& density) {
  return at.area_on_curve * density(at.place + at.way).dot(at.on_curve(field)) -
         at.area * density(at.place).dot(at.here(field));
}

/// The component along the normals of contact of what a field lacks between nodes, by the rise of the curve.
struct Lag {
  double nodes;   // where the nodes are held, which follow the curve
  double chords;  // where the mean over the sides is held
};

/// \param turning  by which the normals of contact turn, by that by which the curve does
Lag lag(const Beside& at, const CellNodes& field, const Vector2d& turning) {
  const Eigen::Matrix2d slopes = field.transpose() * at.gradient;
  const Vector2d along(-at.normal.y(), at.normal.x());
  const double stretch = along.dot(slopes * along);
  const double across = at.normal.dot(slopes * at.normal);
  const double bent = at.curvature * at.normal.dot(at.here(field));
  const Vector2d turned = turning * stretch;
  const Vector2d bend = turning.cwiseAbs2() * bent;
  return {2 * turned(0) - across - bend(0), bend(1) / 2 - turned(1) - across};
}

/// A field on the nodes of one cell.
struct CellField {
  CellNodes displacement;
  CellNodes pressure;
};

/// All that is needed to weigh bulges.
struct Weighing {
  const BodyModel& body;
  const SmoothStress& stress;
  const ContactOnNodes& contact;
  const std::vector<WholeField>& whole;
  std::vector<std::optional<Mean>> means;

  /// The recovered stress of a field at a place.
  [[nodiscard]] VectorXd smooth(const Cell& cell, const Beside& at, Index field) const {
    const Index n_rows = cell.body.D.rows();
    VectorXd sum = VectorXd::Zero(n_rows);
    for (Index k = 0; k < cell.element.n_nodes; ++k)
      sum += at.shape.value(k) * stress.value.row(stress.cells(cell.number, k))
                                     .segment(n_rows * field, n_rows)
                                     .transpose();
    return sum;
  }

  /// What the loads on a side, and in the body beside it, do to a dual solution.
  [[nodiscard]] double of_loads(const Beside& at, const CellNodes& z, double widening,
                                const std::vector<std::string>& names) const {
    double sum = 0;
    if (body.loads.body_force)
      sum += at.area * at.rise * body.loads.body_force(at.place).dot(at.here(z));
    for (const EdgeLoad& load : body.loads.edges) {
      if (std::find(names.begin(), names.end(), load.boundary) == names.end()) continue;
      const double share = load.share ? load.share(at.place) : 1;
      sum -= share * load.pressure * at.area * at.rise * widening;
      if (load.traction) sum += moved_to_curve(at, z, load.traction);
    }
    return sum;
  }

  /// What a mean displacement of the side itself changes by.
  [[nodiscard]] double of_mean(const Beside& at, const CellNodes& moved, const Mean& mean,
                               const std::vector<std::string>& names) const {
    if (std::find(names.begin(), names.end(), mean.boundary) == names.end()) return 0;
    const auto along = [&](const Vector2d&) -> Vector2d { return Vector2d::Unit(mean.axis); };
    return (moved_to_curve(at, moved, along) - mean.value * (at.area_on_curve - at.area)) /
           mean.area;
  }

  /// What contact lacks between nodes, and a mesh that it is with.
  static double of_contact(const Beside& at, const CellField& u, const CellField& z,
                           const Vector2d& turning) {
    const Vector2d pressure = at.here(u.pressure);
    const Vector2d dual = at.here(z.pressure);
    if (pressure.isZero(0) && dual.isZero(0)) return 0;
    const Lag of_u = lag(at, u.displacement, turning);
    const Lag of_z = lag(at, z.displacement, turning);
    return at.area * at.rise *
           (dual(0) * of_u.nodes + pressure(0) * of_z.nodes + dual(1) * (of_u.chords - 1) +
            pressure(1) * of_z.chords);
  }

  [[nodiscard]] VectorXd amount(const Cell& cell, const Bulge& bulge,
                                const std::vector<std::string>& names) const {
    const auto n_goals = static_cast<Index>(means.size());
    VectorXd sum = VectorXd::Zero(n_goals);
    const Elasticity compliance = cell.body.D.inverse();
    std::vector<CellField> of_cell;
    for (const WholeField& field : whole)
      of_cell.push_back({nodal(cell, field.displacement), nodal(cell, field.pressure)});
    const std::vector<Index> nodes = body.mesh.side_nodes(bulge.side);
    for (const Beside& at : places_beside(cell, bulge)) {
      const Vector2d turning = contact.turning(nodes[at.number], nodes[at.number + 1], at.angle);
      const VectorXd stressed = smooth(cell, at, 0);
      for (Index k = 0; k < n_goals; ++k) {
        const VectorXd strain = compliance * smooth(cell, at, k + 1);
        const double widening = strain(0) + strain(1) + (strain.size() == 4 ? strain(3) : 0);
        const CellField& z = of_cell[static_cast<std::size_t>(k + 1)];
        sum(k) += of_loads(at, z.displacement, widening, names) +
                  of_contact(at, of_cell.front(), z, turning) -
                  at.area * at.rise * stressed.dot(strain);
        if (const auto& mean = means[static_cast<std::size_t>(k)])
          sum(k) += of_mean(at, of_cell.front().displacement, *mean, names);
      }
    }
    return sum;
  }
};

}  // namespace

std::vector<OutlineShare> outline_shares(const BodyModel& body, const SmoothStress& stress,
                                         const ContactOnNodes& contact,
                                         const std::vector<WholeField>& whole,
                                         const std::vector<Goal>& goals) {
  const std::map<Index, std::vector<Bulge>> of_cell = bulges(body.mesh);
  std::vector<OutlineShare> shares;
  if (of_cell.empty()) return shares;
  Weighing weighing{body, stress, contact, whole, {}};
  for (const Goal& goal : goals)
    weighing.means.push_back(mean_of(body, goal, whole.front().displacement));
  const NamesOfSide names = names_of_sides(body.mesh);
  visit_cells(body.mesh, body.element, body.material, [&](const Cell& cell) {
    const auto found = of_cell.find(cell.number);
    if (found == of_cell.end()) return;
    for (const Bulge& bulge : found->second) {
      const auto named = names.find({cell.number, bulge.side.side});
      shares.push_back(
          {bulge.side,
           weighing.amount(cell, bulge,
                           named == names.end() ? std::vector<std::string>() : named->second)});
    }
  });
  return shares;
}

}  // namespace signorini
