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
  std::string boundary;
  Obstacle obstacle;
};

/// An elastic body, what holds it, what loads it and what it may touch.
///
/// Every effect is an optional entry; one that is absent costs nothing.
struct Scene {
  Mesh mesh;
  std::string element = "q4_incompatible";
  Material material;
  std::vector<Support> supports;
  Loads loads;
  std::optional<ObstacleContactSpec> contact;
  std::string solver = "primal_dual_active_set";
};

/// What a scene calls for, found without assembling anything.
struct Plan {
  std::vector<std::string> on;     ///< effects that are on, one line each
  std::vector<std::string> off;    ///< effects that are off
  std::vector<std::string> notes;  ///< what a user should know, such as an element that will lock
  MeshQuality quality{};
  Eigen::Index n_unknowns = 0;
  Eigen::Index n_pairs = 0;
};

/// Matrices of the body and the gaps it may close.
struct Model {
  Mesh mesh;
  Element element;
  Material material;
  Unknowns unknowns;
  QuadraticProgramme programme;
  Gaps gaps;
};

/// The model with all unknowns but the contact forces eliminated.
struct Condensed {
  ContactLastFactor factor;
  ContactProblem problem;
  Eigen::VectorXd free_displacement;  ///< u0 = K^-1 p `n` [length]
};

/// Everything that is known at the end.
struct Solution {
  NodeArray displacements;   ///< `n_nodes x 2` [length]
  ContactState contact;      ///< refined forces, gaps and status per pair
  Eigen::VectorXd pressure;  ///< `n_c` force / weight [force/length^2]
  PrimalDual refined;        ///< unknowns in two parts, and forces: what the certificate is about
  Certificate certificate;   ///< of `refined`, from the original K, p, A, g
  Ledger ledger;
};

/// Reads a scene and says what will be computed.
/// \throws ProblemError for everything that is wrong with it: unknown names, bad cells, bad constants,
///   a body that can move freely
[[nodiscard]] Plan plan(const Scene& scene);

/// Assembles. \throws ProblemError as plan()
[[nodiscard]] Model build(const Scene& scene, Ledger& ledger);

/// Factors K with the contact unknowns last and reads the compliance off the trailing block.
[[nodiscard]] Condensed condense(const Model& model, Ledger& ledger);

/// Solves the condensed problem and recovers displacements, all refined from the original data.
///
/// If the refined gaps show that rounding of the condensed data had misplaced a pair, the condensed
/// problem is solved again with free gaps taken from the refined solution.
/// \return the solution; check `contact.report.status` before using it
[[nodiscard]] Solution solve(const Model& model, const Condensed& condensed,
                             const std::string& solver, Ledger ledger);

/// Stops a program that has no use for an unsolved problem.
/// \param solution  what solve() returned
/// \param what      what the message calls it
/// \throws NotSolved with the status, unless it is Solved
void require_solved(const Solution& solution, const std::string& what);

/// All of it: plan, build, condense, solve.
[[nodiscard]] Solution solve(const Scene& scene);

/// Prints a plan.
std::ostream& operator<<(std::ostream& out, const Plan& plan);

}  // namespace signorini
