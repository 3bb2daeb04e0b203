/// \file
/// The pressures of figure 11.1, the bodies of 11.2 and the stresses of 11.3.
#pragma once
#include <cmath>
#include <filesystem>

#include "below_contact.hpp"
#include "hertz_run.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"

namespace signorini {

/// Writes the data of the three figures. \param folder  to write to \param ours  the example, solved
inline void draw(const std::filesystem::path& folder, const HertzRun& ours) {
  const LineContact theory = ours.now.theory();
  const double b = hertz_half_width(theory);
  Table nodes({"x", "p"}), others({"x", "p"}), ellipses({"x", "theory", "paper", "abaqus"});
  HertzCase bumpy = not_matching();
  bumpy.gap_operator = "node_to_segment";
  const HertzRun one_sided = solve_hertz(bumpy);
  for (std::size_t k = 0; ours.x[k] < 1.3; ++k) {
    nodes.row({ours.x[k], ours.pressure[k]});
    others.row({one_sided.x[k], one_sided.pressure[k]});
  }
  const auto ellipse = [](double x, double width, double peak) {
    return x < width ? peak * std::sqrt(1 - x * x / (width * width)) : 0;
  };
  for (int k = 0; k <= 260; ++k) {
    const double x = 0.005 * k;
    ellipses.row(
        {x, hertz_pressure(theory, x), ellipse(x, 1.09957, 23.8437), ellipse(x, 1.1178, 23.4287)});
  }
  write_file(folder / "fig_11_1.csv", ellipses.csv());
  write_file(folder / "fig_11_1_nodes.csv", nodes.csv("rel 1e-6 abs 1e-7"));
  write_file(folder / "fig_11_1_nts.csv", others.csv("rel 1e-6 abs 1e-7"));
  write_file(folder / "fig_11_2.csv", shear_near_contact(ours.run, 0, 2.5));
  write_file(folder / "fig_11_2_plate.csv", shear_near_contact(ours.run, 1, 2.5));
  for (const std::size_t body : {0, 1})
    write_file(folder / (body == 0 ? "fig_11_3_disc.csv" : "fig_11_3_plate.csv"),
               along_axis(ours.run, body).csv(4 * b));
  Table exact({"depth", "xx", "yy", "shear"});
  for (int k = 0; k <= 200; ++k) {
    const Eigen::Vector3d stress = hertz_stress(theory, 0, 0.02 * k * b);
    exact.row({0.02 * k * b, stress(0), stress(1), (stress(0) - stress(1)) / 2});
  }
  write_file(folder / "fig_11_3.csv", exact.csv());
}

}  // namespace signorini
