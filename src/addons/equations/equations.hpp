// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Equations between displacement components, solved for one unknown each.
#pragma once
#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "addons/equations/eliminate.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {

struct ContactSpec;
struct Relation;
struct RigidSide;
struct Scene;
struct Tie;

/// The row of a pair in one that is a combination of such rows.
struct RowPart {
  Eigen::Index pair;  ///< of the bond
  double opening;     ///< how much of the row of its gap
  double sliding;     ///< and of that of its slip
};

/// A row that holds with =: the sum of coefficients times displacement components is `right`. With `stiffness` it does not hold
/// exactly: a spring pulls with stiffness times what is missing.
struct Equation {
  /// Component of a node, 2 * node + axis with the nodes of all bodies one after another, and its coefficient [-].
  std::vector<std::pair<Eigen::Index, double>> terms = {};
  double right = 0;        ///< where its history is 1 [length]
  std::string history = {};  ///< that `right` follows; empty: it is always there
  double rounding = 0;     ///< of `right` [length]
  Eigen::Index own = -1;   ///< component to solve it for; -1: any
  std::vector<RowPart> parts = {};  ///< of the pairs of its bond; none if that has no pairs
  std::optional<double> stiffness = {};  ///< of a spring in its place [force/length]
};

/// \param rows  `m` \param components  of all nodes \return C `m x components` of their terms
[[nodiscard]] NodalRows matrix_of(const std::vector<Equation>& rows, Eigen::Index components);

/// A force on a component of a node.
struct BondLoad {
  Eigen::Index component;  ///< 2 * node + axis
  double force;            ///< where its history is 1 [force]
  std::string history;     ///< that it follows; empty: it is always there
};

/// Equations of one origin.
struct Bond {
  std::string name;        ///< as tables have it, such as "upper.bottom to lower.top"
  std::string what;        ///< as messages have it
  Pairs pairs = {};        ///< of a tie
  double apart = 0;        ///< how far its sides are and stay from each other [length]
  std::shared_ptr<const ContactSpec> sides = {};  ///< of a tie
  std::vector<Eigen::Index> nodes = {};  ///< without pairs: those whose forces are told, among all nodes
  std::size_t first = 0;   ///< of its equations
  std::size_t end = 0;     ///< the one after its last
  std::vector<Equation> left_out = {};  ///< of a tie: supports hold its node, and part of what this faces
  std::vector<BondLoad> loads = {};  ///< what drives a rigid side
};

/// The equations of a plan.
struct Equations {
  std::vector<Bond> bonds = {};     ///< in the order of the scene
  std::vector<Equation> rows = {};  ///< `m` of all bonds
  NodalRows matrix = {};            ///< C `m x 2 n_nodes` of the terms
  std::vector<Eigen::Index> held = {};  ///< numbers of the rows that hold, those that are no springs
  Eliminated solved = {};           ///< for unknowns
  Eigen::SparseMatrix<double> bodies = {};  ///< K of the bodies alone, if they move
};

/// What a bond carries in sum.
struct BondForces {
  std::string name;                                 ///< of the bond
  bool has_sides = false;                           ///< whether it is a tie, which has pressures
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< on the source, or on the nodes of the bond [force]
  double moment = 0;                                ///< of it about the origin [force length]
  double least_pressure = 0;    ///< of a pair [force/length^2], tension < 0
  double largest_pressure = 0;  ///< of a pair [force/length^2], compression > 0
  double largest_shear = 0;     ///< magnitude, of a pair [force/length^2]
};

/// \param model     that was solved, with equations
/// \param solution  of it, Solved
/// \return the sums of each bond
[[nodiscard]] std::vector<BondForces> bond_forces(const Model& model, const Solution& solution);

/// Writes the equations of a tie. \param tie  of the scene \param draft  knows bodies and supports
/// \param all  gets a bond and its rows
/// \throws ProblemError for sides that cannot be paired, or an operator whose pairs are no nodes
void add_tie(const Tie& tie, Plan& draft, Equations& all);

