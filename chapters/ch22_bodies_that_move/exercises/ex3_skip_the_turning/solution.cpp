#include <Eigen/LU>
#include <algorithm>

#include "exercise.hpp"

namespace ex22_3 {
namespace {

struct Look {
  double gap;
  Vector2d normal;
  Matrix2d turning;  // of the normal with the place
};

Look look(const Problem& problem, const Vector2d& u) {
  const Vector2d arm = problem.rest + u - problem.middle;
  const double r = arm.norm();
  const double sign = problem.bowl ? -1 : 1;
  const Vector2d n = sign * arm / r;
  return {sign * (r - problem.radius), n,
          sign / r * (Matrix2d::Identity() - n * n.transpose())};
}

}  // namespace

State next(const Problem& problem, const State& now, bool turns) {
  const auto [gap, n, turning] = look(problem, now.u);
  Matrix2d K = problem.stiffness;
  if (turns) K -= now.force * turning;
  const Vector2d free = K.inverse() * (problem.load - problem.stiffness * now.u);
  const Vector2d pushed = K.inverse() * n;
  const double force = std::max(0.0, -(gap + n.dot(free)) / n.dot(pushed));
  return {now.u + free + force * pushed, force};
}

bool stays(const Problem& problem, const State& end) {
  const auto [gap, n, turning] = look(problem, end.u);
  const Vector2d t(n.y(), -n.x());
  return t.dot((problem.stiffness - end.force * turning) * t) > 0;
}

}  // namespace ex22_3
