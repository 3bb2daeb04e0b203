/// \file
/// The model of a scene, the condensed problem, and the solution.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "signorini/contact/pairs.hpp"
#include "signorini/core/ledger.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/factor.hpp"
#include "signorini/fem/free_motions.hpp"
#include "signorini/fem/joints.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/shared_forces.hpp"
#include "signorini/scene/path.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {

/// A body ready to be assembled, and where it stands among the others.
struct BodyModel {
  Mesh mesh;                   ///< of the scene
  Element element;             ///< found by its name
  MaterialField material;      ///< of its cells
  Loads loads;                 ///< of the scene
  Unknowns unknowns;           ///< of this body, numbered from 0
  Eigen::Index first_node;     ///< number of its first node among those of all bodies
  Eigen::Index first_unknown;  ///< number of its first unknown
  /// spring_stiffness() of its springs; no rows without any
  Eigen::SparseMatrix<double> springs = {};
  std::vector<MeshPiece> pieces = {};  ///< of the mesh
};

/// Which bodies a contact is between, by their numbers.
struct ContactBodies {
  std::size_t source;                 ///< of the source
  std::optional<std::size_t> target;  ///< of the target; a rigid obstacle has none
};
struct Model;
struct MovedPairs;

/// Finds the pairs of a model again where its bodies have moved to, see follow.hpp. \param model  with its bodies
/// \param displacement  `n_nodes x 2` of all nodes [length] \return the pairs there
using FollowPairs = std::function<MovedPairs(const Model& model, const NodeArray& displacement)>;

/// Matrices of the bodies and the gaps they may close.
struct Model {
  std::vector<BodyModel> bodies;             ///< as in the scene
  Unknowns unknowns;                         ///< `n` of all bodies, one after another
  QuadraticProgramme programme;              ///< K, p, A, g of the gaps, then of the slips of `law`
  Pairs pairs;                               ///< `n_c` that can close; see Gaps
  std::vector<FreeMotion> modes;             ///< `n_r` null vectors of K
  FrictionLaw law;                           ///< of the frictional pairs, empty if none does
  Solver solver = primal_dual_active_set();  ///< of the scene
  std::vector<std::string> notes;            ///< of the plan
  Path path = {};                            ///< load steps, none without
  std::vector<LoadPart> parts = {};          ///< p and g are the sum of these times their histories
  Backend backend = default_backend();       ///< of the scene, factors K
  std::vector<std::string> contacts = {};    ///< names of the contacts, see contact_names()
  std::vector<std::size_t> contact_of = {};  ///< `n_c` number of the contact of each pair
  std::vector<ContactBodies> contact_bodies = {};  ///< of each contact
  FollowPairs follow = {};               ///< null without contact, or if all gaps are linear
  std::vector<bool> small_sliding = {};  ///< of each contact, see ContactSpec
};

/// The model with all unknowns but the contact forces eliminated.
struct Condensed {
  Factor factor;                      ///< of K, or of K and one spring per rigid mode
  ContactProblem problem;             ///< F = A K^-1 A^T, d, s, the law, R and r
  Eigen::VectorXd free_displacement;  ///< u0 = K^-1 p `n` [length]
};

/// Everything that is known at the end. Unless `contact.report.status` is Solved it is no solution: it then has
/// the best set of pairs that could be refined, with its certificate, or, if none could, the report, what was
/// proved and the ledger only.
struct Solution {
  std::vector<NodeArray> displacements;  ///< `n_nodes x 2` of each body [length]
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
