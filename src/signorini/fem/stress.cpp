// # Stresses, and where to read them
//
// Displacements are continuous and strains jump between cells, so that a node has as many stresses
// as it has cells. Inside of a cell not all places are alike: the strain of an element is nearest
// to the truth at the points of a low Gauss rule, and worst at the corners. So stresses are
// computed at the strain points, carried to the nodes by a fit, and averaged over the cells there.
// For four points at \f$\xi, \eta = \pm 1/\sqrt3\f$ and a bilinear fit, a corner gets
//
// \f[ \bigl(1 + \tfrac{\sqrt3}{2}\bigr)\,\sigma_1 - \tfrac12\,\sigma_2 - \tfrac12\,\sigma_3
//     + \bigl(1 - \tfrac{\sqrt3}{2}\bigr)\,\sigma_4, \f]
//
// with 1 the nearest point and 4 the farthest: 1.866, -0.5, -0.5 and 0.134. The fit magnifies, and
// a stress that changes much within a cell is read with a large error. Recovery from patches of
// cells [ZienkiewiczZhu1992] is better, and the error estimates use it. The average is for
// pictures: it smears the jump between two materials, which is real.
//
// Contact pressures do not come from here. They are forces divided by shares of the surface.

#include "signorini/fem/stress.hpp"

#include <array>
#include <mutex>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/fem/cell_results.hpp"
#include "signorini/fem/eigenstrain.hpp"
#include "signorini/fem/strain_law.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using PointStress = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::ColMajor, max_strain_points, 4>;

/// Stress at one strain point; across the plane it is a component of D, or follows from those in
/// the plane.
///
/// The fourth number, across the plane, costs little here and could not be reconstructed later
/// without the material of the cell. In plane stress it is 0, in plane strain \f$\nu\f$ times the sum
/// of the other two, less what a free strain across would take.
/// \param free         strain that needs no stress, null if there is none
/// \param free_across  the same across the plane
Eigen::Vector4d stress_at(const StrainPoint& point, const Cell& cell, const CellVector& u,
                          const double* free, double free_across) {
  return with_rows(cell.body.D.rows(), [&](auto n_rows) {
    using Components = Eigen::Matrix<double, n_rows, 1>;
    Components strain = fixed_rows<n_rows>(point.B) * u;
    if (free != nullptr) strain -= Eigen::Map<const Components>(free);
    const Components stress = fixed_rows<n_rows>(cell.body.D) * strain;
    Eigen::Vector4d all;
    if constexpr (n_rows == 4)
      all = stress;
    else
      all << stress, stress_across(cell.material, stress, free_across);
    return all;
  });
}

/// The stress at the strain points of a cell, row by row.
///
/// A cell of a material with a law says itself what its true stress is, per area where it stands. In
/// all others \f$\sigma = D\,(Bu - \varepsilon_0)\f$, with what needs no stress, as a warm cell that may
/// grow, taken off the strain.
PointStress stress_in(const Cell& cell, const NodeArray& displacements,
                      const Eigenstrain& eigenstrain, const StrainPoints& points) {
  if (cell.material.law != nullptr) return answer_of(cell, displacements).stress;
  const CellVector u = gathered(cell, displacements);
  PointStress stress(points.size, 4);
  PointStrains free;
  if (eigenstrain) free = eigenstrains(cell, points, eigenstrain);
  for (int i = 0; i < points.size; ++i) {
    const StrainPoint& point = points.point[at(i)];
    const double across = eigenstrain ? eigenstrain(cell.material, position(cell, point))(3) : 0;
    stress.row(i) =
        stress_at(point, cell, u, eigenstrain ? free.col(i).data() : nullptr, across).transpose();
  }
  return stress;
}

/// Calls compute(cell, points, stress, result) with the stress in every cell, on threads(), and
/// take(number, result) in the order of the cells.
///
/// Nodal values and means of cells both begin with this loop. Neighbours add to the same node, and
/// they do so in the order of their numbers, whoever computed their stresses first.
template <typename Result, typename Compute, typename Take>
void visit_stresses(const Mesh& mesh, const Element& element, const MaterialField& material,
                    const NodeArray& displacements, Compute&& compute, Take&& take) {
  require_argument(displacements.rows() == mesh.n_nodes(), "stress: need the displacements of ",
                   mesh.n_nodes(), " nodes, got ", displacements.rows());
  visit_results<Result>(
      Cells(mesh, element, material),
      [&](const Cell& cell, Result& result) {
        StrainPoints points;
        cell.element.strain(cell.body, points);
        compute(cell, points, stress_in(cell, displacements, material.eigenstrain, points), result);
      },
      [&](Index first, Index end, const std::vector<Result>& results) {
        for (Index cell = first; cell < end; ++cell) take(cell, results[at(cell - first)]);
      });
}

