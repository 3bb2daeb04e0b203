// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Meshes of scenes that other programs have made.
#pragma once
#include "addons/files/kinds.hpp"

namespace signorini {

/// \return a physical surface of a file of Gmsh
[[nodiscard]] Kind<Mesh> gmsh_kind();

/// \return an element set of an input file of CalculiX or Abaqus
[[nodiscard]] Kind<Mesh> inp_kind();

}  // namespace signorini
