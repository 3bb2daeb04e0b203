/// \file
/// The steps of the paper's method as tables, for pictures of its sets of pairs.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/complementarity/quasi_active_set_literal.hpp"
#include "signorini/core/table.hpp"

namespace signorini {

/// Every pair that overlaps before a step of the outer loop, step by step.
///
/// Columns step (from 0), at, quasi_active and closed (1 or 0: taken into QAS; pressed by the step).
/// \param run  of run_quasi_active_set_literal()
/// \param at   `n_c`, where the pairs are, such as the position along the boundary
/// \return one row per pair and step
/// \throws std::invalid_argument if `at` has not one entry per pair
[[nodiscard]] Table outer_steps(const QuasiActiveRun& run, const Eigen::VectorXd& at);

/// Every pair that carries weight, step by step.
///
/// Columns step (from 0), at, joins (1 if the pair had no weight one step before).
/// \param supports  of weight_supports()
/// \param at        where the pairs are
/// \return one row per pair and step
/// \throws std::invalid_argument if a pair has no entry in `at`
[[nodiscard]] Table inner_steps(const std::vector<std::vector<Eigen::Index>>& supports,
                                const Eigen::VectorXd& at);

}  // namespace signorini
