/// \file
/// The best point on a face of the simplex of weights.
#pragma once
#include <Eigen/Core>
#include <memory>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// The forces of the pairs W in use, \f$ G_{WW}\lambda_W = b_W \f$ with \f$ \lambda_W > 0 \f$: up to
/// their sum the weights with the largest s on the face with the vertices W. Vertices join and leave as pairs do in
/// goldfarb_idnani(), by the same steps.
class SimplexFace {
 public:
  /// The face without vertices. \param problem  G and d
  explicit SimplexFace(const ContactProblem& problem);

  /// Takes one more vertex into the face.
  ///
  /// The force of the new pair grows from zero and the others yield so that their gaps stay closed,
  /// until its own gap is closed too; a vertex whose force vanishes on the way is dropped.
  /// \param vertex  a pair outside of W whose gap is negative under the present forces
  /// \return false if nothing ends this: then farkas_certificate() proves that the gaps contradict
  bool add(Eigen::Index vertex);

  /// \return lambda `n_c` [force], 0 outside of W
  [[nodiscard]] Eigen::VectorXd forces() const;
  /// \return after add() returned false: y `n_c` >= 0 with G y = 0 and d^T y < 0
  [[nodiscard]] Eigen::VectorXd farkas_certificate() const;
  /// \return factorisations: one, which is updated from there on, or none
  [[nodiscard]] Eigen::Index factorisations() const;

 private:
  struct Numbers;
  std::shared_ptr<Numbers> numbers_;
};

}  // namespace signorini
