/// \file
/// The mesh of figure 11.1, the pressures of 11.2, the bodies of 11.5 and 11.7 and the stresses of 11.6.
#pragma once
#include <cmath>
#include <filesystem>

#include "below_contact.hpp"
#include "hertz_run.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"

namespace signorini {

/// Pressures of the nodes and their errors. \param folder  to write to \param ours  the example, solved
inline void draw_pressures(const std::filesystem::path& folder, const HertzRun& ours) {
  const LineContact theory = ours.now.theory();
  Table nodes({"x", "p", "error"}), others({"x", "p", "error"});
  Table ellipses({"x", "theory", "paper", "abaqus"});
  HertzCase bumpy = not_matching();
  bumpy.gap_operator = "node_to_segment";
  const HertzRun one_sided = solve_hertz(bumpy);
  const auto add = [&theory](Table& table, double x, double p) {
    table.row({x, p, 100 * (p - hertz_pressure(theory, x)) / hertz_peak_pressure(theory)});
  };
  for (std::size_t k = 0; ours.x[k] < 1.3; ++k) {
    add(nodes, ours.x[k], ours.pressure[k]);
    add(others, one_sided.x[k], one_sided.pressure[k]);
  }
  const auto ellipse = [](double x, double width, double peak) {
    return x < width ? peak * std::sqrt(1 - x * x / (width * width)) : 0;
  };
  for (int k = 0; k <= 260; ++k) {
    const double x = 0.005 * k;
    ellipses.row(
        {x, hertz_pressure(theory, x), ellipse(x, 1.09957, 23.8437), ellipse(x, 1.1178, 23.4287)});
  }
  write_file(folder / "fig_11_2.csv", ellipses.csv());
  write_file(folder / "fig_11_2_nodes.csv", nodes.csv("rel 1e-6 abs 1e-6"));
  write_file(folder / "fig_11_2_nts.csv", others.csv("rel 1e-6 abs 1e-6"));
}

/// Both meshes before loading, and both bodies deformed with bands of their displacements.
/// \param folder  to write to \param run  the example, solved
inline void draw_bodies(const std::filesystem::path& folder, const SolvedScene& run) {
  for (const std::size_t body : {0, 1}) {
    const Mesh& mesh = run.model.bodies[body].mesh;
    const NodeArray& u = run.solution.displacements[body];
    const std::string end = body == 0 ? "_disc.csv" : "_plate.csv";
    write_file(folder / ("fig_11_1" + end),
               deformed_cells_csv(mesh, u, Eigen::VectorXd::Zero(mesh.n_cells()), 0));
    const auto bands = [&](const char* name, const Eigen::VectorXd& value,
                           const std::vector<double>& levels) {  // [mm], as in fig_11_7.gp
      write_file(folder / text("fig_11_7_", name, end),
                 deformed_bands_csv(mesh, u, value, levels, 40));
    };
    const std::vector<double> sizes = {.002, .005, .01, .02, .03, .04, .045, .05, .055, .06};
    bands("x", u.col(0), {-.0015, -.001, -.0005, 0, .0005, .001, .002, .003, .005, .007});
    bands("y", u.col(1), {-.06, -.055, -.05, -.045, -.04, -.03, -.02, -.01, -.005, -.002});
    bands("size", u.rowwise().norm(), sizes);
  }
  Table outline({"x", "y"});
  for (const auto& [x, y] : {std::pair(0, 0), {95, 0}, {95, -95}, {0, -95}, {0, 50}, {50, 50}})
    outline.row({static_cast<double>(x), static_cast<double>(y)});
  for (int k = 30; k >= 0; --k) {
    const double angle = k * std::acos(0.0) / 30;
    outline.row({50 * std::sin(angle), 50 - 50 * std::cos(angle)});
  }
  write_file(folder / "fig_11_7.csv", outline.csv());
}

/// Writes the data of these figures. \param folder  to write to \param ours  the example, solved
inline void draw(const std::filesystem::path& folder, const HertzRun& ours) {
  const LineContact theory = ours.now.theory();
  const double b = hertz_half_width(theory);
  draw_pressures(folder, ours);
  draw_bodies(folder, ours.run);
  write_file(folder / "fig_11_5.csv", shear_near_contact(ours.run, 0, 2.5));
  write_file(folder / "fig_11_5_plate.csv", shear_near_contact(ours.run, 1, 2.5));
  for (const std::size_t body : {0, 1})
    write_file(folder / (body == 0 ? "fig_11_6_disc.csv" : "fig_11_6_plate.csv"),
               along_axis(ours.run, body).csv(4 * b));
  Table exact({"depth", "xx", "yy", "shear"});
  for (int k = 0; k <= 200; ++k) {
    const Eigen::Vector3d stress = hertz_stress(theory, 0, 0.02 * k * b);
    exact.row({0.02 * k * b, stress(0), stress(1), (stress(0) - stress(1)) / 2});
  }
  write_file(folder / "fig_11_6.csv", exact.csv());
}

}  // namespace signorini
