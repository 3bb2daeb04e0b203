// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Messages about how the run of a scene ended.
#pragma once
#include <string>

#include "addons/certified/known_forces.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Where a pair is. \param model  that has it \param pair  its number \return its node, if it has one, and the place
[[nodiscard]] std::string pair_in_words(const Model& model, Eigen::Index pair);

/// The warning of several solutions: which pair it rests on, and from which friction on it holds.
/// \param model  that was solved
/// \param figure  of its solution, see uniqueness_warning()
/// \return a sentence
[[nodiscard]] std::string uniqueness_warning_in_words(const Model& model,
                                                      const UniquenessWarning& figure);

/// What is known where Lemke's method ran off along a ray, and the way out.
///
/// Where supports and springs hold all bodies and no pair depends on others, the compliance F is positive definite, and
/// there is a solution whatever the friction, see lemke(); where only contact holds a body, there need be none.
/// \param model  that was not solved
/// \return a sentence, with the pair of the largest friction coefficient
[[nodiscard]] std::string ray_in_words(const Model& model);

/// Names the pairs that cannot all be free of overlap. What counts for less in the proof than half of its digits is rounding.
/// \param model  that was not solved
/// \param proof  forces `n_c` that move nothing and work on the gaps of the meshes, see ContactState::farkas_certificate
/// \return a sentence with the pairs that count most in it, and the way out; empty without a proof
[[nodiscard]] std::string contradiction_in_words(const Model& model, const Eigen::VectorXd& proof);

/// The note on forces that rounding of the gaps may have moved.
/// \param model  that was solved
/// \param figure  of its forces, see force_uncertainty()
/// \return a sentence, with contact, pair, percent and the way out
[[nodiscard]] std::string force_uncertainty_in_words(const Model& model,
                                                     const ForceUncertainty& figure);

}  // namespace signorini
