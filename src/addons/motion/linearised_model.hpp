// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// A model that is made linear about where its bodies stand, place after place.
#pragma once
#include <Eigen/SparseCore>

#include "addons/motion/body_answers.hpp"
#include "addons/motion/corrected_solve.hpp"
#include "addons/motion/moving_step.hpp"

namespace signorini {

/// The linear problem of a place, in the way d that is left, see moving_step.cpp. It lives as long as a step.
class LinearisedModel {
 public:
  /// \param place      finds pairs
  /// \param before     where the bodies stood at the end of the last step
  /// \param[in,out] model  with the loads of the step and the K of its bodies before strain; all must outlive this
  LinearisedModel(const PlacePairs& place, const Displaced& before, Model& model);

  /// Makes the model linear about a place. At rest it is that of the scene, bit by bit.
  /// \param there        of all nodes
  /// \param ledger       gets the phases `forces` and `pairs`
  /// \throws ProblemError if no pairs can be found there, or a cell inverts; the place is then still the last one
  void move(const Displaced& there, Ledger& ledger);

  /// \param way    d of the unknowns, and with all of it what supports still have to give
  /// \param share  of it
  /// \return that place
  [[nodiscard]] Displaced ahead(const PrimalDual& way, double share) const;

  /// How contact forces turn on the way, with all of it what supports still have to give: the pairs are found a little ahead.
  /// \param look  how far ahead at most [length]
  /// \return the change of \f$ N^T\lambda + S^T\tau \f$ along a way, to first order, of the unknowns of the nodes of pairs; 0 if there
  ///   are other pairs ahead. The function refers to this object; do not call move() while it is in use
  [[nodiscard]] TurnedForces turned(double look) const;

  /// \param solution  of a linear problem with the same pairs
  /// \return its certificate if its forces are those of the equations here, and nothing more is to move
  [[nodiscard]] Certificate certificate(const Solution& solution) const;

  /// From the way of the last iteration to the displacements of the scene, and to a model whose equations these fulfil.
  /// \param[in,out] solution  that is certified here
  void conclude(Solution& solution) const;

  /// Gives the model the K of its bodies before strain, and no order of elimination.
  void restore() const;

  /// \return whether bodies are where the scene has them
  [[nodiscard]] bool at_rest() const { return at_.high.isZero(0) && at_.low.isZero(0); }
  /// \return whether supports have given all that they give in this step
  [[nodiscard]] bool arrived() const;
  /// \return whether K changes with the place
  [[nodiscard]] bool finite() const { return bodies_.finite(); }

 private:
  const PlacePairs& place_;
  const Displaced& before_;
  Model& model_;
  BodyAnswers bodies_;
  Eigen::SparseMatrix<double> stiffness_;  // before strain
  Eigen::SparseMatrix<double> tangent_;    // of the place before, for its memory
  Eigen::VectorXd load_;                   // of the scene
  Eigen::VectorXd outer_;
  Displaced at_;
};

/// \param model  any; the same afterwards \return a copy of it without K, which is large
[[nodiscard]] Model without_stiffness(Model& model);

/// The certificate of a state.
/// \param claim  u from the scene, and forces
/// \param model  that stands where the state has it, its gaps counted from the scene
/// \return of the equations there
[[nodiscard]] Certificate certificate_where_it_stands(const PrimalDual& claim, Model model);

}  // namespace signorini
