/// \file
/// What an element is, and the family of elements. To add one: write `NAME.cpp` with a function
/// that returns an Element, declare it in elements.hpp and add its line to the table in
/// elements.cpp.
///
/// An element is a struct of functions: shape functions at a place, and strain operators at the
/// points of its rule. Whatever an element does to avoid locking (mean volume, internal modes) ends
/// in its matrices \f$B\f$, so that stiffness \f$\int B^T D B\f$, stress \f$D B u\f$ and thermal
/// forces \f$\int B^T D \epsilon_0\f$ are computed by the same lines for all of them. Classes with
/// virtual functions would say the same with more words. Matrices of a cell have a largest size
/// that the compiler knows, so that no cell asks the heap for memory.
#pragma once
#include <Eigen/Core>
#include <array>
#include <type_traits>
#include <vector>

#include "signorini/fem/material.hpp"

namespace signorini {

/// Most nodes of a cell: room for them is kept on the stack.
inline constexpr int max_cell_nodes = 8;
/// Most strain points of a cell.
inline constexpr int max_strain_points = 9;

/// Positions of the nodes of one cell, one row each [length]; never on the heap.
using CellNodes = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::ColMajor, max_cell_nodes, 2>;
/// One number per node of a cell.
using CellScalars = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_cell_nodes, 1>;
/// One number per unknown of a cell, ordered x, y of the first node, x, y of the second, ...
using CellVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 2 * max_cell_nodes, 1>;
/// Unknown by unknown of a cell.
using CellMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                 2 * max_cell_nodes, 2 * max_cell_nodes>;
/// epsilon = B u: rows xx, yy, 2 xy, in axial symmetry also the hoop strain, one column per unknown of the cell
/// [1/length].
using StrainMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 4, 2 * max_cell_nodes>;

/// B, or D, as a matrix of that many rows, which the compiler then knows.
template <int n_rows, int max_columns = 2 * max_cell_nodes>
using FixedRows =
    Eigen::Matrix<double, n_rows, Eigen::Dynamic, Eigen::ColMajor, n_rows, max_columns>;

/// Reads a strain matrix that has a known number of rows.
/// \tparam n_rows  3 in the plane, 4 in axial symmetry: as many as `B` has
/// \param B        strain matrix
/// \return the same numbers
template <int n_rows>
[[nodiscard]] Eigen::Map<const FixedRows<n_rows>> fixed_rows(const StrainMatrix& B) {
  return {B.data(), n_rows, B.cols()};
}

/// Reads D with a known number of rows.
/// \tparam n_rows  as many as `D` has
/// \param D        elasticity
/// \return the same numbers
template <int n_rows>
[[nodiscard]] Eigen::Map<const Eigen::Matrix<double, n_rows, n_rows>> fixed_rows(
    const Elasticity& D) {
  return Eigen::Map<const Eigen::Matrix<double, n_rows, n_rows>>(D.data());
}

/// Calls a function with the number of strain components as a constant, so that loops over them are unrolled.
/// \param n_rows    3 or 4
/// \param function  called with std::integral_constant<int, 3> or <int, 4>
/// \return what it returns
template <typename Function>
decltype(auto) with_rows(Eigen::Index n_rows, Function&& function) {
  if (n_rows == 3) return function(std::integral_constant<int, 3>());
  return function(std::integral_constant<int, 4>());
}

/// A cell as its element sees it.
struct CellBody {
  CellNodes
      arms;  ///< positions of the nodes, counted from `middle`, see arms_from_middle() [length]
  Eigen::Vector2d middle;  ///< of the box around the nodes [length]
  Elasticity D;            ///< of its material; 4 rows in axial symmetry [force/length^2]
  Depth depth;             ///< across the plane

