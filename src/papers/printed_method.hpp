/// \file
/// The method of the paper as it is printed, run on one problem, and its sets of pairs as tables.
#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "papers/quasi_active_set_literal.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/results.hpp"

namespace signorini {

/// The printed method on one problem, outside and inside.
struct PrintedMethod {
  QuasiActiveRun all;               ///< QAS is all violated rows
  QuasiActiveRun one;               ///< QAS is the row that overlaps most
  std::vector<Eigen::Index> group;  ///< first QAS of `all`
  std::vector<std::vector<Eigen::Index>>
      weights;             ///< weight_supports() of `group` with rows scaled, fully corrective
  Eigen::Index jumps = 0;  ///< how often (28) as printed jumps on the rows of `group` until a vertex comes back
};

/// Runs the printed method, and the weights of its first subproblem.
/// \param problem  G positive semidefinite and d, with at least one overlap
/// \return pairs of `group` are those of the problem, pairs of `weights` are places in `group`
/// \throws std::invalid_argument as check_problem(), or if no pair overlaps
[[nodiscard]] PrintedMethod printed_method(const ContactProblem& problem);

/// Whether the method ends at the solution after one step, with all violated rows and with independent
/// rows by index and by violation.
/// \param problem   G positive semidefinite and d
/// \param solution  of it, from another solver
/// \return whether closed pairs are the same and forces agree to 1e-9 in all three
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] bool solved_in_one_step(const ContactProblem& problem, const ContactState& solution);

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

/// Writes the data of a figure: STEM_all.csv and STEM_one.csv by outer_steps(), STEM_inner.csv by
/// inner_steps().
/// \param stem  such as `out / "fig_6_5"`
/// \param run   of printed_method()
/// \param at    `n_c`, where the pairs are
/// \throws std::invalid_argument if `at` has not one entry per pair
/// \throws ProblemError if a file cannot be written
void write_printed_method(const std::filesystem::path& stem, const PrintedMethod& run,
                          const Eigen::VectorXd& at);

/// Notes the sizes of a run's sets: `pairs`, `overlaps` without contact and `closed` pairs of `all`,
/// `weight_steps` inside, `jumps`, and of `one` `single_steps` and `single_closed`.
/// \param results  gets them
/// \param run      of printed_method()
/// \param suffix   of their names
void add_counts(Results& results, const PrintedMethod& run, const std::string& suffix = "");

}  // namespace signorini
