// The right half of a disc of radius 1 in both orders, for tests of what changes cells and keeps a round rim.
#pragma once
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "meshes/split.hpp"

namespace signorini_test {

/// Both orders, one after the other.
inline signorini::MeshOrder any_order() {
  return GENERATE(signorini::MeshOrder::Linear, signorini::MeshOrder::Quadratic);
}

/// The boundaries of the half disc.
inline const std::vector<std::string> half_disc_rim = {"axis", "rim"};

/// \param order            of the mesh
/// \param triangles_every  so many cells one is cut into two triangles, 0: none
/// \return quadrilaterals, triangles, or both
inline signorini::Mesh half_disc(signorini::MeshOrder order, int triangles_every = 0) {
  signorini::DiscSpec spec;
  spec.part = signorini::DiscPart::Right;
  spec.order = order;
  const signorini::Mesh whole = signorini::make_disc(spec);
  std::vector<Eigen::Index> cut;
  for (Eigen::Index cell = 0; triangles_every > 0 && cell < whole.n_cells();
       cell += triangles_every)
    cut.push_back(cell);
  return cut.empty() ? whole : signorini::split(whole, cut);
}

}  // namespace signorini_test