  /// \param N  shape functions at a place
  /// \return the position there [length]
  [[nodiscard]] Eigen::Vector2d position(const CellScalars& N) const {
    return middle + arms.transpose() * N;
  }
  /// \param N  shape functions at a place
  /// \return x there, in axial symmetry the radius [length]
  [[nodiscard]] double x_at(const CellScalars& N) const { return middle.x() + arms.col(0).dot(N); }
  /// \param N  shape functions at a place
  /// \return the depth there [length]
  [[nodiscard]] double depth_at(const CellScalars& N) const { return depth.at(x_at(N)); }
  /// Hoop strain of displacements outwards, u / x: a circle of radius x becomes one of radius x + u.
  /// \param u  one or several at one place [-]
  /// \param N  shape functions at that place
  /// \return u / x in axial symmetry, else none [1/length]
  [[nodiscard]] CellScalars hoop(const CellScalars& u, const CellScalars& N) const {
    return D.rows() == 4 ? CellScalars(u / x_at(N)) : CellScalars();
  }
};

/// Shape functions at one place of the reference cell: the square [-1, 1]^2, or the triangle with the corners
/// (0, 0), (1, 0) and (0, 1).
struct Shape {
  CellScalars value;  ///< N [-]
  CellNodes slope;    ///< dN/dxi in column 0, dN/deta in column 1 [-]
};

/// Where the strain energy of a cell is sampled.
struct StrainPoint {
  Eigen::Vector2d local;  ///< (xi, eta) [-]
  double volume;          ///< quadrature weight times det J times depth [length^3]
  StrainMatrix B;         ///< strain operator, internal modes already condensed
};

/// The sampling points of one cell.
struct StrainPoints {
  std::array<StrainPoint, max_strain_points> point;  ///< the first `size` of them are filled
  int size = 0;                                      ///< how many there are
};

/// A strain at each strain point of a cell, one column per point: xx, yy, 2 xy, in axial symmetry also hoop [-].
using PointStrains =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 4, max_strain_points>;

/// One member of the family.
///
/// Everything else (stiffness, loads, stresses) follows from its functions. The strain operator
/// may depend on D, because internal modes are condensed with it; it must give zero strain for
/// every rigid motion and the exact strain for every linear displacement (after integration over
/// the cell).
struct Element {
  const char* name;      ///< as in find_element() and in a scene
  const char* summary;   ///< one line for lists
  Eigen::Index n_nodes;  ///< 3, 4, 6 or 8, in the order of Mesh
  int degree;  ///< complete polynomials it contains; displacements converge with degree + 1
  /// Shape functions at (xi, eta) of the reference cell.
  Shape (*shape)(double xi, double eta);
  /// Fills `points` for a cell; B has as many rows as its D.
  void (*strain)(const CellBody& cell, StrainPoints& points);
  /// Takes from strains at those points what internal modes give way to where nothing moves the nodes; null if there
  /// are no modes. A uniform strain they leave alone.
  void (*relax)(const CellBody& cell, const StrainPoints& points, PointStrains& strains) = nullptr;
  bool mean_volume = false;  ///< whether B has the change of volume averaged over the cell

  /// \return number of corners: 4 if the reference cell is the square, 3 if it is the triangle
  [[nodiscard]] int corners() const { return n_nodes % 3 == 0 ? 3 : 4; }
};

/// Map from the reference cell to a cell at one place.
struct Jacobian {
  Eigen::Matrix2d matrix;  ///< rows d/dxi, d/deta of (x, y) [length]
  double determinant;      ///< [length^2]
  CellNodes gradient;      ///< dN/dx in column 0, dN/dy in column 1 [1/length]
};

/// Derivatives of the shape functions with respect to x and y.
/// \param shape  of `m` nodes at one place
/// \param nodes  `m x 2` positions [length]; the cell must not be degenerate there
/// \return the map at that place
[[nodiscard]] Jacobian jacobian(const Shape& shape, const CellNodes& nodes);

/// The plain strain operator of displacement shape functions.
/// \param gradient  `m x 2` dN/dx, dN/dy [1/length]
/// \param hoop      `m` N/x in axial symmetry, else none [1/length]
/// \param B         receives `3 x 2m`, in axial symmetry `4 x 2m` [1/length]
void write_strain_matrix(const CellNodes& gradient, const CellScalars& hoop, StrainMatrix& B);

/// One point of a Gauss rule.
struct GaussPoint {
  double xi;      ///< first coordinate [-]
  double eta;     ///< second coordinate [-]
  double weight;  ///< [-]
};
/// The n x n Gauss rule on the square [-1, 1]^2.
/// \param n  2 or 3
/// \return points with xi running first; the weights add up to 4
/// \throws std::invalid_argument for other n
[[nodiscard]] const std::vector<GaussPoint>& gauss_square(int n);
/// Rules of Gauss's kind on the triangle (0, 0), (1, 0), (0, 1), with all points inside and positive weights
/// [\ref Dunavant1985].
/// \param n  3, exact for polynomials of degree 2; or 6, of degree 4
/// \return points; the weights add up to 1/2
/// \throws std::invalid_argument for other n
[[nodiscard]] const std::vector<GaussPoint>& gauss_triangle(int n);
/// The Gauss rule on the interval [-1, 1], exact for polynomials of degree 2 n - 1.
/// \param n  1 to 16
/// \return points with eta = 0 and xi increasing; the weights add up to 2
/// \throws std::invalid_argument for other n
[[nodiscard]] const std::vector<GaussPoint>& gauss_line(int n);

/// The largest rule on the reference cell of an element.
/// \param element  any
/// \return gauss_square(3) or gauss_triangle(6)
[[nodiscard]] const std::vector<GaussPoint>& gauss_cell(const Element& element);
/// Where the nodes are in the reference cell of an element.
/// \param element  any
/// \return `n_nodes x 2` (xi, eta): corners, and midpoints of the sides [-]
[[nodiscard]] CellNodes reference_nodes(const Element& element);

/// The plain strain operator at the points of a rule, without internal modes.
/// \param shape   shape functions of the element
/// \param rule    on the reference cell of the element
/// \param cell    any
/// \param points  receives place, volume and B of every point of the rule, in its order
void sample_strain(Shape (*shape)(double xi, double eta), const std::vector<GaussPoint>& rule,
                   const CellBody& cell, StrainPoints& points);

}  // namespace signorini
