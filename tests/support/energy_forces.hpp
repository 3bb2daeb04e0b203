// Internal forces of bodies under finite strain, from nothing but the energy of their law.
#pragma once
#include "signorini/fem/element.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini_test {

/// Positions or displacements in extended precision, one row per node.
using LongNodes = Eigen::Matrix<long double, Eigen::Dynamic, 2>;

/// The gradient of \f$ \sum_q w_q W(F_q) \f$, where W is written as textbooks have it. The derivative by each
/// displacement is the imaginary part of the energy at \f$ u + ih \f$, over h, which loses no digits for any small h.
/// Shape functions come from the monomials that each cell is known to have. Of the library, only the rules of its elements
/// are used, and its list of cells.
/// \param mesh      before it moved
/// \param element   of its cells with four corners; says whether these have the mean change of volume
/// \param material  whose law is neo_hooke or st_venant_kirchhoff
/// \param u         `n_nodes x 2` displacements [length]
/// \return `n_nodes x 2` [force]
LongNodes energy_forces(const signorini::Mesh& mesh, const signorini::Element& element,
                        const signorini::Material& material, const LongNodes& u);

}  // namespace signorini_test
