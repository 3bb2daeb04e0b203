// # Rigid motions that supports leave
//
// A body that only contact holds has a singular stiffness matrix. The null space is known in
// advance: a plane body can only move by
//
// \f[ u(x) = \begin{pmatrix} a - c\,(y-y_0) \\ b + c\,(x-x_0) \end{pmatrix}, \f]
//
// two translations and a rotation about its centre, which strain nothing. A held component of a
// node asks that one row of this is zero. All of them make a matrix \f$H\f$ of three columns, and
// the free motions are its null space. A block of 2 x 1 that is pinned at its lower left corner
// has two rows in \f$H\f$ and one motion left, \f$(a, b, c) = (-0.22, 0.45, 0.45)\f$: it turns
// about the corner.
//
// One could look for zero eigenvalues of \f$K\f$ instead. They cost more, and one would have to
// guess how small a zero is when soft cells stand beside stiff ones. Here only lengths are
// compared with lengths. We need the motions themselves as well: their amplitudes become unknowns,
// each with the balance of forces along it as its equation (chapter 11).

#include "signorini/fem/free_motions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/far.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// One piece of a mesh, and where it is.
///
/// A mesh may consist of pieces that touch nowhere, and each of them can fly off alone.
struct ConnectedBody {
  /// \param mesh   that has it
  /// \param piece  one of its pieces
  ConnectedBody(const Mesh& mesh, const MeshPiece& piece) : nodes(piece.nodes), cells(piece.cells) {
    const NodeArray x = mesh.nodes(nodes, Eigen::all);
    arms = arms_from_middle(x);
    centre = middle(mesh, piece);
    size = (x.colwise().maxCoeff() - x.colwise().minCoeff()).norm();
    rounding = 16 * epsilon * (1 + distance_from_origin(x) / size);
  }

  const std::vector<Index>& nodes;
  NodeArray arms;          ///< from the centre to each of the nodes
  Eigen::Vector2d centre;  ///< middle of the box of the nodes
  double size;             ///< diagonal of the bounding box
  double rounding;         ///< of a displacement by a motion that moves the body by 1
  Index cells;
};

/// What the translations x and y and a rotation about the centre, each of which moves the body by about 1, do to the
/// components that are held: `n x 3`, `n` at least 3. What moves or turns the cross-section of a body of revolution
/// sideways strains the body.
///
/// Arms are divided by the size of the body. Then the three columns are alike in size, and the
/// singular values measure how firmly a motion is held, not in which unit.
Eigen::MatrixXd held_motions(const ConnectedBody& body, const Unknowns& unknowns,
                             PlaneState state) {
  std::vector<Eigen::Vector3d> rows;
  if (state == PlaneState::Axial) rows = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()};
  for (std::size_t k = 0; k < body.nodes.size(); ++k) {
    const Index node = body.nodes[k];
    const Eigen::Vector2d arm = body.arms.row(static_cast<Index>(k)).transpose() / body.size;
    if (unknowns.number(node, 0) < 0) rows.emplace_back(1, 0, -arm.y());
    if (unknowns.number(node, 1) < 0) rows.emplace_back(0, 1, arm.x());
  }
  rows.resize(std::max<std::size_t>(3, rows.size()), Eigen::Vector3d::Zero());
  Eigen::MatrixXd held(static_cast<Index>(rows.size()), 3);
  for (Index k = 0; k < held.rows(); ++k) held.row(k) = rows[static_cast<std::size_t>(k)];
  return held;
}

/// Rigid motions (a, b, c) that move x by (a - c (y - y0), b + c (x - x0)), and no held component by more than what
/// rounding of the coordinates makes of it.
///
/// The columns of \f$V\f$ of the singular value decomposition that \f$H\f$ does not move by more
/// than rounding. A motion is scaled so that the body moves by about 1, and entries that are
/// rounding become 0: a body on rollers moves in \f$x\f$, not in \f$x\f$ with a trace of \f$y\f$,
/// which a support would resist.
std::vector<Eigen::Vector3d> motions_of(const ConnectedBody& body, const Unknowns& unknowns,
                                        PlaneState state) {
  const Eigen::MatrixXd held = held_motions(body, unknowns, state);
  const Eigen::MatrixXd modes = singular_values(held).V;
  std::vector<Eigen::Vector3d> motions;
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d motion = modes.col(k);
    if (largest(held * motion) > body.rounding) continue;
    motion = (motion.array().abs() <= body.rounding).select(0, motion);
    motion(2) /= body.size;
    motion /= std::max(motion.head<2>().norm(), std::abs(motion(2)) * body.size);
    motions.push_back(motion);
  }
  return motions;
}

