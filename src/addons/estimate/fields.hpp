/// \file
/// Displacements of one body, and what its temperature makes of their strains.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "addons/effects/thermal.hpp"
#include "signorini/fem/cells.hpp"

namespace signorini {

/// Displacements of one body whose stresses are recovered together: the first are those of the body, as warm as it is;
/// the others are those of dual solutions, which no temperature strains.
struct Fields {
  const Mesh& mesh;                      ///< the body
  const Element& element;                ///< fits its cells
  const Matter& matter;                  ///< of its cells
  std::vector<NodeArray> displacements;  ///< `n_nodes x 2` of each field [length]
};

/// Checks the displacements. \param fields  any
/// \throws std::invalid_argument unless there is one displacement per node
void check_fields(const Fields& fields);

/// The strains of a warm body that need no stress, cell by cell. A body that is not warm has none, at no cost.
class Warmth {
 public:
  /// \param matter  of the body; must outlive this
  explicit Warmth(const Matter& matter);
  /// Goes to a cell. \param cell  any \param points  where strains are taken
  void look(const Cell& cell, const StrainPoints& points);
  /// \param field  number of a field \return whether its strains are those of a warm body: the first of one that is
  [[nodiscard]] bool warms(Eigen::Index field) const { return warm_ && field == 0; }
  /// \param point  number of a strain point of the cell \return the strain that its element reads no stress from [-]
  [[nodiscard]] auto relaxed(int point) const { return relaxed_.col(point); }
  /// \param cell   the cell \param point  one of its strain points \return how much warmer it is there [temperature]
  [[nodiscard]] double at(const Cell& cell, const StrainPoint& point) const {
    return temperature_.at(position(cell, point));
  }

 private:
  const Temperature& temperature_;
  bool warm_;
  PointStrains relaxed_;
};

}  // namespace signorini
