// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Gap rows as an updated factor needs them: condensed when they are asked for.
#pragma once
#include <Eigen/Core>
#include <functional>

#include "signorini/problem/active_set_factor.hpp"
#include "signorini/problem/scaled.hpp"

namespace signorini {

/// What methods that grow a ActiveSetFactor ask of the rows of a problem, however these are known.
struct ConstraintRows {
  Eigen::Index count = 0;  ///< number of rows m
  Eigen::Index equations =
      0;                  ///< so many of the first are always closed, their forces have any sign
  Eigen::Index rank = 0;  ///< most rows that can be independent
  const Eigen::VectorXd* unit =
      nullptr;  ///< `m` gaps in the units of the problem = gaps / unit; null: 1
  const Eigen::VectorXd* weight = nullptr;  ///< `m` about 1 / |h_i|, to compare overlaps with
  /// Sets the gaps of all rows `m` and what rounding may have done to each.
  std::function<void(const ActiveSetFactor&, Eigen::VectorXd& gap, Eigen::VectorXd& rounding)> gaps;
  /// Condenses rows, named by `candidates.rows`: \f$ h_i / |h_i| \f$ or the same in products.
  std::function<void(const ActiveSetFactor&, const Eigen::VectorXd& gap,
                     const Eigen::VectorXd& rounding, ActiveSetFactor::Candidates& candidates)>
      fetch;
};

/// The rows of a condensed problem.
/// \param problem  scaled, without friction and rigid modes; must outlive the rows
/// \param ones     `n_c` ones, which must outlive them too
/// \return rows whose products are taken from G
[[nodiscard]] ConstraintRows rows_of(const ScaledProblem& problem, const Eigen::VectorXd& ones);

}  // namespace signorini
