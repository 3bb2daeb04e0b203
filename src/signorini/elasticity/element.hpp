/// \file
/// What an element is, and the family of elements. To add one: write `NAME.cpp` with a function that
/// returns an Element, declare it in elements.hpp and add its line to the table in elements.cpp.
#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace signorini {

inline constexpr int max_cell_nodes = 8;
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
/// epsilon = B u: rows xx, yy, 2 xy, one column per unknown of the cell [1/length].
using StrainMatrix =
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 2 * max_cell_nodes>;

/// Shape functions at one place of the reference square [-1, 1]^2.
struct Shape {
  CellScalars value;  ///< N [-]
  CellNodes slope;    ///< dN/dxi in column 0, dN/deta in column 1 [-]
};

/// Where the strain energy of a cell is sampled.
struct StrainPoint {
  Eigen::Vector2d local;  ///< (xi, eta) [-]
  double area;            ///< quadrature weight times det J [length^2]
  StrainMatrix B;         ///< strain operator, internal modes already condensed
};

/// The sampling points of one cell; `size` of them are filled.
struct StrainPoints {
  std::array<StrainPoint, max_strain_points> point;
  int size = 0;
};

/// One member of the family.
///
/// Everything else (stiffness, loads, stresses) follows from the two functions. The strain operator may
/// depend on D, because internal modes are condensed with it; it must give zero strain for every
/// rigid motion and the exact strain for every linear displacement (after integration over the cell).
struct Element {
  const char* name;
  const char* summary;   ///< one line for lists
  Eigen::Index n_nodes;  ///< 4 or 8, in the order of Mesh
  int degree;  ///< complete polynomials it contains; displacements converge with degree + 1
  Shape (*shape)(double xi, double eta);
  void (*strain)(const CellNodes& nodes, const Eigen::Matrix3d& D, StrainPoints& points);
};

/// Map from the reference square to a cell at one place.
struct Jacobian {
  Eigen::Matrix2d matrix;  ///< rows d/dxi, d/deta of (x, y) [length]
  double determinant;      ///< [length^2]
  CellNodes gradient;      ///< dN/dx in column 0, dN/dy in column 1 [1/length]
};

/// Derivatives of the shape functions with respect to x and y.
[[nodiscard]] Jacobian jacobian(const Shape& shape, const CellNodes& nodes);

/// The plain strain operator of displacement shape functions with these gradients.
[[nodiscard]] StrainMatrix strain_matrix(const CellNodes& gradient);

/// Points and weights of the n x n Gauss rule on the reference square, n = 2 or 3.
struct GaussPoint {
  double xi;
  double eta;
  double weight;
};
[[nodiscard]] const std::vector<GaussPoint>& gauss_square(int n);
/// The Gauss rule on [-1, 1]; `eta` is 0. n = 1, 2 or 3.
[[nodiscard]] const std::vector<GaussPoint>& gauss_line(int n);

}  // namespace signorini
