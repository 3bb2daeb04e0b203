/// \file
/// Data of the figures: load history, stresses through both walls, two nodes that meet.
#pragma once
#include <algorithm>

#include "readings.hpp"
#include "rings.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
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

/// Figure 14.4: stresses through both walls. \return largest deviation from the closed form
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
  signorini::write_file(out / "fig_14_4.csv", curves.csv());
  signorini::write_file(out / "fig_14_4_cells.csv", cells.csv("rel 1e-6 abs 1e-6"));
  return worst;
}

/// Figure 14.5: where the rims are around 40 degrees, before and after.
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
  signorini::write_file(out / "fig_14_5.csv", rims.csv());
}

}  // namespace ch14
