/// \file
/// What a user wants solved, and the road from there to a solution.
#pragma once
#include <Eigen/Core>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "signorini/complementarity/certificate.hpp"
#include "signorini/contact/node_to_obstacle.hpp"
#include "signorini/core/ledger.hpp"
#include "signorini/elasticity/assembly.hpp"
#include "signorini/elasticity/contact_last_factor.hpp"
#include "signorini/elasticity/elements.hpp"

namespace signorini {

/// A boundary that may come to rest on a rigid obstacle.
struct ObstacleContactSpec {
  std::string boundary;  ///< of the body, the source (slave)
  Obstacle obstacle;     ///< the target (master)
};

/// An elastic body, what holds it, what loads it and what it may touch. Every effect is an optional
/// entry; one that is absent costs nothing.
struct Scene {
  Mesh mesh;                                      ///< the body
  std::string element = "q4_incompatible";        ///< name in elements(); fits the cells
  Material material;                              ///< of all cells
  std::vector<Support> supports;                  ///< leave no rigid motion
  Loads loads;                                    ///< none by default
  std::optional<ObstacleContactSpec> contact;     ///< none by default
  std::string solver = "primal_dual_active_set";  ///< name in solvers()
};

/// What a scene calls for, found without assembling anything.
struct Plan {
  std::vector<std::string> on;     ///< effects that are on, one line each
  std::vector<std::string> off;    ///< effects that are off
  std::vector<std::string> notes;  ///< what a user should know, such as an element that will lock
  MeshQuality quality{};           ///< of the worst cells
  Unknowns unknowns;               ///< `n`, numbered
  Gaps gaps;                       ///< `n_c` candidate pairs, none without contact
};

/// Matrices of the body and the gaps it may close.
struct Model {
  Mesh mesh;                     ///< of the scene
  Element element;               ///< found by its name
  Material material;             ///< of the scene
  Unknowns unknowns;             ///< `n`, numbered
  QuadraticProgramme programme;  ///< K, p, A, g: what the certificate refers to
  Gaps gaps;                     ///< `n_c` pairs, none without contact
};

/// The model with all unknowns but the contact forces eliminated.
struct Condensed {
  ContactLastFactor factor;           ///< of K
  ContactProblem problem;             ///< G = A K^-1 A^T and d = g - A u0
  Eigen::VectorXd free_displacement;  ///< u0 = K^-1 p `n` [length]
};

/// Everything that is known at the end. Unless `contact.report.status` is Solved, it has the state,
/// the report and the ledger only, and its certificate says nothing.
struct Solution {
  NodeArray displacements;   ///< `n_nodes x 2` [length]
  ContactState contact;      ///< refined forces, gaps and status per pair
  Eigen::VectorXd pressure;  ///< `n_c` force / weight [force/length^2], compression > 0
  PrimalDual refined;        ///< unknowns in two parts, and forces: what the certificate is about
  Certificate certificate = uncertified();   ///< of `refined`, from the original K, p, A, g
  Ledger ledger;             ///< what it cost
};

/// Reads a scene and says what will be computed. \param scene  to be solved
/// \return what is on and off, and how large it is
/// \throws ProblemError for unknown names, bad cells, an element that does not fit them, bad
///   constants, supports that contradict each other or leave a body free; build() finds the rest
[[nodiscard]] Plan plan(const Scene& scene);

/// Assembles. \param scene  that plan() accepts; mesh and free motions are not checked again
/// \param ledger  receives the phase `assembly`
/// \return matrices and gaps
/// \throws ProblemError as number_unknowns(), assemble() and node_to_obstacle()
[[nodiscard]] Model build(const Scene& scene, Ledger& ledger);

/// Factors K with the contact unknowns last and reads the compliance off the trailing block.
/// \param model   from build()
/// \param ledger  receives the phases `factor` and `condensation`
/// \return the small problem, and the factor to recover displacements with
/// \throws ProblemError if K is singular to working precision, see ContactLastFactor
[[nodiscard]] Condensed condense(const Model& model, Ledger& ledger);

/// Solves the condensed problem and recovers displacements, all refined from the original data.
///
/// If the refined gaps show that rounding of the condensed data had misplaced a pair, the condensed
/// problem is solved again with free gaps from the refined solution.
/// \param model      from build()
/// \param condensed  from condense() of it
/// \param solver     name in solvers()
/// \param ledger     goes on in the solution, with the phases `contact`, `refinement`, `recovery`
/// \return the solution; check its `contact.report.status` first, or call require_solved()
/// \throws ProblemError for an unknown name; std::invalid_argument for more pairs than it accepts
[[nodiscard]] Solution solve(const Model& model, const Condensed& condensed,
                             const std::string& solver, Ledger ledger);

/// Stops a program that has no use for an unsolved problem.
/// \param solution  what solve() returned
/// \param what      what the message calls it
/// \throws NotSolved with the status, unless it is Solved
void require_solved(const Solution& solution, const std::string& what);

/// All of it: plan, build, condense, solve. \param scene  to be solved
/// \return the solution; its status and the errors are those of the four steps
[[nodiscard]] Solution solve(const Scene& scene);

/// Prints a plan, one line per effect or note. \param out where to \param plan what \return `out`
std::ostream& operator<<(std::ostream& out, const Plan& plan);

}  // namespace signorini
