/// \file
/// Data of the pictures of both rings: sketch, mesh, fields on the deformed bodies.
#pragma once
#include <cmath>
#include <filesystem>
#include <vector>

#include "rings.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/report/field_csv.hpp"

namespace ch14 {

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

/// Levels at equal distances, `steps` bands between them.
inline std::vector<double> levels(double first, double last, int steps) {
  std::vector<double> all;
  for (int k = 0; k <= steps; ++k) all.push_back(first + (last - first) * k / steps);
  return all;
}

/// Figure 14.3: |u|, u_x, u_y and sigma_xx on the deformed rings, in bands.
inline void fields(const std::filesystem::path& out, const signorini::SolvedScene& now) {
  for (const std::size_t k : {0, 1}) {
    const signorini::BodyModel& body = now.model.bodies[k];
    const signorini::NodeArray& u = now.solution.displacements[k];
    const signorini::Mesh mesh = drawn(body);
    const auto write = [&](const char* name, const Eigen::VectorXd& value,
                           const std::vector<double>& between) {
      signorini::write_file(out / signorini::text("fig_14_3_", name, "_", mesh.name, ".csv"),
                            deformed_bands_csv(mesh, u, value, between, magnified));
    };
    write("u", u.rowwise().norm(), levels(0.1, 0.3, 10));
    write("ux", u.col(0), levels(0, 0.3, 10));
    write("uy", u.col(1), levels(0, 0.3, 10));
    write("sxx", nodal_stress(body.mesh, body.element, body.material, u).col(0),
          levels(-200, 1100, 13));
    signorini::write_file(
        out / signorini::text("fig_14_3_", mesh.name, ".csv"),
        deformed_cells_csv(mesh, u, Eigen::VectorXd::Zero(mesh.n_cells()), /*scale*/ 0));
  }
}

}  // namespace ch14
