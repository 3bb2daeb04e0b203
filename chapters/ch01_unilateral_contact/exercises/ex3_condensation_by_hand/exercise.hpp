/// \file
/// Exercise 1.3 - condensation by hand. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace ex1_3 {

/// A body that rests where K u = p.
struct Body {
  Eigen::MatrixXd stiffness;  ///< K `n x n`, symmetric positive definite [force/length]
  Eigen::VectorXd load;       ///< p `n` [force]
};

/// The same body for those who do not look at one of its unknowns: the others move as before, whatever forces are
/// added to their loads.
/// \param body     of at least two unknowns
/// \param unknown  the one that leaves
/// \return the others, in their order
/// \throws std::invalid_argument if there is no such unknown, or its diagonal entry is not positive
[[nodiscard]] Body without(const Body& body, Eigen::Index unknown);

/// What contact has to know of a body: a force on each stop leaves the gaps free_gap + compliance * force.
struct Condensed {
  Eigen::MatrixXd compliance;  ///< G `n_c x n_c` [length/force]
  Eigen::VectorXd free_gap;    ///< d `n_c` [length], overlap < 0
};

/// Eliminates every unknown that touches nothing, and then those that do.
/// \param body         as above
/// \param touching     `n_c` unknowns that have a stop in front of them, in any order, at least one
/// \param initial_gap  g `n_c` [length]: how far each of these may move
/// \return compliance and free gaps of the stops, in the order of `touching`
/// \throws std::invalid_argument if the sizes differ, or an unknown is not there or named twice
[[nodiscard]] Condensed condense(const Body& body, const std::vector<Eigen::Index>& touching,
                                 const Eigen::VectorXd& initial_gap);

}  // namespace ex1_3