/// From here on it is about messages.
///
/// One more digit than is printed.
constexpr double visible = 1e-6;

/// The larger of the displacements by its translation and by its rotation.
double displacement(const FreeMotion& free) {
  return std::max(free.motion.head<2>().norm(), std::abs(free.motion(2)) * free.size);
}

}  // namespace

/// A translation with a rotation is a rotation about another point, the one at rest: \f$u = 0\f$ at
/// \f$(x_0 - b/c,\ y_0 + a/c)\f$. That point is what a user can look at.
std::string in_words(const FreeMotion& free) {
  const Eigen::Vector3d motion = free.motion / displacement(free);
  const std::string can = free.body + " can ";
  if (std::abs(motion(2)) * free.size > visible) {
    const auto printed = [&free](double coordinate) {
      return std::abs(coordinate) > visible * free.size ? coordinate : 0.0;
    };
    return text(can, "turn freely about (", printed(free.centre.x() - motion(1) / motion(2)), ", ",
                printed(free.centre.y() + motion(0) / motion(2)), ')');
  }
  if (std::abs(motion(1)) <= visible) return can + "move freely in direction x";
  if (std::abs(motion(0)) <= visible) return can + "move freely in direction y";
  const double forward = motion(0) > 0 ? 1 : -1;
  return text(can, "move freely in direction (", forward * motion(0), ", ", forward * motion(1),
              ')');
}

/// Motions of one body are added first. A body that goes right and up goes in one direction, and a
/// message about two would be read as two bodies.
std::vector<std::string> in_words(const std::vector<FreeMotion>& motions,
                                  const Eigen::VectorXd& amplitude) {
  std::vector<FreeMotion> bodies;
  double farthest = 0;
  for (Index k = 0; k < amplitude.size(); ++k) {
    const FreeMotion& one = motions[static_cast<std::size_t>(k)];
    if (bodies.empty() || bodies.back().body != one.body || bodies.back().centre != one.centre) {
      bodies.push_back(one);
      bodies.back().motion.setZero();
    }
    bodies.back().motion += amplitude(k) * one.motion;
  }
  for (const FreeMotion& body : bodies) farthest = std::max(farthest, displacement(body));
  std::vector<std::string> words;
  for (const FreeMotion& body : bodies)
    if (displacement(body) > visible * farthest) words.push_back(in_words(body));
  return words;
}

/// For each motion the displacement of all unknowns, which the solver multiplies by the amplitude.
std::vector<FreeMotion> free_motions(const Mesh& mesh, const std::vector<MeshPiece>& pieces,
                                     const Unknowns& unknowns, PlaneState state) {
  std::vector<FreeMotion> found;
  for (const MeshPiece& piece : pieces) {
    const ConnectedBody body(mesh, piece);
    for (const Eigen::Vector3d& motion : motions_of(body, unknowns, state)) {
      FreeMotion free;
      free.body = text("body '", mesh.name, "' (", in_words(mesh, piece), ')');
      free.motion = motion;
      free.centre = body.centre;
      free.size = body.size;
      Eigen::VectorXd shape = Eigen::VectorXd::Zero(unknowns.count);
      for (std::size_t k = 0; k < body.nodes.size(); ++k) {
        const Index node = body.nodes[k];
        const Eigen::Vector2d arm = body.arms.row(static_cast<Index>(k)).transpose();
        const Eigen::Vector2d turns(-motion(2) * arm.y(), motion(2) * arm.x());
        for (int axis = 0; axis < 2; ++axis) {
          const Index unknown = unknowns.number(node, axis);
          if (unknown < 0) continue;
          const double moves = motion(axis) + turns(axis);
          // A node straight above the pivot does not move sideways, whatever rounding makes of it.
          const bool still =
              std::abs(moves) <= 64 * epsilon * (std::abs(motion(axis)) + std::abs(turns(axis)));
          shape(unknown) = still ? 0 : moves;
        }
      }
      free.shape = shape.sparseView();
      found.push_back(std::move(free));
    }
  }
  if (found.empty()) return found;
  const double directions = direction_rounding(mesh);
  for (FreeMotion& free : found) free.directions = directions;
  return found;
}

std::vector<FreeMotion> free_motions(const Mesh& mesh, const Unknowns& unknowns, PlaneState state) {
  return free_motions(mesh, pieces(mesh), unknowns, state);
}

}  // namespace signorini