/// Takes values at the strain points to the nodes through the function that fits them best:
/// bilinear on the square, linear on the triangle.
///
/// The fit depends on the reference cell alone, not on the shape of the cell. So there is one
/// matrix for triangles and one for quadrilaterals, whatever the size of the mesh. The rule of q8
/// has nine points for a function of four terms, so the fit is one by least squares.
Eigen::MatrixXd extrapolation(const Element& element, const StrainPoints& points) {
  const Index n_terms = element.corners();
  const auto monomials = [n_terms](double x, double y) {
    return Eigen::RowVector4d(1, x, y, x * y).head(n_terms).eval();
  };
  Eigen::MatrixXd at_points(points.size, n_terms);
  for (int i = 0; i < points.size; ++i) {
    const Eigen::Vector2d& local = points.point[at(i)].local;
    at_points.row(i) = monomials(local.x(), local.y());
  }
  const CellNodes nodes = reference_nodes(element);
  Eigen::MatrixXd at_nodes(element.n_nodes, n_terms);
  for (Index k = 0; k < element.n_nodes; ++k) at_nodes.row(k) = monomials(nodes(k, 0), nodes(k, 1));
  return at_nodes * pseudo_inverse(at_points);
}

}  // namespace

/// The mean of what its cells say of a node, each cell as much as another. How many they are is counted
/// on the way. A node that no cell has keeps its zeros. The matrix of the fit is made by the thread
/// that needs it first.
StressArray nodal_stress(const Mesh& mesh, const Element& element, const MaterialField& material,
                         const NodeArray& displacements) {
  using AtNodes = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::ColMajor, max_cell_nodes, 4>;
  StressArray stress = StressArray::Zero(mesh.n_nodes(), 4);
  Eigen::VectorXd cells_at = Eigen::VectorXd::Zero(mesh.n_nodes());
  std::array<Eigen::MatrixXd, 2> of_kind;  // triangles, quadrilaterals
  std::array<std::once_flag, 2> made;
  visit_stresses<AtNodes>(
      mesh, element, material, displacements,
      [&](const Cell& cell, const StrainPoints& points, const PointStress& at_points,
          AtNodes& at_nodes) {
        const std::size_t kind = cell.element.corners() == 3 ? 0 : 1;
        Eigen::MatrixXd& to_nodes = of_kind[kind];
        std::call_once(made[kind], [&] { to_nodes = extrapolation(cell.element, points); });
        at_nodes.resize(to_nodes.rows(), 4);
        for (Index k = 0; k < at_nodes.rows(); ++k) at_nodes.row(k) = to_nodes.row(k) * at_points;
      },
      [&](Index cell, const AtNodes& at_nodes) {
        for (Index k = 0; k < at_nodes.rows(); ++k) {
          stress.row(mesh.cells(cell, k)) += at_nodes.row(k);
          cells_at(mesh.cells(cell, k)) += 1;
        }
      });
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    if (cells_at(node) > 0) stress.row(node) /= cells_at(node);
  return stress;
}

/// A mean over the volume, with the weights of the integration. It is not smoothed across sides, so
/// that it shows the jump between two cells, which the nodal average hides. A jump that is large
/// beside the stress itself says that the mesh is too coarse there.
StressArray cell_stress(const Mesh& mesh, const Element& element, const MaterialField& material,
                        const NodeArray& displacements) {
  StressArray stress = StressArray::Zero(mesh.n_cells(), 4);
  visit_stresses<Eigen::RowVector4d>(
      mesh, element, material, displacements,
      [](const Cell&, const StrainPoints& points, const PointStress& at_points,
         Eigen::RowVector4d& mean) {
        double volume = 0;
        mean.setZero();
        for (int i = 0; i < points.size; ++i) {
          const double share = points.point[at(i)].volume;
          mean += share * at_points.row(i);
          volume += share;
        }
        mean /= volume;
      },
      [&](Index cell, const Eigen::RowVector4d& mean) { stress.row(cell) = mean; });
  return stress;
}

/// A sum of squares cannot become negative, nor does it cancel. Take a body whose displacements are
/// \f$10^6\f$ times as large as their differences within a cell:
/// \f$u^T K u\f$ loses twelve of sixteen digits, this sum loses six, in \f$Bu\f$. A law has an energy of
/// its own, which is no such sum.
double strain_energy(const Mesh& mesh, const Element& element, const MaterialField& material,
                     const NodeArray& displacements) {
  require_argument(displacements.rows() == mesh.n_nodes(),
                   "strain_energy: need the displacements of ", mesh.n_nodes(), " nodes, got ",
                   displacements.rows());
  double energy = 0;
  visit_strains(mesh, element, material, [&](const Cell& cell, const StrainPoints& points) {
    if (cell.material.law != nullptr) {
      energy += answer_of(cell, displacements).energy;
      return;
    }
    const CellVector u = gathered(cell, displacements);
    with_rows(cell.body.D.rows(), [&](auto n_rows) {
      for (int i = 0; i < points.size; ++i) {
        const StrainPoint& point = points.point[at(i)];
        const Eigen::Matrix<double, n_rows, 1> strain = fixed_rows<n_rows>(point.B) * u;
        energy += 0.5 * point.volume * strain.dot(fixed_rows<n_rows>(cell.body.D) * strain);
      }
    });
  });
  return energy;
}

}  // namespace signorini
