// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What holds bodies together: equations between displacements, as a scene asks for them, and springs in their place.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Two sides whose gap stays what it is: they carry tension as well as pressure. A rigid obstacle may be the target.
struct Tie {
  ContactSpec sides;    ///< source, target and operator: a tie refuses friction, interference and adjusted gaps
  bool slides = false;  ///< whether the source may slide along the target, without friction
  /// Whether gaps and overlaps of the meshes are closed, which strains the bodies. Without it the sides stay as far apart as the
  /// meshes have them, such as straight edges of two meshes along one curve; bodies with a law of finite strain refuse that.
  bool closes = false;
  /// Springs all along the sides in the place of the tie, at rest as the meshes are: along the normal, and along the tangent,
  /// not negative [force/length^3]
  std::optional<Eigen::Vector2d> stiffness = {};
};

/// A part of a linear relation: how far nodes move in a direction.
struct RelationTerm {
  Side side;                                    ///< all nodes of it
  std::optional<Eigen::Vector2d> only_at = {};  ///< or the one there [length]
  Eigen::Vector2d along = {1, 0};               ///< the displacement is multiplied by this [-]
  double times = 1;                             ///< and by this [-]
};

/// What a relation says of its sum and its number.
enum class Holds {
  Equal,    ///< the sum is the number: an equation
  AtMost,   ///< the sum may reach the number and not pass it, as a contact does: a pair, whose gap is what is left
  AtLeast,  ///< the same from above
};

/// A relation is one equation, or one pair. If a term is of a whole side, there is one for each of its nodes; the nodes of all whole
/// sides are matched in order, and a shift must take one side to the other. A term of one node stands in every one of them.
struct Relation {
  std::vector<RelationTerm> terms;        ///< one or more
  double right = 0;                       ///< their sum where its history is 1, or the bound of it [length]
  /// A spring in the place of the equation, > 0 [force/length]; none in that of a pair
  std::optional<double> stiffness = {};
  Holds holds = Holds::Equal;             ///< whether the sum is `right` or is bounded by it
  std::string history = {};               ///< that the number of an equation follows; empty: it is always there
};

/// Histories of load steps that the numbers of a rigid side follow: `x` is that of its shift x. A number without a history is always
/// there; one with a history is what it is where the history is 1.
struct RigidHistories {
  std::string x = {};       ///< of RigidSide::x
  std::string y = {};       ///< of RigidSide::y
  std::string turn = {};    ///< of RigidSide::turn
  std::string force = {};   ///< of RigidSide::force
  std::string moment = {};  ///< of RigidSide::moment
};

/// A side that moves as a rigid body: a shift and a turn, each prescribed, or driven by forces, or neither. In axial symmetry it
/// moves along the axis alone, keeps its radii, and the force is that all round.
struct RigidSide {
  Side side;                                          ///< all its nodes
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();   ///< point that x and y are of, and force acts on [length]
  std::optional<double> x = {};                       ///< shift of the centre [length]
  std::optional<double> y = {};                       ///< shift of the centre [length]
  std::optional<double> turn = {};                    ///< anticlockwise [rad], small
  Eigen::Vector2d force = Eigen::Vector2d::Zero();    ///< on the centre [force]
  double moment = 0;                                  ///< anticlockwise [force length]
  RigidHistories histories = {};                      ///< none by default
};

/// All of a scene, see Scene::bonds.
struct Bonds {
  std::vector<Tie> ties = {};  ///< none by default
  /// Numbers of contacts of the scene whose pairs never lift off; none by default. Pairs in tension have forces and
  /// pressures < 0, and rub as pairs in compression do.
  std::vector<std::size_t> two_sided = {};
  std::vector<Relation> relations = {};  ///< none by default
  std::vector<RigidSide> rigid = {};     ///< none by default
};

}  // namespace signorini
