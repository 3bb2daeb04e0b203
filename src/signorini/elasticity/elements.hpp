/// \file
/// The members of the element family.
#pragma once
#include <string>
#include <vector>

#include "signorini/elasticity/element.hpp"

namespace signorini {

/// Bilinear quadrilateral, 2 x 2 Gauss points. Locks in bending and near incompressibility.
[[nodiscard]] Element q4();
/// Bilinear with the volumetric strain averaged over the cell; bears Poisson's ratio up to 0.4999...
[[nodiscard]] Element q4_bbar();
/// Bilinear with four incompatible modes, condensed in the cell; bends without locking.
[[nodiscard]] Element q4_incompatible();
/// Eight-node serendipity quadrilateral, 3 x 3 Gauss points.
[[nodiscard]] Element q8();

/// All members, in the order of lists and tables.
[[nodiscard]] const std::vector<Element>& elements();

/// The member called `name`. \throws ProblemError listing the known names
[[nodiscard]] const Element& find_element(const std::string& name);

}  // namespace signorini
