// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How far a linear function goes over a polyhedron of which a point is known.
#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

namespace signorini {

/// The points y with h + G y >= 0, where y = 0 is one: the simplex method from the vertex before. The steepest
/// variable enters, after a step of length 0 that of the least number [\ref Bland1977]; of the slacks that vanish
/// first, but for rounding, the fastest leaves [\ref Harris1973]. The vertex at the end is solved for anew.
///
/// All slacks h + G y and all coordinates of y are kept as linear functions of k of them. At first these are the y,
/// which have any sign; each is exchanged for the slack that blocks it, and what nothing blocks either way is a line
/// in the polyhedron.
class Polyhedron {
 public:
  /// \param G  `m x k`
  /// \param h  `m` >= 0
  Polyhedron(const Eigen::MatrixXd& G, const Eigen::VectorXd& h);

  /// \param c  `k`
  /// \return least and largest c^T y; infinite where nothing bounds it, NaN if 10 pivots per row are not enough
  ///   or the vertex is not in the polyhedron to rounding
  [[nodiscard]] std::pair<double, double> range(const Eigen::VectorXd& c);

  /// \return how many exchanges it took so far
  [[nodiscard]] Eigen::Index pivots() const { return pivots_; }

 private:
  [[nodiscard]] double most(const Eigen::VectorXd& c);
  /// The slack that vanishes first when a variable outside of the basis grows, or falls if sign < 0; -1 if none does.
  [[nodiscard]] Eigen::Index blocking(Eigen::Index column, double sign) const;
  void pivot(Eigen::Index row, Eigen::Index column);
  /// The y where all variables outside of the basis vanish, anew from G and h.
  [[nodiscard]] Eigen::VectorXd vertex() const;
  [[nodiscard]] double rounding() const;

  Eigen::MatrixXd G_;
  Eigen::VectorXd h_;
  Eigen::Index slacks_;
  Eigen::Index k_;
  Eigen::MatrixXd rows_;  ///< `m + k` by `k + 1`: slacks, then y; the last column are values
  std::vector<Eigen::Index> nonbasic_;  ///< `k` rows that the columns stand for
  Eigen::Index pivots_ = 0;
};

}  // namespace signorini
