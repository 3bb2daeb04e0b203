// # From cells to one linear system
//
// The energy of a body is the sum of the energies of its cells, so that its stiffness is the sum
// of theirs. With the nodes of each cell sorted into all nodes,
//
// \f[ K = \sum_{cells} \int B^T D\,B\;dV, \qquad K_{ff}\,u_f = p_f - K_{fh}\,u_h. \f]
//
// The second equation is for the free components f; the held components h have given values, which
// move to the right-hand side. Held unknowns are never numbered. Programs that keep them set rows
// of \f$K\f$ to those of the unit matrix, and have equations of two kinds with two units in one
// matrix.
//
// Two unit squares of the element q4 in a row, \f$E = 1\f$, \f$\nu = 0\f$: a node that only one of
// them has gets 12/24 on the diagonal, the two in the middle get 12/24 from each square, which
// adds up to 1.
//
// Loads have a page of their own, loads.cpp, and so have the forces of given displacements,
// internal_forces.cpp.

#include "signorini/fem/assembly.hpp"

#include <algorithm>
#include <map>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/parts.hpp"
#include "signorini/fem/cell_results.hpp"
#include "signorini/fem/eigenstrain.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// A curved cell can fold although its corners are in order; the map then turns over at some point.
void check_unfolded(const Cell& cell) {
  if (cell.element.n_nodes <= 4) return;  // for straight sides the corners decide, see check_mesh()
  for (const GaussPoint& at : gauss_cell(cell.element))
    require_input(
        jacobian(cell.element.shape(at.xi, at.eta), cell.body.arms).determinant > 0, "mesh '",
        cell.mesh.name, "': cell ", cell.number,
        " folds over itself: move the middle nodes of its sides closer to the straight lines");
}

/// Nodes of its largest cell; in a mixed mesh that is a quadrilateral.
Index largest_cell(const Mesh& mesh) {
  Index size = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) size = std::max(size, mesh.cell_size(cell));
  return size;
}

/// The element to use first for cells of so many nodes.
///
/// What a user gets who names no element. Of the three elements with four nodes it is the one that
/// bends without locking; the other numbers of nodes leave no choice.
const char* usual_element(Index size) {
  static const std::map<Index, const char*> usual = {
      {3, "t3"}, {4, "q4_incompatible"}, {6, "t6"}, {8, "q8"}};
  return usual.at(size);
}

/// Which columns of K one of several threads adds to: runs of 64, taken in turn.
///
/// Two threads must not add to the same number. And each column gets its cells in their order, however many threads there are.
struct ColumnsOf {
  Index owner;
  Index owners;
  [[nodiscard]] bool have(Index column) const { return column / 64 % owners == owner; }
};

/// Adds the matrix of a cell to K, and what given displacements do to the load. An entry of a free row and a held column
/// belongs to the right-hand side. The load of a row belongs to the thread that has its column.
void add_cell(const Mesh& mesh, Index cell, const CellMatrix& K, const Unknowns& unknowns,
              const ColumnsOf& mine, LinearSystem& system) {
  const auto number = [&](Index i) { return unknowns.number(mesh.cells(cell, i / 2), i % 2); };
  for (Index j = 0; j < K.cols(); ++j) {
    const Index column = number(j);
    if (column < 0 || !mine.have(column)) continue;
    for (Index i = 0; i < K.rows(); ++i) {
      const Index row = number(i);
      if (row >= 0)
        system.stiffness.coeffRef(row, column) += K(i, j);
      else
        system.load(column) -= K(j, i) * unknowns.held(mesh.cells(cell, i / 2), i % 2);
    }
  }
}

}  // namespace

const char* usual_element(const Mesh& mesh) { return usual_element(largest_cell(mesh)); }

/// A scene names elements in words, and meshes come from files. That the two fit is asked once,
/// here; an element that is given too many nodes would read only the first of them, and nobody
/// would notice.
void check_element(const Mesh& mesh, const Element& element) {
  const Index size = largest_cell(mesh);
  require_input(size == element.n_nodes, "mesh '", mesh.name, "' has cells of ", size,
                " nodes, but the element ", element.name, " needs ", element.n_nodes, "; take ",
                usual_element(size), " or another mesh");
}

/// The sum over the strain points, with the number of strains as a constant, so that the products
/// are unrolled. In exact arithmetic \f$B^T D B\f$ is symmetric. In floating point its two
/// triangles are rounded in different ways, and a factor that reads only one of them would solve
/// another problem than the residual measures. The mean of both is symmetric to the last bit.
CellMatrix cell_stiffness(const Element& element, const CellBody& cell) {
  StrainPoints points;
  element.strain(cell, points);
  CellMatrix K = CellMatrix::Zero(2 * element.n_nodes, 2 * element.n_nodes);
  with_rows(cell.D.rows(), [&](auto n_rows) {
    const auto& D = fixed_rows<n_rows>(cell.D);
    for (int i = 0; i < points.size; ++i) {
      const StrainPoint& point = points.point[at(i)];
      const auto& B = fixed_rows<n_rows>(point.B);
      const FixedRows<n_rows> stress = point.volume * D * B;
      K.noalias() += B.transpose() * stress;
    }
  });
  return 0.5 * (K + CellMatrix(K.transpose()));  // exactly symmetric
}

/// Everything comes together: pattern, loads, and a loop over the cells. Eigenstrains enter as
/// nodal forces. They are summed on all nodes before the held components are dropped, as all loads
/// are. An entry of a free row and a held column belongs to the right-hand side, with the
/// displacement that is given there.
LinearSystem assemble(const Mesh& mesh, const Element& element, const MaterialField& material,
                      const Unknowns& unknowns, const Loads& loads) {
  check_element(mesh, element);
  LinearSystem system{stiffness_pattern(mesh, unknowns), {}};
  NodeArray nodal = nodal_loads(mesh, element, material, loads);
  if (material.eigenstrain) nodal += eigenstrain_forces(mesh, element, material);
  system.load = restricted(unknowns, nodal);

  const Cells cells(mesh, element, material);
  visit_results<CellMatrix>(
      cells,
      [](const Cell& cell, CellMatrix& K) {
        check_unfolded(cell);
        K = cell_stiffness(cell.element, cell.body);
      },
      [&](Index first, Index end, const std::vector<CellMatrix>& K) {
        const int owners = free_threads();
        for_parts(owners, [&](Index owner) {
          for (Index cell = first; cell < end; ++cell)
            add_cell(mesh, cell, K[at(cell - first)], unknowns, {owner, owners}, system);
        });
      });
  return system;
}

/// Solvers know \f$n\f$ numbers, users know nodes. These two functions are the way from the one to
/// the other.
NodeArray expand(const Unknowns& unknowns, const Eigen::Ref<const Eigen::VectorXd>& values) {
  require_argument(values.size() == unknowns.count, "expand: need ", unknowns.count,
                   " values (one per unknown), got ", values.size());
  NodeArray all = unknowns.held;
  for (Index node = 0; node < all.rows(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      if (unknowns.number(node, axis) >= 0) all(node, axis) = values(unknowns.number(node, axis));
  return all;
}

/// The way back, for forces: components that are held have no row in the system.
Eigen::VectorXd restricted(const Unknowns& unknowns, const NodeArray& nodal) {
  Eigen::VectorXd values(unknowns.count);
  for (Index node = 0; node < nodal.rows(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      if (unknowns.number(node, axis) >= 0) values(unknowns.number(node, axis)) = nodal(node, axis);
  return values;
}

}  // namespace signorini
