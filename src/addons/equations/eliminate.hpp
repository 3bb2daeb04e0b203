// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Linear equations, solved for as many unknowns as there are independent ones.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/contact/pairs.hpp"
#include "signorini/fem/unknowns.hpp"

namespace signorini {

/// The columns of unknowns.
/// \param rows      `m x 2 n_nodes` \param unknowns  `n` \return `m x n`
[[nodiscard]] NodalRows free_columns(const NodalRows& rows, const Unknowns& unknowns);

/// Equations \f$ Cu = h \f$ in the form \f$ u_e = R u + L h \f$, in which R has no entry of an eliminated unknown.
struct Eliminated {
  std::vector<Eigen::Index> unknown = {};        ///< `n_e` numbers e of the unknowns
  NodalRows by = {};                             ///< R `n_e x n` [-]
  NodalRows right = {};                          ///< L `n_e x m` [-]
  std::vector<Eigen::Index> repeated = {};       ///< rows that others say as well
  std::vector<Eigen::Index> contradicting = {};  ///< rows that say other things than others
  double apart = 0;         ///< by how much the first of these does [length]
  Eigen::Index other = -1;  ///< the row that counts most in what it contradicts; -1: only what supports give
};

/// Solves equations one after the other, each for the unknown that it names, if the row has a good part of it, or for
/// that of its largest entry.
/// \param rows      C `m x n`
/// \param right     h `m`
/// \param rounding  `m` by how much each entry of h may be wrong
/// \param own       `m` unknowns that rows name, or -1
/// \param which     numbers of the rows that are equations
/// \return the solved form
[[nodiscard]] Eliminated eliminate(const NodalRows& rows, const Eigen::VectorXd& right,
                                   const Eigen::VectorXd& rounding,
                                   const std::vector<Eigen::Index>& own,
                                   const std::vector<Eigen::Index>& which);

}  // namespace signorini
