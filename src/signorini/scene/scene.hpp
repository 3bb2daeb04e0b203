/// \file
/// What a user wants solved, and the stages from there to a solution.
#pragma once
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "signorini/contact/friction_laws.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/free_motions.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// A part of a body that is of another material.
struct Layer {
  std::string region;  ///< name in Mesh::regions
  Material material;   ///< of the cells of that region
};

/// How much warmer a body is than where it is free of stress:
/// \f$ \Delta T(x) = \Delta T_0 + \nabla T \cdot x \f$.
struct Temperature {
  double uniform = 0;                                  ///< at the origin [temperature]
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  ///< [temperature/length]
  std::string history = {};  ///< name of what it grows with, see Path; empty: it is always there
  ScalarField varying = {};  ///< what comes on top of it [temperature]; none if empty

  /// \param x  a place [length] \return how much warmer it is there [temperature]
  [[nodiscard]] double at(const Eigen::Vector2d& x) const {
    return uniform + gradient.dot(x) + (varying ? varying(x) : 0);
  }
  /// \return whether it is not zero everywhere
  [[nodiscard]] bool nonzero() const { return varying || uniform != 0 || !gradient.isZero(0); }
};

/// Springs between a body and the ground, at rest where nothing moves.
struct Spring {
  std::string boundary;                                 ///< all along it
  Eigen::Vector2d stiffness = Eigen::Vector2d::Zero();  ///< in x and y, >= 0 [force/length^3]
  /// One node of the boundary [length]; the stiffness is then in [force/length].
  std::optional<Eigen::Vector2d> only_at = {};
};

/// An elastic body, what holds it and what loads it. The name of its mesh is the name of the body.
struct Body {
  Mesh mesh;                                    ///< has a name that no other body has
  std::string element;                          ///< name in elements(); empty: see element_for()
  Material material;                            ///< of all cells that are in no layer
  std::vector<Layer> layers;                    ///< none by default
  std::vector<Support> supports;                ///< may leave rigid motions if contact stops them
  std::vector<Spring> springs;                  ///< none by default
  Loads loads;                                  ///< none by default
  std::optional<Temperature> temperature = {};  ///< none by default
};

/// A boundary of a body.
struct Side {
  std::string boundary;   ///< its name
  std::string body = {};  ///< name of the body; may be left out if there is only one
};

/// Two sides that may touch. A choice that has no meaning, as an operator beside a rigid obstacle, is noted.
struct ContactSpec {
  Side source;                          ///< the slave; its nodes or points carry the forces
  std::variant<Obstacle, Side> target;  ///< the master
  std::string gap_operator = "mortar";  ///< name in gap_operators()
  Quadrature quadrature = Quadrature::Segments;  ///< where the operator integrates
  int points = 0;                                ///< Gauss points; 0: as many as the operator wants
  std::optional<Friction> friction = {};         ///< none by default
  /// Everywhere on the source, the sides overlap by so much more than the meshes say [length]: a press fit.
  std::optional<double> interference = {};
  ScalarField interference_share = {};  ///< how much of it there is at a place [-]; empty: all
  /// Name of what the interference grows with, see Path; empty: it is always there.
  std::string interference_history = {};
  /// Gaps and overlaps of the meshes up to this are none [length]: nodes are moved there without strain.
  std::optional<double> adjust = {};
  /// Whether every pair may stay on the place that it faces at first, however far it slides. Without that, a solution in
  /// which pairs slide past their sides is none, see sliding.hpp.
  bool small_sliding = false;
};

struct Bonds;

/// Elastic bodies and what they may touch. Every effect is an optional entry, see effects.hpp; one that is
/// absent costs nothing.
struct Scene {
  std::vector<Body> bodies = {{}};           ///< one or more
  std::vector<ContactSpec> contacts;         ///< none by default
  Solver solver = primal_dual_active_set();  ///< a member of the family, see find_solver()
  std::optional<Path> path = {};             ///< load steps, for solve_steps(); none by default
  Backend backend = default_backend();       ///< factors K, see backends()
  /// Whether pairs are those of bodies where they have moved to, as far as they slide: an effect of the add-on motion, in
  /// load steps. Without it they are those of the meshes.
  bool moves = false;
  /// Equations between displacements, of the add-on equations; none by default.
  std::shared_ptr<const Bonds> bonds = {};
};

/// Reads a scene and says what will be computed. \param scene  to be solved
/// \return what is on and off, and how large it is
/// \throws ProblemError for unknown names, bad cells, an element that does not fit them, bad
///   constants, supports that contradict each other, boundaries that cannot be paired, a rigid motion
///   that nothing can stop, or a solver that does not take so many pairs; assemble() finds the rest
[[nodiscard]] Plan plan(const Scene& scene);

/// Assembles what was planned, without another look at the scene. \param plan  from plan()
/// \param ledger  receives the phase `assembly`
/// \return matrices and gaps
/// \throws ProblemError as assemble()
[[nodiscard]] Model build(Plan plan, Ledger& ledger);

/// Plans and assembles. \param scene  any
/// \param ledger  receives the phases `plan` and `assembly`
/// \return matrices and gaps
/// \throws ProblemError as plan() and assemble()
[[nodiscard]] Model build(const Scene& scene, Ledger& ledger);

/// All of it: plan, build, condense, solve; \PaperEq{XuanLi2002, 9}, on a mesh \PaperEq{XuanLi2002, 11}. \param scene  to be solved
/// \return the solution; its status and the errors are those of the four steps
/// \throws ProblemError for a scene of load steps: that is for solve_steps() of the add-on steps, as solve_to_limit() is for a
///   scene with friction whose loads may be more than that holds
[[nodiscard]] Solution solve(const Scene& scene);

/// Prints what is on and off, one line each, and notes. \param out where to \param plan what
/// \param notes  in the place of those of the plan
void print(std::ostream& out, const Plan& plan, const std::vector<std::string>& notes);

/// Prints a plan, one line per effect or note. \param out where to \param plan what \return `out`
std::ostream& operator<<(std::ostream& out, const Plan& plan);

}  // namespace signorini
