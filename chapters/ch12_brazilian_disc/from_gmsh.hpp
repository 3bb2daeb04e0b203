/// \file
/// Chapter 12 - the disc from a file of Gmsh.
#pragma once
#include <filesystem>

#include "reading.hpp"
#include "signorini/closed_form/hertz_fit.hpp"
#include "signorini/core/results.hpp"
#include "signorini/gmsh/gmsh.hpp"

namespace ch12 {

/// \param file  with a physical surface "disc" and physical curves "rim" and "axis"
/// \return the disc of the file between the plates
// [gmsh]
inline Scene disc_of_file(const std::filesystem::path& file) {
  Scene scene = disc_between_plates(for_middle);
  scene.bodies[0].mesh = mesh_named(read_gmsh(file), "disc");
  return scene;
}
// [gmsh]

/// Solves the disc of the file.
/// \param file     as for disc_of_file()
/// \param results  receives what it is good for
inline void solve_file(const std::filesystem::path& file, Results& results) {
  const SolvedScene run = solved(disc_of_file(file), "the disc of " + file.filename().string());
  const Contact low = contact_of(run, false);
  const double peak = fit_hertz(low.x, low.pressure).peak_pressure;
  results.add("gmsh_nodes", static_cast<double>(run.model.bodies[0].mesh.n_nodes()), "-");
  results.add("gmsh_middle_error", 100 * (middle(run)[0] / exact_across(R) - 1), "%");
  results.add("gmsh_peak_error", 100 * (peak / hertz_peak_pressure(plate) - 1), "%");
  results.add("gmsh_axis_error", 100 * axis_error(run), "%");
  results.add("gmsh_sign_change", sign_change(diameter_of(run)), "mm");
}

}  // namespace ch12
