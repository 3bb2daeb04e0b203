/// \file
/// The best point on a face of the simplex of weights.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// The forces of the pairs W in use, \f$ G_{WW}\lambda_W = b_W \f$ with \f$ \lambda_W > 0 \f$: up to
/// their sum the weights with the largest s on the face with the vertices W.
///
/// A Cholesky factor of G_WW grows by one row with every vertex and is begun anew at the place of a
/// vertex that is dropped.
class SimplexFace {
 public:
  /// The face without vertices. \param problem  G and d; must live as long as this object
  explicit SimplexFace(const ContactProblem& problem);

  /// Takes one more vertex into the face.
  ///
  /// The force of the new pair grows from zero and the others yield so that their gaps stay closed,
  /// until its own gap is closed too; a vertex whose force vanishes on the way is dropped.
  /// \param vertex  a pair outside of W whose gap is negative under the present forces
  /// \return false if nothing ends this: then infeasibility() proves that the gaps contradict
  bool add(Eigen::Index vertex);

  /// \return W in the order of the factor
  [[nodiscard]] const std::vector<Eigen::Index>& vertices() const { return vertices_; }
  /// \return lambda `n_c` [force], 0 outside of W
  [[nodiscard]] Eigen::VectorXd forces() const;
  /// \return after add() returned false: y `n_c` >= 0 with G y = 0 and d^T y < 0
  [[nodiscard]] const Eigen::VectorXd& infeasibility() const { return infeasibility_; }
  /// \return factorisations, one per vertex dropped and one for the first
  [[nodiscard]] Eigen::Index factorisations() const { return factorisations_; }

 private:
  [[nodiscard]] Eigen::VectorXd factor_row(Eigen::Index vertex) const;
  void append(Eigen::Index vertex);
  void drop(Eigen::Index place);
  void settle();

  const ContactProblem& problem_;
  Eigen::VectorXd root_;  // sqrt(G_ii)
  std::vector<Eigen::Index> vertices_;
  Eigen::MatrixXd factor_;  // L of G_WW in its upper left corner
  Eigen::VectorXd force_;   // of the vertices, in their order
  Eigen::VectorXd infeasibility_;
  Eigen::Index factorisations_ = 0;
};

}  // namespace signorini
