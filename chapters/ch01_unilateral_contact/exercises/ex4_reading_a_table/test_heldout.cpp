#include <cmath>

#include "../chapters/ch01_unilateral_contact/block_on_obstacle.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/scene/readings.hpp"

using namespace ex1_4;
using Eigen::Index;
using Eigen::VectorXd;

TEST_CASE("ex1.4 held out: the answers are those of the scene", "[ex1.4]") {
  const Answers mine = answers();
  const signorini::SolvedScene block = signorini::solved(ch01::block_on_obstacle(8), "the block");
  const VectorXd& free_gap = block.condensed.problem.free_gap;
  const VectorXd& gap = block.solution.contact.gap;
  const VectorXd& force = block.solution.contact.force;
  const VectorXd x = block.model.pairs.position.col(0);
  CHECK(mine.overlapping == (free_gap.array() < 0).count());
  CHECK(mine.closed == (force.array() > 0).count());
  CHECK(mine.sets == std::pow(2, mine.overlapping));
  CHECK(std::abs(mine.total_force - force.sum()) < 0.01);
  double closed_at = 0, open_at = 20;
  for (Index i = 0; i < x.size(); ++i) {
    if (std::abs(x(i)) < 1e-9) CHECK(std::abs(mine.pressure - block.solution.pressure(i)) < 0.002);
    if (std::abs(x(i) - 10) < 1e-9) CHECK(std::abs(mine.lift - (gap(i) - free_gap(i))) < 0.002);
    if (force(i) > 0) closed_at = std::max(closed_at, x(i));
    if (force(i) == 0 && x(i) > 0) open_at = std::min(open_at, x(i));
  }
  CHECK(mine.closed_at == Approx(closed_at).epsilon(1e-9));
  CHECK(mine.open_at == Approx(open_at).epsilon(1e-9));
}
