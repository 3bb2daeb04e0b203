/// \file
/// What a body answers to displacements where strains are not small: an open family, filled by add-ons.
///
/// The library itself has the small strain of \f$ \sigma = D\varepsilon \f$, and a material without a law means it. Any other is
/// asked cell by cell, for all that a cell has to say: forces, tangent, stress, energy. So whoever adds up cells, for
/// a support force or for a picture, need not know which law a body has.
#pragma once
#include "signorini/fem/cells.hpp"

namespace signorini {

/// What a cell answers to displacements of its nodes.
struct CellAnswer {
  CellVector force;    ///< `2m` internal forces, the gradient of the energy [force]
  CellMatrix tangent;  ///< `2m x 2m` symmetric, the derivative of the forces [force/length]
  /// True (Cauchy) stress at each strain point: a row xx, yy, xy, zz per point [force/length^2]
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::ColMajor, max_strain_points, 4> stress;
  double energy = 0;  ///< that strains store [force*length]
};

/// One member of the family.
struct StrainLaw {
  const char* name;     ///< as a scene names it
  const char* summary;  ///< one line for lists
  /// Fills the answer of a cell to displacements `2m` of its nodes [length]. Those of a cell that is carried far should be
  /// less a shift of all of it, which strains nothing, so that no digits are lost. Throws ProblemError, which names the cell,
  /// if it inverts. Null: strains are small.
  void (*answer)(const Cell& cell, const CellVector& displacement, CellAnswer& answer);
  /// The least stiffness that the material of a cell has against plane waves, over its strain points: negative where the law is
  /// that of no stable material [force/length^2]. Null: nobody asks.
  double (*stability)(const Cell& cell, const CellVector& displacement) = nullptr;
};

/// \param cell           of a mesh
/// \param displacements  `n_nodes x 2` [length]
/// \return `2m` those of its nodes less the shift of the first one, which strains nothing; along a radius it does, and stays
[[nodiscard]] CellVector less_shift(const Cell& cell, const NodeArray& displacements);

/// What a cell of a material with a law answers to displacements of the mesh.
/// \param cell           of a material that has a law
/// \param displacements  `n_nodes x 2` [length]
/// \return its answer to these less what its first node is shifted by, which strains nothing; a body that is carried by so
///   many of its sizes loses as many digits of its strains
[[nodiscard]] CellAnswer answer_of(const Cell& cell, const NodeArray& displacements);

}  // namespace signorini