/// Writes the equations of a relation, or its pairs. \param relation  of the scene \param number  of it, from 1
/// \param draft  knows bodies \param all  gets a bond and its rows
/// \throws ProblemError for terms that say nothing, or nodes that do not match
void add_relation(const Relation& relation, std::size_t number, Plan& draft, Equations& all);

/// Writes the pairs of a relation that is no equation, behind those of all contacts and as those of one more. A pair has a gap of
/// what is left to the number, as a displacement of the first term, and its force acts on all terms: it is told as that on the first one.
/// \param relation  of the scene \param name  of it \param rows  one for each pair \param nodes  of the first term, one or one for each row
/// \param draft     gets pairs and their contact
void add_one_sided(const Relation& relation, const std::string& name, const std::vector<Equation>& rows,
                   const std::vector<Eigen::Index>& nodes, Plan& draft);

/// Writes the equations of a rigid side. \param rigid  of the scene \param draft  knows bodies \param all  gets a bond and its rows
/// \throws ProblemError for numbers that are not finite, and in axial symmetry for what is not along the axis
void add_rigid(const RigidSide& rigid, Plan& draft, Equations& all);

/// What histories are at a time, by their names.
using Factors = std::function<double(const std::string& history)>;

/// \param histories  of a path, which must outlive what is returned \param time  any [time] \return what they are then
[[nodiscard]] Factors factors_at(const std::vector<History>& histories, double time);

/// \param all  equations \param held  given displacements of all nodes `n_nodes x 2` [length] \param factors  of histories
/// \return `m` what the equations say of the unknowns then [length]
[[nodiscard]] Eigen::VectorXd right_sides(const Equations& all, const NodeArray& held, const Factors& factors);

/// The same as each_given() of supports alone. \param scene  any \param draft  its plan so far \param all  equations
/// \param visit  gets given displacements, right_sides() then, and the time of the step, if there is one
void each_given(const Scene& scene, const Plan& draft, const Equations& all,
                const std::function<void(const NodeArray& held, const Eigen::VectorXd& right,
                                         std::optional<double> time)>& visit);

/// Leaves out pairs that equations let neither open nor close: the forces of the equations are all that can be told there.
/// And slips that they say are none.
/// \param scene  for messages \param all  with `solved`
/// \param draft  its gaps and law are cut, and `two_sided` is counted anew
/// \throws ProblemError if such a pair overlaps, or is to stay closed and is open
void leave_out_given_pairs(const Scene& scene, Equations& all, Plan& draft);

/// Motions that equations leave of those that supports leave.
/// \param modes   `n_r` rigid motions \param free  C on the unknowns `m x n` \param solved  the same
/// \return independent combinations, whose eliminated unknowns are exactly what the others say
[[nodiscard]] std::vector<FreeMotion> motions_left(std::vector<FreeMotion> modes,
                                                   const NodalRows& free,
                                                   const Eliminated& solved);

/// Solves a model whose pairs may not all lift off, by solutions of models in which each of them presses from one of two sides.
/// \param way        of one solution
/// \param model      from build(), with equations
/// \param condensed  from condense() of it
/// \param solver     a member of its family that takes friction where pairs have friction
/// \param ledger     goes on in the solution
/// \param options    handed to the solver
/// \return the solution; one without pairs that never lift off is that of the way
[[nodiscard]] Solution solve_two_sided(SolveCondensed way, const Model& model,
                                       const Condensed& condensed, const Solver& solver,
                                       Ledger ledger, const SolverOptions& options);

/// Measures what is left of the equations of a solution, and finds their forces.
/// \param model  that was solved \param condensed  from condense() of it
/// \param solution  Solved; gets `equation_force` and `bond_forces`, and is withdrawn if its certificate no longer holds
void check_bonds(const Model& model, const Condensed& condensed, Solution& solution);

}  // namespace signorini
