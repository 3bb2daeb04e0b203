#include "signorini/elasticity/free_motions.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// One piece of a mesh, and where it is.
struct ConnectedBody {
  /// \param mesh   that has it
  /// \param piece  one of its pieces
  ConnectedBody(const Mesh& mesh, const MeshPiece& piece) : nodes(piece.nodes), cells(piece.cells) {
    const NodeArray x = mesh.nodes(nodes, Eigen::all);
    arms = arms_from_middle(x);
    centre = middle(mesh, piece);
    size = (x.colwise().maxCoeff() - x.colwise().minCoeff()).norm();
  }

  const std::vector<Index>& nodes;
  NodeArray arms;          ///< from the centre to each of the nodes
  Eigen::Vector2d centre;  ///< middle of the box of the nodes
  double size;             ///< diagonal of the bounding box
  Index cells;
};

/// Rigid motions (a, b, c) that move x by (a - c (y - y0), b + c (x - x0)) and no held component. What moves or turns
/// the cross-section of a body of revolution sideways strains the body.
std::vector<Eigen::Vector3d> motions_of(const ConnectedBody& body, const Unknowns& unknowns,
                                        PlaneState state) {
  Eigen::Matrix3d forbidden = Eigen::Matrix3d::Zero();
  if (state == PlaneState::Axial) forbidden.diagonal() << 1, 0, 1;
  for (std::size_t k = 0; k < body.nodes.size(); ++k) {
    const Index node = body.nodes[k];
    const Eigen::Vector2d arm = body.arms.row(static_cast<Index>(k)).transpose() / body.size;
    const Eigen::Vector3d in_x(1, 0, -arm.y());
    const Eigen::Vector3d in_y(0, 1, arm.x());
    if (unknowns.number(node, 0) < 0) forbidden += in_x * in_x.transpose();
    if (unknowns.number(node, 1) < 0) forbidden += in_y * in_y.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(forbidden);
  const double none = 16 * epsilon * std::max(1.0, forbidden.trace());
  std::vector<Eigen::Vector3d> motions;
  for (int k = 0; k < 3; ++k) {
    if (modes.eigenvalues()(k) > none) continue;
    Eigen::Vector3d motion = modes.eigenvectors().col(k);
    motion = (motion.array().abs() < 16 * epsilon).select(0, motion);
    motion(2) /= body.size;
    motion /= std::max(motion.head<2>().norm(), std::abs(motion(2)) * body.size);
    motions.push_back(motion);
  }
  return motions;
}

/// Says in words what the rigid motion (a, b, c) of a body does: translation (a, b) and rotation c about
/// its centre. Parts are compared as displacements, whose largest is 1: rotation times size.
std::string motion_in_words(const Eigen::Vector3d& motion, const ConnectedBody& body) {
  constexpr double visible = 1e-6;  // one more digit than is printed
  const bool x = std::abs(motion(0)) > visible;
  const bool y = std::abs(motion(1)) > visible;
  if (std::abs(motion(2)) * body.size > visible) {
    const auto printed = [&body](double coordinate) {
      return std::abs(coordinate) > visible * body.size ? coordinate : 0.0;
    };
    return text("turn freely about (", printed(body.centre.x() - motion(1) / motion(2)), ", ",
                printed(body.centre.y() + motion(0) / motion(2)), ')');
  }
  if (x && y) return text("move freely in direction (", motion(0), ", ", motion(1), ')');
  return x ? "move freely in direction x" : "move freely in direction y";
}

}  // namespace

std::vector<FreeMotion> free_motions(const Mesh& mesh, const std::vector<MeshPiece>& pieces,
                                     const Unknowns& unknowns, PlaneState state) {
  std::vector<FreeMotion> found;
  for (const MeshPiece& piece : pieces) {
    const ConnectedBody body(mesh, piece);
    for (const Eigen::Vector3d& motion : motions_of(body, unknowns, state)) {
      FreeMotion free;
      free.sentence = text("body '", mesh.name, "' (", in_words(mesh, piece), ") can ",
                           motion_in_words(motion, body));
      free.shape.setZero(unknowns.count);
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
          free.shape(unknown) = still ? 0 : moves;
        }
      }
      found.push_back(std::move(free));
    }
  }
  return found;
}

std::vector<FreeMotion> free_motions(const Mesh& mesh, const Unknowns& unknowns, PlaneState state) {
  return free_motions(mesh, pieces(mesh), unknowns, state);
}

}  // namespace signorini
