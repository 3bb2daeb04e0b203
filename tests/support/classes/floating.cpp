// Bodies that supports leave free to move: a bar on springs, a punch, contradictions.
#include "support/floating.hpp"

#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Instance known(std::string name, const ContactProblem& problem, const VectorXd& force,
               const VectorXd& gap, const VectorXd& amplitude) {
  Instance made{std::move(name), problem};
  made.force = force;
  made.gap = gap;
  made.amplitude = amplitude;
  made.accuracy = 1e-14;
  return made;
}

Instance unsolvable(std::string name, const ContactProblem& problem) {
  Instance made{std::move(name), problem};
  made.expected = SolveStatus::Infeasible;
  return made;
}

}  // namespace

Instances bar_on_springs() {
  Instances made = {
      // Weight 6 a third of the way: forces 4 and 2; each end sinks until its spring carries its part.
      known("law of the lever", bar(Vector2d(0, 3), Vector2d(0.5, 0.25), Vector2d(1, 2), 6, 1),
            Vector2d(4, 2), Vector2d(0, 0), Vector2d(-3, 0.5 / 3)),
      // The weight stands on the left half and the right spring lies deep: only the left two carry.
      known("lifts off one", bar(Vector3d(0, 1, 2), Vector3d(1, 1, 1), Vector3d(0, 0, 5), 2, 0.5),
            Vector3d(1, 1, 0), Vector3d(0, 0, 4), Vector2d(-1, 0)),
      // Springs of compliance 1e-6 under gaps of 1e3 that differ by 10: nine orders of magnitude.
      known("falls from far",
            bar(Vector2d(0, 1), Vector2d(1e-6, 1e-6), Vector2d(1000, 1010), 1, 0.5),
            Vector2d(0.5, 0.5), Vector2d(0, 0), {})};
  made.back().accuracy = 1e-10;
  return made;
}

Instances bar_pulled_away() {  // upwards; and beyond each end, where the bar tips over
  Instances made;
  for (const Vector2d& load : {Vector2d(-1, 1.5), Vector2d(1, -0.1), Vector2d(1, 3.1)})
    made.push_back(
        unsolvable(text("weight ", load.x(), " at ", load.y()),
                   bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(1, 1), load.x(), load.y())));
  ContactProblem unnoticed = bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(1, 1), 2, 1);
  unnoticed.rigid = (MatrixXd(2, 3) << unnoticed.rigid, VectorXd::Zero(2)).finished();
  unnoticed.resultant = Vector3d(2, 2, 0.5);
  made.push_back(unsolvable("a motion that no pair notices", unnoticed));
  return made;
}

Instances
bar_undecided() {  // pairs that touch without force, forces that cancel, motions that nothing determines
  Eigen::Matrix3d G;
  G << 1, 1, -1, 1, 1, -1, -1, -1, 1;
  ContactProblem unnoticed = bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(1, 1), 2, 1);
  unnoticed.rigid = (MatrixXd(2, 3) << unnoticed.rigid, VectorXd::Zero(2)).finished();
  unnoticed.resultant = Vector3d(2, 2, 0);
  return {
      {"right above the last support", bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(0, 1), 1, 0)},
      {"forces that cancel",
       {G, Vector3d(0, 1, 0), {}, {}, Vector3d(0, 1, -1), VectorXd::Constant(1, -2)}},
      {"touching",
       {Eigen::Matrix2d::Identity(),
        Vector2d(-2, 0),
        {},
        {},
        Vector2d(-1, 1),
        VectorXd::Constant(1, -2)}},
      {"a motion that no pair notices", unnoticed}};
}

Instances punch() {  // flat, on a half-plane, pressed at its centre and beside it: it may tilt
  Instances made;
  for (const Index n : {11, 50})
    for (const double at : {0.0, 0.3}) {
      ContactProblem problem = half_plane_indentation(n, Punch::Flat).problem;
      problem.free_gap.setZero();
      problem.rigid.resize(n, 2);
      problem.rigid << VectorXd::Ones(n), VectorXd::LinSpaced(n, -1, 1);
      problem.resultant = Vector2d(1, at);
      made.push_back({text(n, " pairs, pressed at ", at), problem});
    }
  return made;
}

Instances
walls_too_close() {  // two rigid walls closer to each other than the rigid block between them
  return {unsolvable(
      "two walls",
      {MatrixXd::Zero(2, 2), Vector2d(-1, -1), {}, {}, Vector2d(1, -1), VectorXd::Zero(1)})};
}

Instances floating_backwards() {
  Random random(7);
  Instances made;
  for (int sample = 0; sample < 40; ++sample) {
    const KnownFloating answer = known_floating(random, 0.5, sample % 2 == 0 ? 1 : 100);
    made.push_back(
        {text("sample ", sample), condense(answer.programme, answer.null_vectors).problem});
  }
  return made;
}

}  // namespace signorini_test
