/// \file
/// Exercise 22.3 - a node on a round surface, with or without the turning of its normal. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex22_3 {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// A node on springs, and a round surface.
struct Problem {
  Matrix2d stiffness;  ///< K of the springs, symmetric, positive definite [force/length]
  Vector2d load;       ///< p [force]
  Vector2d rest;       ///< where the node is without displacement [length]
  Vector2d middle;     ///< of the surface [length]
  double radius;       ///< of it > 0 [length]
  bool bowl;           ///< whether the node is inside, else outside
};

/// Where the node is.
struct State {
  Vector2d u;    ///< displacement, never to the middle [length]
  double force;  ///< of contact >= 0 [force]
};

/// One iteration: from where the node is to the answer of the contact problem that is linear there.
/// \param problem  any
/// \param now      where it is
/// \param turns    whether the normal of `now.force` turns within the iteration; else it stands still. With it the matrix is
///   regular
/// \return where the linear problem has it; a gap >= 0 of that problem, a force >= 0, one of the two 0
[[nodiscard]] State next(const Problem& problem, const State& now, bool turns);

/// Whether a node at rest on the surface stays there if it is nudged along it.
/// \param problem  any
/// \param end      in balance, the gap 0, the force > 0
/// \return whether what pushes it back is larger than what pushes it on
[[nodiscard]] bool stays(const Problem& problem, const State& end);

/// The loop. \param problem  any \param turns  as above \param most  iterations
/// \return how many it takes until a move is 1e-12 at most; most + 1 if it does not arrive. `end` is where it got to
inline int iterations(const Problem& problem, bool turns, int most, State& end) {
  end = {Vector2d::Zero(), 0};
  for (int k = 1; k <= most; ++k) {
    const State then = next(problem, end, turns);
    const double move = (then.u - end.u).norm();
    end = then;
    if (move <= 1e-12) return k;
  }
  return most + 1;
}

}  // namespace ex22_3
