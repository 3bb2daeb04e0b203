/// \file
/// The members of the element family. To add one: write a `.cpp` with a function that returns it, and put its name
/// into the table in elements.cpp; the conformance suite finds it.
///
/// Six members: two triangles and four quadrilaterals, of two or three nodes per side. elements.cpp
/// says how they differ in bending.
#pragma once
#include <string>
#include <vector>

#include "signorini/fem/element.hpp"

namespace signorini {

struct Mesh;

/// \f$ N_k = (1 + \xi_k \xi)(1 + \eta_k \eta) / 4 \f$ of the four corners, and its slopes:
/// shared by the three four-node elements.
/// \param xi   first coordinate in the reference square [-]
/// \param eta  second coordinate [-]
/// \return 4 values and slopes
[[nodiscard]] Shape bilinear_shape(double xi, double eta);

/// Bilinear quadrilateral, 2 x 2 Gauss points. Locks in bending and near incompressibility.
/// \return the element
[[nodiscard]] Element q4();
/// Bilinear with the volumetric strain averaged over the cell [\ref Hughes1980]; bears Poisson's
/// ratios up to 0.4999, but locks in bending.
/// \return the element
[[nodiscard]] Element q4_bbar();
/// Bilinear with four incompatible modes, condensed in the cell [\ref TaylorBeresfordWilson1976];
/// bends without locking.
/// \return the element
[[nodiscard]] Element q4_incompatible();
/// Eight-node serendipity quadrilateral, 3 x 3 Gauss points.
/// \return the element
[[nodiscard]] Element q8();

/// Three-node triangle. Too stiff in bending, and locks near incompressibility.
/// \return the element
[[nodiscard]] Element t3();
/// Six-node triangle, 6 Gauss points.
/// \return the element
[[nodiscard]] Element t6();

/// The family.
/// \return all members, in the order of lists and tables
[[nodiscard]] const std::vector<Element>& elements();

/// Looks up a member.
/// \param name  of the element
/// \return the member
/// \throws ProblemError listing the known names if there is none
[[nodiscard]] const Element& find_element(const std::string& name);

/// The element for a mesh.
/// \param mesh  through check_mesh()
/// \param name  of a member; empty for usual_element()
/// \return that member
/// \throws ProblemError as find_element() and check_element()
[[nodiscard]] const Element& element_for(const Mesh& mesh, const std::string& name);

}  // namespace signorini
