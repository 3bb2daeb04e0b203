// Studies of chapter 13 about the soil and the footing themselves: how large, how thick, which stress.
#pragma once
#include "footing.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/shown.hpp"

namespace ch13 {

inline SolvedScene settle(const EdgeBlockSpec& soil, const FootingSpec& footing) {
  return shown(on_soil(soil, footing), "the footing");
}

inline std::string percent(double part, const char* format = "%.2f") {
  return number(100 * part, format);
}

// 7. How wide and deep the soil must be.
inline void domain(const ProgramOptions& run, Results& results) {
  Table table(
      {"W = H", "p(0) / (2q/π) − 1 [%]", "0.65 (a/H)² [%]", "settlement [mm]", "more [mm]"});
  Table curve({"size", "pressure"});
  double before = 0;
  for (const int size : {3, 5, 10, 20, 40}) {
    const Base base = rigid_base(soil_of(40, 40, 44, 16, size * a));
    const double off = base.deviation()(0), sinks = 1000 * base.settlement;
    table.row({text(size, " a"), percent(off), percent(0.65 / (size * size)), number(sinks, "%.2f"),
               size < 10 ? "" : number(sinks - before, "%.2f")});
    curve.row({1.0 * size, 100 * off});
    results.add(text("middle_", size), 1 + off, "-");
    results.add(text("settlement_", size), sinks, "mm");
    before = sinks;
  }
  const double modulus = plane_strain_modulus(soil_modulus, poisson_ratio);
  results.add("per_doubling", 1000 * 2 * strip.force / (std::acos(-1.0) * modulus) * std::log(2),
              "mm");
  write_file(run.out / "domain.md", table.markdown());
  write_file(run.out / "fig_13_4.csv", curve.csv());
}

// 8. How thick the footing must be to count as rigid: against a rigid one on the same mesh, and a plate.
inline void thickness(const ProgramOptions& run, Results& results) {
  const EdgeBlockSpec soil = soil_of(24, 26, 28, 64, 60);
  const double rigid = rigid_base(soil).pressure()(0);
  const double modulus = plane_strain_modulus(soil_modulus, poisson_ratio);
  const double plate = plane_strain_modulus(footing_modulus, poisson_ratio) / 12;  // D = plate t^3
  Table table({"t [m]", "softness ρ", "p(0) over rigid [%]"});
  Table theory({"ρ", "t [m]", "plate, p(0)/q", "body, p(0)/q"});
  Table curve({"thickness", "pressure"}), points({"thickness", "pressure"});
  const auto middle = [&](double t) { return base_of(settle(soil, {t, 10})).pressure()(0); };
  for (const double t : {0.15, 0.2, 0.25, 0.35, 0.5, 0.7, 1.0, 1.5, 2.0}) {
    const double more = middle(t) / rigid - 1;
    curve.row({t, 100 * more});
    if (t != 0.25 && t != 0.5 && t != 1 && t != 2) continue;
    table.row({number(t), number(modulus * std::pow(a / t, 3) / plate, "%.3f"), percent(more)});
    results.add(text("thickness_", t), 100 * more, "%");
  }
  for (const FlexibleStrip& plate_on_soil : flexible_strips) {
    if (plate_on_soil.softness == 0) continue;
    const double t = a * std::cbrt(modulus / plate / plate_on_soil.softness), body = middle(t) / q;
    theory.row({number(plate_on_soil.softness), number(t, "%.3f"),
                number(plate_on_soil.pressure, "%.4f"), number(body, "%.4f")});
    points.row({t, 100 * (plate_on_soil.pressure * q / mean_pressure - 1)});
    results.add(text("plate_", plate_on_soil.softness), 100 * (body / plate_on_soil.pressure - 1),
                "%");
  }
  write_file(run.out / "thickness.md", table.markdown());
  write_file(run.out / "plate.md", theory.markdown());
  write_file(run.out / "fig_13_4_thickness.csv", curve.csv());
  write_file(run.out / "fig_13_4_plate.csv", points.csv());
}

// 9. The vertical stress on the axis, where it is largest.
inline void stress(Results& results) {
  const SolvedScene now = settle(soil_of(60, 72, 66, 64, 60), {2, 16});
  const BodyModel& soil = now.model.bodies[1];
  const StressArray nodes =
      nodal_stress(soil.mesh, soil.element, soil.material, now.solution.displacements[1]);
  const std::vector<Index> axis = boundary_nodes(soil.mesh, "axis");
  const double deepest = a / std::sqrt(2);  // where the closed form is largest
  const auto nearer = [&](Index one, Index other) {
    return std::abs(soil.mesh.nodes(one, 1) + deepest) <
           std::abs(soil.mesh.nodes(other, 1) + deepest);
  };
  const Index at = *std::min_element(axis.begin(), axis.end(), nearer);
  const double depth = -soil.mesh.nodes(at, 1);
  results.add("axis_depth", depth, "m");
  results.add("axis_stress", -nodes(at, 1), "kPa");
  results.add("axis_stress_closed_form", -rigid_strip_stress(strip, 0, depth)(1), "kPa");
  results.add("mean_pressure", mean_pressure, "kPa");
}

}  // namespace ch13
