/// \file
/// Where a solution is to be read.
///
/// A probe takes nothing from a run and adds nothing to it. It names places of the bodies before loading; with bodies that move
/// they are the same points of the material.
#pragma once
#include <string>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// What is to be read. Exactly one of `points`, `along` and `of` says where.
struct Probe {
  std::string name;        ///< of its own
  std::string body;        ///< name of a body
  NodeArray points = {};   ///< `n x 2` places in it [length]
  bool line = false;       ///< whether the points stand on a line, from the first one on, which may leave the body
  std::string along = {};  ///< a boundary of it, node by node in walking order
  std::string of = {};     ///< a boundary of it: what acts on it in sum
};

}  // namespace signorini
