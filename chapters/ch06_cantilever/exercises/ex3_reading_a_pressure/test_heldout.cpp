#include <cmath>

#include "../chapters/ch06_cantilever/scene.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex6_3::Answers;
using ex6_3::answers;

TEST_CASE("ex6.3 held out: the values are those of the scene", "[ex6.3]") {
  const Answers mine = answers();
  const signorini::SolvedScene beam = ch06::solve_cantilever(ch06::paper, "q4_incompatible", 200);
  const Eigen::VectorXd x = beam.model.pairs.position.col(0);
  const Eigen::VectorXd& force = beam.solution.contact.force;
  Eigen::Index peak = 0;
  CHECK(std::abs(mine.peak - beam.solution.pressure.maxCoeff(&peak)) < 0.01);
  CHECK(std::abs(mine.peak_at - x(peak)) < 1e-3);
  CHECK(std::abs(mine.first_closed - x(beam.solution.contact.active().front())) < 1e-3);
  CHECK(std::abs(mine.force - force.sum()) < 0.01);
  CHECK(std::abs(mine.place - force.dot(x) / force.sum()) < 0.01);
  const double load = ch06::paper.pressure * ch06::paper.length * ch06::paper.width;
  CHECK(std::abs(mine.clamp_force - (load - force.sum())) < 0.01);
  CHECK(std::abs(mine.clamp_moment - (0.5 * ch06::paper.length * load - force.dot(x))) < 1);
}
