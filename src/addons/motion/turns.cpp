// # Has a body turned?
//
// Small strain reads strains from the symmetric part of \f$ \nabla u \f$. A block that turns by \f$ \theta \f$ without any
// strain has there \f$ \cos\theta - 1 \approx -\theta^2/2 \f$, and resists a turn that costs nothing. So a body that slides
// 0.1 rad down a bowl comes to rest 0.017 of its radius beside the bottom. That is wrong, and no finer mesh mends it.

#include "addons/motion/turns.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/plane.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Makes strains of 5e-7 of nothing [rad].
constexpr double noted_turn = 1e-3;
/// Makes strains of 5e-5, and places beside the right one [rad].
constexpr double refused_turn = 1e-2;

/// The first cell whose corners run clockwise where they have moved, in words; nothing if none does.
std::string inside_out(const BodyModel& body, const NodeArray& displacements) {
  const Mesh& mesh = body.mesh;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const auto corner = [&](int k) -> Eigen::Vector2d {
      return (mesh.nodes.row(mesh.cells(cell, k)) + displacements.row(mesh.cells(cell, k))).transpose();
    };
    double twice_area = 0;
    for (int k = 1; k + 1 < mesh.corners(cell); ++k)
      twice_area += cross(corner(k) - corner(0), corner(k + 1) - corner(0));
    if (twice_area <= 0)
      return text("cell ", cell, " of '", mesh.name, "' at ", in_brackets(mesh.nodes.row(mesh.cells(cell, 0))),
                  " is turned inside out, which small strain does not resist. Give its material a law of finite "
                  "strain (law = \"neo_hooke\"), or take smaller loads");
  }
  return "";
}

}  // namespace

/// Each cell is taken for the polygon of its corners: \f$ \int \nabla u\,dA = \int_{\partial A} u\,n^T ds \f$ with u straight
/// between them.
double mean_turn(const Mesh& mesh, const MeshPiece& piece, const NodeArray& displacements) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    if (!std::binary_search(piece.nodes.begin(), piece.nodes.end(), mesh.cells(cell, 0))) continue;
    const int corners = mesh.corners(cell);
    for (int k = 0; k < corners; ++k) {
      const Index from = mesh.cells(cell, k);
      const Index to = mesh.cells(cell, (k + 1) % corners);
      const Eigen::RowVector2d side = mesh.nodes.row(to) - mesh.nodes.row(from);
      const Eigen::RowVector2d place = mesh.nodes.row(from) - mesh.nodes.row(mesh.cells(cell, 0));
      const Eigen::RowVector2d moved = displacements.row(from) + displacements.row(to);
      sum += 0.5 * (moved + 2 * place + side).transpose() * Eigen::RowVector2d(side.y(), -side.x());
    }
  }
  return std::atan2(sum(1, 0) - sum(0, 1), sum(0, 0) + sum(1, 1));
}

void check_rotations(const Model& model, Solution& solution) {
  double most = 0;
  std::size_t of = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b].material.base.law != nullptr) continue;
    solution.contact.reason = inside_out(model.bodies[b], solution.displacements[b]);
    if (!solution.contact.reason.empty())
      return void(solution.contact.report.status = SolveStatus::TurnedTooFar);
    for (const MeshPiece& piece : model.bodies[b].pieces) {
      const double turn = mean_turn(model.bodies[b].mesh, piece, solution.displacements[b]);
      if (std::abs(turn) <= std::abs(most)) continue;
      most = turn;
      of = b;
    }
  }
  if (std::abs(most) <= noted_turn) return;
  const std::string words =
      text("body '", model.bodies[of].mesh.name, "' has turned by ", most,
           " rad in the mean, which small strain takes for a strain of ", most * most / 2);
  if (std::abs(most) <= refused_turn) {
    solution.notes.push_back(words);
    return;
  }
  solution.contact.report.status = SolveStatus::TurnedTooFar;
  solution.contact.reason =
      text(words, ": up to ", refused_turn,
           " rad is taken. Give its material a law of finite strain (law = \"st_venant_kirchhoff\" "
           "or \"neo_hooke\"), hold the body against turning, or draw its mesh turned as it comes "
           "to stand");
}

}  // namespace signorini
