/// \file
/// The condensed problem of a model, and the solution.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "signorini/core/ledger.hpp"
#include "signorini/fem/factor.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/shared_forces.hpp"
#include "signorini/scene/model.hpp"

namespace signorini {

/// The model with all unknowns but the contact forces eliminated.
struct Condensed {
  Factor factor;                      ///< of K, or of K and one spring per rigid mode
  ContactProblem problem;             ///< F = A K^-1 A^T, d, s, the law, R and r
  Eigen::VectorXd free_displacement;  ///< u0 = K^-1 p `n` [length]
  KnownMatrices known = {};  ///< of K, A and the law, where many loads follow that leave them as they are
  /// Where loads lead if pairs go on as before: u in two parts, and the forces of all rows of A, which balance the load. Whoever
  /// solves may look there first; nothing if it is not known
  std::optional<PrimalDual> expected = {};
};

/// Everything that is known at the end. Unless `contact.report.status` is Solved it is no solution: it then has
/// the best set of pairs that could be refined, with its certificate, or, if none could, the report, what was
/// proved and the ledger only.
struct Solution {
  std::vector<NodeArray> displacements;  ///< `n_nodes x 2` of each body [length]
  /// `n_nodes x 2` of each body less what carries it, with the digits that are lost beside that [length]; empty: nothing does
  std::vector<NodeArray> strains = {};
  ContactState contact;                  ///< refined forces, gaps, slips and status per pair
  Eigen::VectorXd pressure;              ///< `n_c` force / weight [force/length^2], compression > 0
  PrimalDual refined;                    ///< unknowns in two parts, and the forces of all rows of A
  /// Of `refined`, from the original K, p, A, g and the law of friction.
  Certificate certificate = uncertified();
  /// Of a solution: groups of pairs whose forces are not determined, from undetermined_forces()
  std::vector<SharedForces> shared = {};
  std::string unbounded_direction;  ///< if the load pulls a body away: how it moves off
  /// How much of the whole load contact and friction can hold at most [-]: with `unbounded_direction` it is proved by
  /// balanced_share(), else found by solve_to_limit() of the add-on steps. Nothing without friction, and in load
  /// steps, which have PathEnd::limit
  std::optional<double> limit = {};
  /// What a user should know: the notes of the plan, then such as that other solutions exist, that forces are not determined, or that strains are large.
  std::vector<std::string> notes;
  Ledger ledger;  ///< what it cost
  Eigen::VectorXd equation_force = {};  ///< of each equation of the bonds [force]; empty without
  std::vector<NodeArray> bond_forces = {};  ///< what they do to the nodes of each body [force]
};

/// Has the back end of the model factor K, and make the compliance of the rows of A.
/// \param model   from build()
/// \param ledger  receives the phases `factor` and `condensation`
/// \return the small problem, and the factor to recover displacements with
/// \throws ProblemError if K is singular to working precision, see Backend
[[nodiscard]] Condensed condense(const Model& model, Ledger& ledger);

/// Puts other free displacements into the condensed problem; the factor and the compliance stay.
/// \param model              whose p they belong to, with its g
/// \param free_displacement  u0 = K^-1 p `n` [length]
/// \param[in,out] condensed  from condense() of a model with the same K, A and law
void move_freely(const Model& model, Eigen::VectorXd free_displacement, Condensed& condensed);

/// Solves the condensed problem and recovers displacements, all refined from the original data.
///
/// If the refined gaps show that rounding of the condensed data had misplaced a pair, the condensed
/// problem is solved again with free gaps from the refined solution.
/// \param model      from build()
/// \param condensed  from condense() of it
/// \param solver     a member of its family that takes friction where pairs have friction
/// \param ledger     goes on in the solution, with the phases `contact`, `refinement`, `recovery`
/// \param options    handed to the solver
/// \return the solution; check its `contact.report.status` first, or call require_solved()
/// \throws ProblemError for numbers beyond all units; std::invalid_argument for more pairs than it takes
[[nodiscard]] Solution solve(const Model& model, const Condensed& condensed, const Solver& solver,
                             Ledger ledger, const SolverOptions& options = {});

/// The same with `model.solver`. \param model  from build() \param condensed  from condense() of it
/// \param ledger  as above \return the solution
[[nodiscard]] Solution solve(const Model& model, const Condensed& condensed, Ledger ledger);

/// \param solution  any
/// \return why it is not solved, as far as that is known, and what to change; empty if nothing is known
[[nodiscard]] std::string why_unsolved(const Solution& solution);

/// Stops a program that has no use for an unsolved problem.
/// \param solution  what solve() returned
/// \param what      what the message calls it
/// \throws NotSolved with the status, what stopped the solver and the notes, unless it is Solved
void require_solved(const Solution& solution, const std::string& what);

}  // namespace signorini
