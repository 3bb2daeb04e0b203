/// \file
/// Chapter 12 - the disc from a file of Gmsh.
#pragma once
#include <filesystem>

#include "addons/files/gmsh.hpp"
#include "scene.hpp"

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

}  // namespace ch12
