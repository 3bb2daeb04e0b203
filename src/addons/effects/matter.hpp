/// \file
/// What a body is made of, cell by cell, and how warm it is.
#pragma once
#include <string>
#include <vector>

#include "signorini/fem/material.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// A part of a body that is of another material.
struct Layer {
  std::string region;  ///< name in Mesh::regions
  Material material;   ///< of the cells of that region
};

/// How much warmer a body is than where it is free of stress:
/// \f$ \Delta T(x) = \Delta T_0 + \nabla T \cdot x \f$.
struct Temperature {
  double uniform = 0;                                  ///< at the origin [temperature]
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  ///< [temperature/length]
  std::string history = {};  ///< name of what it grows with, see Path; empty: it is always there

  /// \param x  a place [length] \return how much warmer it is there [temperature]
  [[nodiscard]] double at(const Eigen::Vector2d& x) const { return uniform + gradient.dot(x); }
  /// \return whether it is not zero everywhere
  [[nodiscard]] bool warms() const { return uniform != 0 || (gradient.array() != 0).any(); }
};

/// What the cells of a body are made of, and how warm they are.
struct Matter {
  /// \param everywhere  material of all cells
  Matter(const Material& everywhere = {}) : bulk(everywhere) {}

  Material bulk;                 ///< of all cells that are in no layer; thickness and state of all
  std::vector<Material> layers;  ///< other materials
  /// `n_cells` numbers: 0 for the bulk, k for `layers[k - 1]`; none without layers.
  std::vector<std::size_t> layer_of;
  Temperature temperature;  ///< of all cells

  /// \param layer  0 for the bulk, or 1 to the number of layers \return its material
  [[nodiscard]] const Material& material(std::size_t layer) const {
    return layer == 0 ? bulk : layers[layer - 1];
  }
};

/// Puts layers into a body.
/// \param mesh    the body
/// \param bulk    material of the cells that are in no layer
/// \param layers  of regions of the mesh
/// \return the material of every cell
/// \throws ProblemError if there is no such region, a cell is in two layers, or a layer has another thickness or
///   plane state, or as check_material()
[[nodiscard]] Matter layered(const Mesh& mesh, const Material& bulk,
                             const std::vector<Layer>& layers);

/// \param matter  of a body
/// \return depth_of() of all its materials
[[nodiscard]] inline Depth depth_of(const Matter& matter) { return depth_of(matter.bulk); }

}  // namespace signorini
