/// \file
/// Stresses below the contact of the example, for tables and figures.
#pragma once
#include <string>
#include <vector>

#include "signorini/closed_form/hertz.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/report/field_csv.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {

/// Stress at the nodes of the line of symmetry of one body.
struct AxisStress {
  Eigen::VectorXd depth;          ///< from the contact [mm], not sorted
  Eigen::VectorXd xx, yy, shear;  ///< at these nodes [MPa]; shear = (xx - yy) / 2
  LargestShear largest;           ///< vertex of the parabola through the three nodes around it

  /// Data of a figure. \param end  depth of the last node [mm] \return one row per node
  [[nodiscard]] std::string csv(double end) const {
    Table table({"depth", "xx", "yy", "shear"});
    for (Eigen::Index k = 0; k < depth.size(); ++k)
      if (depth(k) <= end) table.row({depth(k), xx(k), yy(k), shear(k)});
    return table.csv("rel 1e-6 abs 1e-6");
  }
};

/// \param run   a solved example \param body  0 the disc, 1 the plate
/// \return stress along its axis
inline AxisStress along_axis(const SolvedScene& run, std::size_t body) {
  const BodyModel& model = run.model.bodies[body];
  const std::vector<Eigen::Index> nodes = boundary_nodes(model.mesh, "axis");
  const StressArray all =
      nodal_stress(model.mesh, model.element, model.material, run.solution.displacements[body]);
  AxisStress axis;
  axis.depth = model.mesh.nodes(nodes, 1).cwiseAbs();
  axis.xx = all(nodes, 0);
  axis.yy = all(nodes, 1);
  axis.shear = (axis.xx - axis.yy) / 2;
  Eigen::Index k = 0;
  axis.shear.segment(1, axis.shear.size() - 2).maxCoeff(&k);
  ++k;
  const double before = axis.depth(k - 1) - axis.depth(k);
  const double after = axis.depth(k + 1) - axis.depth(k);
  const double rise = (axis.shear(k - 1) - axis.shear(k)) / before;
  const double fall = (axis.shear(k + 1) - axis.shear(k)) / after;
  const double bend = (fall - rise) / (after - before);
  const double slope = rise - bend * before;
  axis.largest = {axis.depth(k) - slope / (2 * bend), axis.shear(k) - slope * slope / (4 * bend)};
  return axis;
}

/// Deformed cells next to the contact with their largest shear stress.
/// \param run     a solved example
/// \param body    0 the disc, 1 the plate
/// \param extent  cells with a corner inside a square of this half width are drawn [mm]
/// \return data of a figure
inline std::string shear_near_contact(const SolvedScene& run, std::size_t body, double extent) {
  const BodyModel& model = run.model.bodies[body];
  const NodeArray& u = run.solution.displacements[body];
  const StressArray stress = cell_stress(model.mesh, model.element, model.material, u);
  const Eigen::VectorXd shear =
      (((stress.col(0) - stress.col(1)) / 2).array().square() + stress.col(2).array().square())
          .sqrt();
  std::vector<Eigen::Index> near;
  for (Eigen::Index cell = 0; cell < model.mesh.n_cells(); ++cell)
    for (Eigen::Index corner = 0; corner < 4; ++corner)
      if (model.mesh.nodes.row(model.mesh.cells(cell, corner)).cwiseAbs().maxCoeff() < extent) {
        near.push_back(cell);
        break;
      }
  Mesh part = model.mesh;
  part.boundaries.clear();
  part.cells = CellArray(model.mesh.cells(near, Eigen::all));
  return deformed_cells_csv(part, u, shear(near));
}

}  // namespace signorini
