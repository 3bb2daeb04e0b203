// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What the patterns of K and A tell of a plan: its systems, its fronts, and the way of its rows through them.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "addons/frontal/fronts.hpp"
#include "addons/frontal/separator_tree.hpp"
#include "signorini/core/alignment.hpp"
#include "signorini/problem/systems.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Everything about K, its factor and the rows of A that needs no numbers.
struct Pattern {
  Eigen::SparseMatrix<double> stiffness;  ///< `n x n`, its values have no meaning
  NodalRows rows;                         ///< see contact_rows()
  std::vector<SystemParts> systems;       ///< that nothing connects, one at least
  Fronts fronts;                          ///< of K
  RowPaths paths;                         ///< of the rows through the fronts
  EliminationOrder order;                 ///< of K
  Ledger taken;                           ///< what it took to find the order, as a phase of the factor
  double analysis = 0;                    ///< what it took to find the fronts [s]
};

/// Makes pattern, tree of separators and fronts as condense() makes them.
/// \param plan  from plan()
/// \return what is known without numbers
[[nodiscard]] Pattern pattern_of(const Plan& plan);

}  // namespace signorini
