/// \file
/// Chapter 12 - what is read off the solved disc.
#pragma once
#include <algorithm>
#include <vector>

#include "closed_form/disc_between_plates.hpp"
#include "scene.hpp"
#include "signorini/fem/stress.hpp"

namespace ch12 {

/// \param depth  on the loaded diameter, from the lower contact [mm]
/// \return stress across it between plates, exact [MPa]
inline double exact_across(double depth) {
  return plate_loaded_disc_stress(plate, R, 0, depth - R)[0];
}

/// Stress of the disc on the loaded diameter, from the lower contact up to the upper one.
struct Diameter {
  Eigen::VectorXd depth;  ///< y, from the lower contact [mm]
  StressArray stress;     ///< of the nodes there [MPa]
};

/// \param run  solved \return stress at the nodes on the axis of the disc
inline Diameter diameter_of(const SolvedScene& run) {
  const BodyModel& body = run.model.bodies[0];
  const StressArray stress =
      nodal_stress(body.mesh, body.element, body.material, run.solution.displacements[0]);
  std::vector<Index> nodes = boundary_nodes(body.mesh, "axis");
  const auto y = [&body](Index node) { return body.mesh.nodes(node, 1); };
  std::sort(nodes.begin(), nodes.end(), [&y](Index i, Index k) { return y(i) < y(k); });
  return {body.mesh.nodes(nodes, 1), stress(nodes, Eigen::all)};
}

/// \param axis  of the disc \return depth where compression turns into tension, between two nodes [mm]
inline double sign_change(const Diameter& axis) {
  Index k = 1;
  while (k + 1 < axis.depth.size() && axis.stress(k, 0) < 0) ++k;
  const double before = axis.stress(k - 1, 0), after = axis.stress(k, 0);
  return axis.depth(k - 1) - (axis.depth(k) - axis.depth(k - 1)) * before / (after - before);
}

/// \param run  solved \return stress at the node in the middle of the disc [MPa]
inline Eigen::Vector3d middle(const SolvedScene& run) {
  const Diameter axis = diameter_of(run);
  Index at = 0;
  (axis.depth.array() - R).abs().minCoeff(&at);
  return axis.stress.row(at).head<3>();
}

/// \param run  solved \return number of nodes of all bodies
inline Index nodes_of(const SolvedScene& run) {
  Index sum = 0;
  for (const BodyModel& body : run.model.bodies) sum += body.mesh.n_nodes();
  return sum;
}

/// \param run  solved
/// \return largest error of the stress across, from 2 b below one contact to 2 b from the other, over
///   2P/(pi d) [-]
inline double axis_error(const SolvedScene& run) {
  const Diameter axis = diameter_of(run);
  double worst = 0;
  for (Index k = 0; k < axis.depth.size(); ++k)
    if (axis.depth(k) >= 2 * b && axis.depth(k) <= 2 * R - 2 * b)
      worst = std::max(worst, std::abs(axis.stress(k, 0) - exact_across(axis.depth(k))));
  return worst / strength;
}

/// The force of the disc above a cut along cell sides on the disc below it.
/// \param run     solved
/// \param height  cells with a lower middle are below the cut [mm]
/// \return force of the half model on the part below, down > 0 [N/mm]
// [cut]
inline double force_across(const SolvedScene& run, double height) {
  const BodyModel& body = run.model.bodies[0];
  std::vector<Index> below;
  Eigen::VectorXi side = Eigen::VectorXi::Zero(body.mesh.n_nodes());  // 1 below, 2 above, 3 both
  for (Index cell = 0; cell < body.mesh.n_cells(); ++cell) {
    const bool low = cell_nodes(body.mesh, cell).col(1).mean() < height;
    if (low) below.push_back(cell);
    for (const Index node : body.mesh.cells.row(cell)) side(node) |= low ? 1 : 2;
  }
  Mesh part = body.mesh;
  part.cells = body.mesh.cells(below, Eigen::all).eval();
  const NodeArray force =
      internal_forces(part, body.element, body.material, run.solution.displacements[0]);
  double sum = 0;
  for (Index node = 0; node < force.rows(); ++node)
    if (side(node) == 3) sum -= force(node, 1);
  return sum;
}
// [cut]

/// Pressures of one contact, from the axis outwards.
struct Contact {
  std::vector<double> x, pressure, force;  ///< of its pairs [mm], [MPa], [N/mm]
};

/// \param run    solved
/// \param upper  of the two contacts
/// \return its pairs, sorted
inline Contact contact_of(const SolvedScene& run, bool upper) {
  const Pairs& pairs = run.model.pairs;
  std::vector<Index> mine;
  for (Index k = 0; k < pairs.normal.rows(); ++k)
    if ((pairs.normal(k, 1) < 0) == upper) mine.push_back(k);  // out of the plate
  std::sort(mine.begin(), mine.end(),
            [&](Index i, Index k) { return pairs.position(i, 0) < pairs.position(k, 0); });
  Contact out;
  for (const Index k : mine) {
    out.x.push_back(pairs.position(k, 0));
    out.pressure.push_back(run.solution.pressure(k));
    out.force.push_back(run.solution.contact.force(k));
  }
  return out;
}

}  // namespace ch12
