// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Displacements of one body, and what its eigenstrain makes of their strains.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/fem/eigenstrain.hpp"

namespace signorini {

/// Displacements of one body whose stresses are recovered together: the first are those of the body, with its eigenstrain;
/// the others are those of dual solutions, which have none.
struct PrimalAndDuals {
  const Mesh& mesh;                      ///< the body
  const Element& element;                ///< fits its cells
  const MaterialField& material;         ///< of its cells
  std::vector<NodeArray> displacements;  ///< `n_nodes x 2` of each field [length]
};

/// The strains of all fields at the strain points of all cells: one point after the other, of each point one field after the
/// other. Elements are asked for them once, for recovery and for what is made of it.
struct ElementStrains {
  std::vector<Eigen::Index> first;     ///< point of each cell, and the number of all points
  std::vector<Eigen::Vector2d> local;  ///< (xi, eta) of each point [-]
  std::vector<double> volume;          ///< of each point [length^3]
  std::vector<double> elastic;         ///< strains that need stress [-]
  std::vector<double> modes;           ///< strains that are not those of the displacements [-]

  /// \param strains  `elastic` or `modes` \param number  of a point, by the number of fields, plus that of a field
  /// \return the components there
  template <int n_rows>
  [[nodiscard]] static Eigen::Map<const Eigen::Matrix<double, n_rows, 1>> of(
      const std::vector<double>& strains, Eigen::Index number) {
    return Eigen::Map<const Eigen::Matrix<double, n_rows, 1>>(strains.data() + n_rows * number);
  }
};

/// \param fields  any \return their strains
/// \throws ProblemError as check_material()
[[nodiscard]] ElementStrains element_strains(const PrimalAndDuals& fields);

/// Checks the displacements. \param fields  any
/// \throws std::invalid_argument unless there is one displacement per node
void check_primal_and_duals(const PrimalAndDuals& fields);

/// The strains of a body that need no stress, cell by cell. A body without an eigenstrain has none, at no cost.
class FreeStrains {
 public:
  /// \param material  of the body; must outlive this
  explicit FreeStrains(const MaterialField& material) : eigenstrain_(material.eigenstrain) {}
  /// Goes to a cell. \param cell  any \param points  where strains are taken
  void look(const Cell& cell, const StrainPoints& points) {
    if (eigenstrain_) relaxed_ = eigenstrains(cell, points, eigenstrain_);
  }
  /// \param field  number of a field \return whether it has an eigenstrain: the first of a body that has one
  [[nodiscard]] bool in(Eigen::Index field) const { return eigenstrain_ && field == 0; }
  /// \param point  number of a strain point of the cell \return the strain that its element reads no stress from [-]
  [[nodiscard]] auto relaxed(int point) const { return relaxed_.col(point); }
  /// \param cell   the cell \param point  one of its strain points \return strain_in_plane() of the eigenstrain there [-]
  [[nodiscard]] Eigen::Vector4d at(const Cell& cell, const StrainPoint& point) const {
    return strain_in_plane(cell.material, eigenstrain_(cell.material, position(cell, point)));
  }

 private:
  const Eigenstrain& eigenstrain_;
  PointStrains relaxed_;
};

}  // namespace signorini
