/// \file
/// Data of the figures: sketch, load history, deformed rings, two nodes that meet, stresses through both walls.
#pragma once
#include <algorithm>

#include "readings.hpp"
#include "rings.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/field_csv.hpp"
#include "signorini/report/program.hpp"

namespace ch14 {

/// Loads from nothing to the paper's: figure 14.2.
inline void load_history(const std::filesystem::path& out, signorini::Results& results) {
  signorini::Table exact({"p", "gap", "pressure"});
  signorini::Table mesh({"p", "gap", "pressure"});
  Rings rings;
  for (const double p : {0., 20., 40., 60., 72., 73., 80., 100., 120., 140., 160., 180.}) {
    rings.pressure = p;
    const signorini::SolvedScene now = run_of(rings);
    const double gap = now.solution.contact.gap.mean();
    mesh.row({p, std::abs(gap) < 1e-12 ? 0 : gap, now.solution.pressure.mean()});
    if (p != 72 && p != 73) continue;
    results.add(signorini::text("closed_at_", p),
                static_cast<double>(now.solution.contact.active.size()), "-");
    results.add(signorini::text("p_at_", p), now.solution.pressure.mean(), "MPa");
  }
  for (const double p : {0., closing_pressure(closed_form(rings)), 180.}) {
    rings.pressure = p;
    const signorini::NestedRings now = closed_form(rings);
    const signorini::NestedPressure on = nested_pressure(now);
    const double closed = ring_displacement(now.inner, on.inner, now.inner.outer_radius) -
                          ring_displacement(now.outer, on.outer, now.outer.inner_radius);
    exact.row({p, std::max(ring_clearance(now) - closed, 0.), on.inner.outside});
  }
  signorini::write_file(out / "fig_14_2.csv", exact.csv());
  signorini::write_file(out / "fig_14_2_mesh.csv", mesh.csv());
}

/// The pictures show the gap and all displacements so many times as large as they are.
const double magnified = 20;

/// A ring as it is drawn before loading: the rock is shifted outwards, so that the gap is magnified as well.
inline signorini::Mesh drawn(const signorini::BodyModel& body) {
  signorini::Mesh mesh = body.mesh;
  if (mesh.name != "rock") return mesh;
  const double shift = (magnified - 1) * (Rings().radii[2] - Rings().radii[1]);
  for (auto node : mesh.nodes.rowwise()) node *= 1 + shift / node.norm();
  return mesh;
}

/// Figure 14.1: the rims of the sketch and the cells of the mesh, with the magnified gap.
inline void sketch(const std::filesystem::path& out, const signorini::SolvedScene& now) {
  signorini::Table rims({"x", "y"});
  for (const signorini::BodyModel& body : now.model.bodies) {
    const signorini::Mesh mesh = drawn(body);
    for (const char* rim : {"inner", "outer"}) {
      const double radius = mesh.nodes.row(boundary_nodes(mesh, rim).front()).norm();
      for (int k = 0; k <= 45; ++k)
        rims.row(
            {radius * std::cos(k * quarter_turn / 45), radius * std::sin(k * quarter_turn / 45)});
      rims.blank_line();
    }
    signorini::write_file(
        out / signorini::text("fig_14_1_", mesh.name, ".csv"),
        deformed_cells_csv(mesh, 0 * mesh.nodes, Eigen::VectorXd::Zero(mesh.n_cells())));
  }
  signorini::write_file(out / "fig_14_1.csv", rims.csv());
}

/// Figure 14.3: |u|, u_x, u_y and sigma_xx on the deformed rings, in bands.
inline void fields(const std::filesystem::path& out, const signorini::SolvedScene& now) {
  for (const std::size_t k : {0, 1}) {
    const signorini::BodyModel& body = now.model.bodies[k];
    const signorini::NodeArray& u = now.solution.displacements[k];
    const signorini::Mesh mesh = drawn(body);
    const auto write = [&](const char* name, const Eigen::VectorXd& value,
                           const Eigen::VectorXd& levels) {
      signorini::write_file(out / signorini::text("fig_14_3_", name, "_", mesh.name, ".csv"),
                            deformed_bands_csv(mesh, u, value, levels, magnified));
    };
    write("u", u.rowwise().norm(), Eigen::VectorXd::LinSpaced(11, 0.1, 0.3));
    write("ux", u.col(0), Eigen::VectorXd::LinSpaced(11, 0, 0.3));
    write("uy", u.col(1), Eigen::VectorXd::LinSpaced(11, 0, 0.3));
    write("sxx", nodal_stress(body.mesh, body.element, body.material, u).col(0),
          Eigen::VectorXd::LinSpaced(14, -200, 1100));
    signorini::write_file(
        out / signorini::text("fig_14_3_", mesh.name, ".csv"),
        deformed_cells_csv(mesh, u, Eigen::VectorXd::Zero(mesh.n_cells()), /*scale*/ 0));
  }
}

/// Figure 14.4: where the rims are around 40 degrees, before and after.
inline void meeting_rims(const std::filesystem::path& out, const signorini::SolvedScene& now) {
  signorini::Table rims({"x", "y", "x_moved", "y_moved"});
  for (const std::size_t body : {0, 1}) {
    const signorini::Mesh& mesh = now.model.bodies[body].mesh;
    const signorini::NodeArray& u = now.solution.displacements[body];
    for (const int ray : {3, 4, 5}) {
      const Index k = nearest(mesh, body == 0 ? 68 : 68.15, ray * quarter_turn / 9);
      rims.row({mesh.nodes(k, 0), mesh.nodes(k, 1), mesh.nodes(k, 0) + u(k, 0),
                mesh.nodes(k, 1) + u(k, 1)});
    }
    rims.blank_line();
  }
  signorini::write_file(out / "fig_14_4.csv", rims.csv());
}

/// Figure 14.5: stresses through both walls. \return largest deviation from the closed form
inline double stresses_through_walls(const std::filesystem::path& out,
                                     const signorini::SolvedScene& now) {
  const signorini::NestedRings exact = closed_form({});
  const signorini::NestedPressure on = nested_pressure(exact);
  signorini::Table cells({"r", "radial", "hoop"});
  signorini::Table curves({"r", "radial", "hoop"});
  double worst = 0;
  for (const std::size_t body : {0, 1}) {
    const signorini::Ring& ring = body == 0 ? exact.inner : exact.outer;
    const signorini::RingPressure& load = body == 0 ? on.inner : on.outer;
    const CellStresses mean = cell_stresses(now, body);
    for (Index k = 0; k < Rings().cells_radius; ++k) {  // of one ray: all nine are the same
      cells.row({mean.radius(k), mean.radial(k), mean.hoop(k)});
      const signorini::RingStress lame = ring_stress(ring, load, mean.radius(k));
      worst = std::max(
          {worst, std::abs(lame.radial - mean.radial(k)), std::abs(lame.hoop - mean.hoop(k))});
    }
    const Eigen::VectorXd radii =
        Eigen::VectorXd::LinSpaced(41, ring.inner_radius, ring.outer_radius);
    for (const double r : radii) {
      const signorini::RingStress lame = ring_stress(ring, load, r);
      curves.row({r, lame.radial, lame.hoop});
    }
    curves.blank_line();
  }
  signorini::write_file(out / "fig_14_5.csv", curves.csv());
  signorini::write_file(out / "fig_14_5_cells.csv", cells.csv("rel 1e-6 abs 1e-6"));
  return worst;
}

}  // namespace ch14
