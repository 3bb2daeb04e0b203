// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How far bodies have turned.
#pragma once
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Mean turn of a piece of a mesh: of the rotation in \f$ \int (1 + \nabla u)\,dA \f$, so that strains and what bends one way
/// here and the other way there count nothing.
/// \param mesh           the body
/// \param piece          of it
/// \param displacements  `n_nodes x 2` of its nodes [length]
/// \return counter-clockwise, from -pi to pi [rad]
[[nodiscard]] double mean_turn(const Mesh& mesh, const MeshPiece& piece,
                               const NodeArray& displacements);

/// Small strain takes a turn for a strain of half its square, and turns no stress. Notes a body that has turned by more than
/// 1e-3, and withdraws a solution in which one has turned by more than 1e-2 or a cell is turned inside out, as `TurnedTooFar`.
/// \param model     that was solved
/// \param[in,out] solution  of it, Solved
void check_rotations(const Model& model, Solution& solution);

}  // namespace signorini
