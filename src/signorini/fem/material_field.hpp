/// \file
/// What a body is made of, cell by cell, and how it would strain without stress.
///
/// Most bodies are of one material. So there is a `base`, and cells that are made of something else
/// have the number of another one. Thickness and plane state are the base's for all: cells of one
/// body do not differ in what happens across the plane. Stiffness and stress ask for the material
/// of each cell and for nothing else, which is why a new material in some cells changes no other
/// file.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "signorini/fem/material.hpp"

namespace signorini {

/// The strain of a cell that is cut free of all others, so that it needs no stress: (xx, yy, 2 xy, across) [-], where across
/// the plane is the hoop strain in axial symmetry. A function of the material and the place [length]; none if empty.
using Eigenstrain = std::function<Eigen::Vector4d(const Material&, const Eigen::Vector2d&)>;

/// What the cells of a body are made of, and their eigenstrain.
struct MaterialField {
  /// \param everywhere  material of all cells
  MaterialField(const Material& everywhere = {}) : base(everywhere) {}

  Material base;                 ///< of all cells that have no other; thickness and state of all
  std::vector<Material> others;  ///< materials of some cells
  /// `n_cells` numbers: 0 for the base, k for `others[k - 1]`; none if all cells are of the base.
  std::vector<std::size_t> number_of;
  Eigenstrain eigenstrain;  ///< of all cells; empty by default

  /// \param cell  any \return the number of its material: 0 for the base, k for `others[k - 1]`
  [[nodiscard]] std::size_t number(Eigen::Index cell) const {
    return number_of.empty() ? 0 : number_of[static_cast<std::size_t>(cell)];
  }
  /// \param cell  any \return its material
  [[nodiscard]] const Material& of(Eigen::Index cell) const {
    const std::size_t k = number(cell);
    return k == 0 ? base : others[k - 1];
  }
};

/// \param material  of a body
/// \return the same with small strain, as it answers near rest
[[nodiscard]] inline MaterialField at_rest(MaterialField material) {
  material.base.law = nullptr;
  for (Material& other : material.others) other.law = nullptr;
  return material;
}

/// \param material  of a body
/// \return depth_of() of all its materials
[[nodiscard]] inline Depth depth_of(const MaterialField& material) {
  return depth_of(material.base);
}

}  // namespace signorini
