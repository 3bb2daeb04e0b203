// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Numbers that vary from place to place: a table over a coordinate or over the length of a boundary, or a polynomial in x and y.
///
/// A load, a displacement, a temperature and an interference that vary are functions of the place. What a load needs besides is
/// where it is integrated: a table has kinks and jumps, and a polynomial of high degree needs many points. So a variation has
/// a rule for each side. It is exact on straight sides; on parabolas exact for a pressure over x or y, otherwise to rounding if a
/// side turns by less than 45 degrees: a traction is multiplied by the length of the tangent, which is no polynomial there.
#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "addons/along/arc_length.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini {

/// What a table is over.
enum class Over {
  X,      ///< the coordinate x, in axial symmetry the radius
  Y,      ///< the coordinate y
  Length  ///< the length of the boundary from its first node, in walking order
};

/// One number for each place, or two.
struct Variation {
  Over over = Over::X;  ///< of a table
  /// Of a table: where its rows stand, increasing; the same twice is a jump [length]
  std::vector<double> places = {};
  std::vector<std::array<int, 2>> powers = {};  ///< of a polynomial: i and j of x^i y^j
  Eigen::MatrixXd values = {};  ///< `rows x 1` or `rows x 2`: of the table, or coefficients
  std::shared_ptr<const ArcLength> length = {};  ///< of the boundary, for a table over it

  /// \param x  a place [length] \return one number or two: straight between rows, constant beyond the first and the last
  [[nodiscard]] Eigen::VectorXd at(const Eigen::Vector2d& x) const;
  /// \return highest power of its polynomial, or 1 of a table
  [[nodiscard]] int degree() const;
};

/// Highest degree of a polynomial. A pressure on a parabola makes 2 + 1 + 2 + 26 = 31 of it along the side, of shape function,
/// tangent, radius and load: as much as sixteen Gauss points integrate exactly.
constexpr int largest_degree = 13;

/// \param variation  of one number \param scale  that it is divided by
/// \return it as a function of the place; empty if the scale is 0
[[nodiscard]] ScalarField field_of(const Variation& variation, double scale = 1);

/// \param variation  of one number \param nodes  where it is looked at besides the rows of its table [length]
/// \return the largest size that it has there; 1 if only those places are zero, 0 if all is
[[nodiscard]] double largest_size(const Variation& variation, const NodeArray& nodes);

/// Where a load that varies is integrated: between kinks and jumps of its table, with as many points as its degree needs.
/// \param variation  any
/// \return the rule of a side
[[nodiscard]] SideRule rule_of(const Variation& variation);

}  // namespace signorini
