/// \file
/// The cylinder on a plate of chapter 11 as files that other programs read.
#pragma once
#include <filesystem>
#include <string>

#include "tests/support/hertz.hpp"

namespace signorini::bench {

/// One problem on one mesh: what every program is given.
struct HertzCase {
  signorini_test::HertzProblem problem;  ///< mm, N; its element is ours, others take theirs
  Scene scene;                           ///< disc, then plate
  std::filesystem::path folder;          ///< for the files of all programs

  /// \return number of nodes of both meshes
  [[nodiscard]] Eigen::Index n_nodes() const {
    return scene.bodies[0].mesh.n_nodes() + scene.bodies[1].mesh.n_nodes();
  }
};

/// How CalculiX couples the surfaces.
struct CalculixContact {
  std::string type;  ///< `SURFACE TO SURFACE` or `NODE TO SURFACE`
  double stiffness;  ///< of its contact springs over Young's modulus of the disc [1/length]
  /// Whether the plate begins as much higher as Hertz's half-width overlaps, which moves both bodies by no strain: the
  /// surface coupling then begins near its final set and needs a fifth of the iterations, the other keeps that set.
  bool overlap;
};

/// Writes `hertz.msh`, which Gmsh, GetFEM and we read: every body a physical surface of its name, every boundary a
/// physical curve `BODY_BOUNDARY`, numbered as they come.
/// \param now  whose folder exists
void write_gmsh_file(const HertzCase& now);

/// Writes `hertz.toml`, the scene on `hertz.msh`, for our own program.
/// \param now  whose folder exists
void write_scene_file(const HertzCase& now);

/// Writes `NAME.inp`, the same problem for CalculiX with its element CPE4: nodes, cells and boundaries in our order,
/// one load step.
/// \param now      whose folder exists
/// \param name     of the file
/// \param contact  between rim and surface
void write_calculix_file(const HertzCase& now, const std::string& name,
                         const CalculixContact& contact);

}  // namespace signorini::bench
