/// \file
/// What a user wants solved, and the road from there to a solution.
#pragma once
#include <Eigen/Core>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "signorini/complementarity/certificate.hpp"
#include "signorini/complementarity/floating.hpp"
#include "signorini/complementarity/friction.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/core/ledger.hpp"
#include "signorini/elasticity/assembly.hpp"
#include "signorini/elasticity/contact_last_factor.hpp"
#include "signorini/elasticity/elements.hpp"
#include "signorini/elasticity/free_motions.hpp"

namespace signorini {

/// An elastic body, what holds it and what loads it. The name of its mesh is the name of the body.
struct Body {
  Mesh mesh;                                ///< has a name that no other body has
  std::string element = "q4_incompatible";  ///< name in elements(); fits the cells
  Material material;                        ///< of all cells
  std::vector<Support> supports;            ///< may leave rigid motions if contact stops them
  Loads loads;                              ///< none by default
};

/// A boundary of a body.
struct Side {
  std::string boundary;   ///< its name
  std::string body = {};  ///< name of the body; may be left out if there is only one
};

/// Coulomb friction with cohesion between two sides, for one load step.
struct Friction {
  double coefficient = 0;  ///< mu >= 0 [-]
  double cohesion = 0;     ///< c >= 0 where the sides touch [force/length^2]
};

/// Two sides that may touch. What only meshes need is not looked at for a rigid obstacle.
struct ContactSpec {
  Side source;                          ///< the slave; its nodes or points carry the forces
  std::variant<Obstacle, Side> target;  ///< the master
  std::string gap_operator = "mortar";  ///< name in gap_operators()
  Quadrature quadrature = Quadrature::Segments;  ///< where the operator integrates
  int points = 0;                                ///< Gauss points; 0: as many as the operator wants
  std::optional<Friction> friction = {};         ///< none by default
};

/// Elastic bodies and what they may touch. Every effect is an optional entry; one that is absent costs
/// nothing.
struct Scene {
  std::vector<Body> bodies = {{}};                ///< one or more
  std::vector<ContactSpec> contacts;              ///< none by default
  std::string solver = "primal_dual_active_set";  ///< name in solvers()
  /// Name in friction_solvers(), which take over if any contact has friction.
  std::string friction_solver = "friction_active_set";
};

/// The friction law pair by pair; 0 where a contact has none.
struct PairFriction {
  Eigen::VectorXd coefficient;  ///< mu `n_c` [-]
  Eigen::VectorXd cohesion;     ///< c times the weight `n_c` [force]
};

/// What a scene calls for, found without assembling anything.
struct Plan {
  std::vector<std::string> on;       ///< effects that are on, one line each
  std::vector<std::string> off;      ///< effects that are off
  std::vector<std::string> notes;    ///< what a user should know, such as an element that will lock
  std::vector<MeshQuality> quality;  ///< of the worst cells, per body
  std::vector<Unknowns> unknowns;    ///< per body, numbered from 0 in each
  std::vector<FreeMotion> modes;     ///< `n_r` rigid motions that only contact can stop
  Gaps gaps;                         ///< `n_c` candidate pairs of all contacts, none without
  std::optional<PairFriction> friction;  ///< of all pairs if any contact has friction
};

/// A body ready to be assembled, and where it stands among the others.
struct BodyModel {
  Mesh mesh;                   ///< of the scene
  Element element;             ///< found by its name
  Material material;           ///< of the scene
  Unknowns unknowns;           ///< of this body, numbered from 0
  Eigen::Index first_node;     ///< number of its first node among those of all bodies
  Eigen::Index first_unknown;  ///< number of its first unknown
};

/// Matrices of the bodies and the gaps they may close.
struct Model {
  std::vector<BodyModel> bodies;  ///< as in the scene
  Unknowns unknowns;              ///< `n` of all bodies, one after another
  /// K, p, A, g: what the certificate refers to. With friction `n_c` rows of slips, -T and the initial
  /// slips, follow those of the gaps.
  QuadraticProgramme programme;
  Pairs pairs;  ///< `n_c` that can close, with given displacements in `initial_gap`
  std::vector<FreeMotion> modes;         ///< `n_r` null vectors of K
  std::optional<PairFriction> friction;  ///< of all pairs, or none
};

/// The model with all unknowns but the contact forces eliminated.
struct Condensed {
  ContactLastFactor factor;           ///< of K, or of K and one spring per rigid mode
  ContactProblem problem;             ///< G = A K^-1 A^T and d = g - A u0
  Eigen::VectorXd free_displacement;  ///< u0 = K^-1 p `n` [length]
  Eigen::MatrixXd rigid;      ///< R `n_c x n_r` what an amplitude opens, see FloatingProblem
  Eigen::VectorXd resultant;  ///< r `n_r` what contact forces must add up to [force]
};

/// What friction did.
struct FrictionOutcome {
  FrictionState state;  ///< forces, friction forces, gaps and slips, from the displacements
  /// Of `state`, from the original K, p, A and T: its equilibrium is also that of every node.
  FrictionCertificate certificate;
};

/// Everything that is known at the end. Unless `contact.report.status` is Solved, it has the state,
/// the report and the ledger only, and its certificate says nothing.
struct Solution {
  std::vector<NodeArray> displacements;  ///< `n_nodes x 2` of each body [length]
  ContactState contact;                  ///< refined forces, gaps and status per pair
  Eigen::VectorXd amplitude;             ///< `n_r` of the rigid modes [length]
  Eigen::VectorXd pressure;              ///< `n_c` force / weight [force/length^2], compression > 0
  PrimalDual refined;                    ///< unknowns in two parts, and forces: what is certified
  std::optional<FrictionOutcome> friction;  ///< only if the scene has friction
  Certificate certificate = uncertified();  ///< of `refined`, from the original K, p, A, g
  std::string escape;                       ///< if the load pulls a body away: how it moves off
  Ledger ledger;                            ///< what it cost
};

/// Reads a scene and says what will be computed. \param scene  to be solved
/// \return what is on and off, and how large it is
/// \throws ProblemError for unknown names, bad cells, an element that does not fit them, bad
///   constants, supports that contradict each other, boundaries that cannot be paired, or a rigid motion
///   that nothing can stop; build() finds the rest
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
/// \param solver     name in solvers(), or with friction in friction_solvers()
/// \param ledger     goes on in the solution, with the phases `contact`, `refinement`, `recovery`
/// \return the solution; check its `contact.report.status` first, or call require_solved()
/// \throws ProblemError for an unknown name; std::invalid_argument for more pairs than it accepts
[[nodiscard]] Solution solve(const Model& model, const Condensed& condensed,
                             const std::string& solver, Ledger ledger);

/// The solver that a scene asks for.
/// \param scene  to be solved
/// \param model  from build() of it
/// \return `scene.friction_solver` if the model has friction, else `scene.solver`
[[nodiscard]] const std::string& solver_name(const Scene& scene, const Model& model);

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
