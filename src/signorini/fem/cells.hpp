/// \file
/// The one loop over the cells of a body: which element stands in each cell, and what it is made of.
///
/// Assembly, loads, eigenstrains, stresses and error estimates all walk through the cells of a body
/// and ask each one for its element, its material and its shape. The walk is written once. What
/// differs is a function that the caller hands in.
#pragma once
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/fem/element.hpp"
#include "signorini/fem/material_field.hpp"
#include "signorini/fem/mesh.hpp"
#include "signorini/fem/unknowns.hpp"

namespace signorini {

/// One cell of a body, with all that is integrated over it.
struct Cell {
  Eigen::Index number;       ///< in its mesh
  const Element& element;    ///< that stands in it
  const Material& material;  ///< that it is made of
  CellBody body;             ///< as the element sees it
  const Mesh& mesh;          ///< that has it

  /// \param k  one of the nodes of the element
  /// \return its number in the mesh
  [[nodiscard]] Eigen::Index node(Eigen::Index k) const { return mesh.cells(number, k); }
};

/// \param cell   any \param point  one of its strain points \return where that is [length]
[[nodiscard]] Eigen::Vector2d position(const Cell& cell, const StrainPoint& point);

/// Gathers the nodes of one cell for the element functions.
/// \param mesh  that has it
/// \param cell  its number
/// \return positions in the order of the cell [length]
[[nodiscard]] CellNodes cell_nodes(const Mesh& mesh, Eigen::Index cell);

/// The element of the triangles in a mesh that has quadrilaterals as well.
/// \param mesh  any
/// \return t3 or t6, which has as many nodes per side
[[nodiscard]] const Element& triangle_beside(const Mesh& mesh);

/// A cell as an element sees it.
/// \param nodes  `m x 2` positions [length]
/// \param D      elasticity_matrix() of its material [force/length^2]
/// \param depth  across the plane
/// \return both, with the positions counted from the middle
[[nodiscard]] CellBody cell_body(const CellNodes& nodes, const Elasticity& D, const Depth& depth);

/// What nodes of a cell do.
/// \param cell          any
/// \param displacements `n_nodes x 2` of its mesh [length]
/// \return x, y of its first node, x, y of its second, ... [length]
[[nodiscard]] CellVector gathered(const Cell& cell, const NodeArray& displacements);

/// \param material  of a body
/// \return elasticity_matrix() of its base, then of the others
/// \throws ProblemError as check_material()
[[nodiscard]] std::vector<Elasticity> elasticity_matrices(const MaterialField& material);

/// The cells of a body, each of which can be asked for by itself.
class Cells {
 public:
  /// \param mesh      the body
  /// \param element   of its cells, of as many corners; triangles beside quadrilaterals are triangle_beside()
  /// \param material  of its cells
  /// \throws ProblemError as check_material(); std::invalid_argument if the numbers of materials are those of another mesh
  Cells(const Mesh& mesh, const Element& element, const MaterialField& material);

  /// \return how many there are
  [[nodiscard]] Eigen::Index count() const { return mesh_.n_cells(); }
  /// \param number  of a cell \return it
  [[nodiscard]] Cell operator[](Eigen::Index number) const {
    return {number, mesh_.corners(number) == 3 ? triangle_ : element_, material_.of(number),
            cell_body(cell_nodes(mesh_, number), D_[material_.number(number)], depth_), mesh_};
  }

 private:
  const Mesh& mesh_;
  const Element& element_;
  const Element& triangle_;
  const MaterialField& material_;
  std::vector<Elasticity> D_;
  Depth depth_;
};

/// Calls visit(cell) for every cell of a body, in their order.
/// \param mesh      the body
/// \param element   of its cells, as of Cells
/// \param material  of its cells
/// \param visit     gets a Cell
/// \throws ProblemError, std::invalid_argument as Cells
template <typename Visit>
void visit_cells(const Mesh& mesh, const Element& element, const MaterialField& material,
                 Visit&& visit) {
  const Cells cells(mesh, element, material);
  for (Eigen::Index number = 0; number < cells.count(); ++number) visit(cells[number]);
}

/// Calls visit(cell, points) for every cell of a body with its strain points.
/// \param mesh      the body
/// \param element   of its cells, as in visit_cells()
/// \param material  of its cells
/// \param visit     gets a Cell and its StrainPoints
/// \throws ProblemError, std::invalid_argument as visit_cells()
template <typename Visit>
void visit_strains(const Mesh& mesh, const Element& element, const MaterialField& material,
                   Visit&& visit) {
  StrainPoints points;
  visit_cells(mesh, element, material, [&](const Cell& cell) {
    cell.element.strain(cell.body, points);
    visit(cell, points);
  });
}

}  // namespace signorini
