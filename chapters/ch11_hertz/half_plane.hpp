/// \file
/// Hertz's contact without any other error than that of the mesh: a rigid parabola on a square cut out of the half-plane, with
/// the stresses of M'Ewen on the two cuts.
#pragma once
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "closed_form/hertz.hpp"
#include "closed_form/hertz_fit.hpp"
#include "closed_form/moduli.hpp"
#include "meshes/split.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/cells.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {

/// The disc of the example made rigid, and the plate a half-plane: lengths in mm, forces in N.
inline const Material of_half_plane = {4000, 0.35, PlaneState::Strain, 1};
inline const LineContact parabola = {50, plane_strain_modulus(4000, 0.35), 41.76};

/// Relative errors of one mesh.
struct OrderErrors {
  double energy = 0;      ///< of the displacements, in the norm of the strain energy [-]
  double pressure = 0;    ///< of the line through the nodal pressures, in L2 [-]
  double half_width = 0;  ///< of the second moment, with its sign [-]
};

/// The right half of the square, its surface at y = 0. Nothing holds it along y but the parabola.
/// \param element  of the cells, which are squares or their halves \param edges  of cells on the half-width of the contact
/// \return the scene
// [square]
inline Scene parabola_on_square(const std::string& element, double edges) {
  const Element& kind = find_element(element);
  const double h = hertz_half_width(parabola) / edges;
  const Eigen::Index cells = 2 * static_cast<Eigen::Index>(edges);
  const double side = h * static_cast<double>(cells);  // nearly 2 b
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("half-plane", {0, -side}, {side, side}, cells, cells,
                    kind.n_nodes > 4 ? MeshOrder::Quadratic : MeshOrder::Linear);
  if (kind.corners() == 3) body.mesh = split(body.mesh);
  body.element = element;
  body.material = of_half_plane;
  body.supports = {symmetric("left")};
  const auto cut = [](double nx, double ny) {  // the traction of the half-plane on a cut
    return [nx, ny](const Eigen::Vector2d& at) {
      const Eigen::Vector3d s = hertz_stress(parabola, at.x(), -at.y());
      return Eigen::Vector2d(s(0) * nx + s(2) * ny, s(2) * nx + s(1) * ny);
    };
  };
  body.loads.edges = {{"right", 0, cut(1, 0)}, {"bottom", 0, cut(0, -1)}};
  const auto above = [](const Eigen::Vector2d& at) {
    const double height = at.x() * at.x() / (2 * parabola.radius);
    return ObstacleContact{height - at.y(), {0, -1}};
  };
  scene.contacts = {{{"top"}, Obstacle{"parabola", above, /*linear*/ true}}};
  return scene;
}
// [square]

/// \param stress  (xx, yy, xy) \return twice the energy per volume that it stores in plane strain [force/length^2]
inline double stored(const Eigen::Vector3d& stress) {
  const double nu = of_half_plane.poisson_ratio;
  return ((stress(0) * stress(0) + stress(1) * stress(1) -
           2 * nu / (1 - nu) * stress(0) * stress(1)) *
              (1 - nu * nu) +
          2 * (1 + nu) * stress(2) * stress(2)) /
         of_half_plane.youngs_modulus;
}

/// \param run  solved \return the error of the displacements in the norm of the strain energy, over that of the solution [-]
inline double energy_error(const SolvedScene& run) {
  const BodyModel& body = run.model.bodies[0];
  double error = 0, whole = 0;
  StrainPoints points;
  // [energy]
  visit_cells(body.mesh, body.element, body.material, [&](const Cell& cell) {
    if (cell.element.relax != nullptr)  // strains of internal modes are known at its own points
      cell.element.strain(cell.body, points);
    else
      sample_strain(cell.element.shape, gauss_cell(cell.element), cell.body, points);
    const CellVector u = gathered(cell, run.solution.displacements[0]);
    for (int k = 0; k < points.size; ++k) {
      const StrainPoint& point = points.point[static_cast<std::size_t>(k)];
      const Eigen::Vector2d at = position(cell, point);
      const Eigen::Vector3d exact = hertz_stress(parabola, at.x(), -at.y());
      const Eigen::Vector3d off = cell.body.D * (point.B * u) - exact;
      error += point.volume * stored(off);
      whole += point.volume * stored(exact);
    }
  });
  // [energy]
  return std::sqrt(error / whole);
}

/// \param x  of the nodes, rising from 0 \param pressure  at them
/// \return the error of the line through them, in L2 over that of Hertz's ellipse [-]
inline double pressure_error(const std::vector<double>& x, const std::vector<double>& pressure) {
  const double b = hertz_half_width(parabola);
  double error = 0;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    std::vector<double> ends = {x[k], x[k + 1]};
    if (x[k] < b && b < x[k + 1]) ends = {x[k], b, x[k + 1]};  // the root ends inside
    for (std::size_t part = 0; part + 1 < ends.size(); ++part)
      for (const GaussPoint& gauss : gauss_line(16)) {
        const double half = (ends[part + 1] - ends[part]) / 2;
        const double at = ends[part] + half * (1 + gauss.xi);
        const double share = (at - x[k]) / (x[k + 1] - x[k]);
        const double line = (1 - share) * pressure[k] + share * pressure[k + 1];
        error += half * gauss.weight * std::pow(line - hertz_pressure(parabola, at), 2);
      }
  }
  return std::sqrt(error / (2 * b / 3)) / hertz_peak_pressure(parabola);  // of the ellipse: 2 b q0^2 / 3
}

/// \param element  of the cells \param edges  of cells on the half-width \return the errors of one mesh
inline OrderErrors order_errors(const std::string& element, double edges) {
  const SolvedScene run = solved(parabola_on_square(element, edges), "the parabola");
  const BoundaryForces side = boundary_forces(run, {"top"});
  std::vector<std::size_t> order(static_cast<std::size_t>(side.weight.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto x_of = [&](std::size_t k) { return side.position(static_cast<Eigen::Index>(k), 0); };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return x_of(a) < x_of(b); });
  std::vector<double> x, force, pressure;
  for (const std::size_t k : order) {
    x.push_back(x_of(k));
    force.push_back(-side.force(static_cast<Eigen::Index>(k), 1));
    pressure.push_back(force.back() / side.weight(static_cast<Eigen::Index>(k)));
  }
  const bool quadratic = run.model.bodies[0].mesh.order() == MeshOrder::Quadratic;
  const double b =
      half_width_of_forces(x, force, quadratic ? Trace::Quadratic : Trace::Linear);
  return {energy_error(run), pressure_error(x, pressure), b / hertz_half_width(parabola) - 1};
}

/// \param edges  on the half-width, of some sizes of cells \param errors  of each \param error  one of the three
/// \return with which power of the cell it falls: the slope of the line that fits the logarithms best [-]
inline double slope(const std::vector<double>& edges, const std::vector<OrderErrors>& errors,
                    double OrderErrors::*error) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const double n = static_cast<double>(edges.size());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const double size = -std::log(edges[k]), value = std::log(errors[k].*error);
    x += size / n;
    y += value / n;
    xx += size * size / n;
    xy += size * value / n;
  }
  return (xy - x * y) / (xx - x * x);
}

}  // namespace signorini
