/// \file
/// The family of gap operators between two meshes. To add one: write a `.cpp` with a function
/// `gap_operator::NAME` that returns it, and put NAME into the table in pairing/gap_operators.cpp; the conformance suite
/// finds it. A program that is linked with signorini::pairing has its members, others have none.
///
/// An operator is one function. It gets two boundaries and fills Pairs; flags tell which options it
/// reads. Whatever comes later (supports, friction, solvers, forces on nodes) reads Pairs and does
/// not ask which operator made them.
#pragma once
#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "signorini/contact/pairs.hpp"
#include "signorini/fem/material.hpp"

namespace signorini {

/// Where an operator samples the source.
enum class Quadrature {
  Segments,    ///< edges are cut where the target has a node: what is integrated is smooth
  SourceEdges  ///< every source edge as it is
};

/// What is asked of a gap operator.
struct GapOptions {
  Eigen::Index n_nodes = 0;  ///< of all bodies: half the columns of the matrices
  Depth depth = {};          ///< across the plane
  bool sliding = false;      ///< whether the matrix S is wanted
  int points = 0;            ///< Gauss points per edge or segment; 0: the operator's own choice
  Quadrature quadrature = Quadrature::Segments;  ///< only if it `takes_quadrature`
  /// `n_nodes x 2` by how much the nodes of all bodies have moved to come to where the meshes have them [length]; with S, a
  /// member then says how far its points have `slid` since, along the sides that they face. Null: nothing has moved.
  const NodeArray* since = nullptr;
  /// Nodes all of whose points are farther from the target get no pair, unless all are [length]; for bodies that move, of
  /// which new pairs are found again and again
  double reach = std::numeric_limits<double>::infinity();
};

/// One member of the family.
struct GapOperator {
  const char* name;     ///< as in find_gap_operator() and in a scene
  const char* summary;  ///< one line for lists
  /// Pairs the source (slave) with the target (master).
  ///
  /// Points of the source that face no target are left out; the nodes that lose all their weight by it
  /// are listed as `unpaired`. Throws ProblemError if no point faces the target, if the two
  /// boundaries face the same way, or if they lie more than the depth of their own sides inside each other.
  Pairs (*pair)(const Surface& source, const Surface& target, const GapOptions& options);
  /// Whether a uniform pressure is transferred exactly between any two meshes of a straight interface.
  bool passes_patch_test = false;
  bool takes_points = false;      ///< whether `points` matters
  bool takes_quadrature = false;  ///< whether `quadrature` matters
};

/// The family.
/// \return all members, in the order of lists and tables
[[nodiscard]] const std::vector<GapOperator>& gap_operators();

/// Adds a member to the family, unless it has one of that name. \param member  of a folder or a program
void add_gap_operator(const GapOperator& member);

/// Looks up a member.
/// \param name  of the operator
/// \return the member
/// \throws ProblemError listing the known names if there is none
[[nodiscard]] const GapOperator& find_gap_operator(const std::string& name);

}  // namespace signorini
