#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "signorini/core/random.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "support/equal_within.hpp"

using namespace ex5_6;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

signorini::ContactProblem at(const Loaded& body, double load) {
  return {body.compliance, body.initial_gap - load * body.response};
}

}  // namespace

TEST_CASE("ex5.6 held out: between two events the closed pairs are those of the problem",
          "[ex5.6]") {
  signorini::Random random(56);
  int opened = 0;
  for (int sample = 0; sample < 200; ++sample) {
    const double unit = sample % 2 == 0 ? 1 : 1e-6;
    const Index n = random.whole(1, 8);
    MatrixXd B(n, n);
    Loaded body{MatrixXd(), VectorXd(n), VectorXd(n)};
    for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
    for (double& entry : body.initial_gap) entry = unit * random.uniform(0.1, 1);
    for (double& entry : body.response) entry = unit * random.uniform(-0.5, 1);
    body.compliance = unit * (B * B.transpose() + 0.05 * MatrixXd::Identity(n, n));
    const double until = 5;
    const Path path = load_path(body, until);
    CAPTURE(sample, n);
    std::vector<bool> closed(static_cast<std::size_t>(n), false);
    double before = 0;
    for (std::size_t k = 0; k <= path.events.size(); ++k) {
      const double load = k < path.events.size() ? path.events[k].load : until;
      REQUIRE(load >= before);
      const signorini::ContactState now = signorini::enumerate(at(body, 0.5 * (before + load)));
      if (load - before > 1e-6)
        for (Index i = 0; i < n; ++i)
          REQUIRE((now.force(i) > 0) == closed[static_cast<std::size_t>(i)]);
      if (k == path.events.size()) break;
      const Event& event = path.events[k];
      REQUIRE(closed[static_cast<std::size_t>(event.pair)] != event.closes);
      closed[static_cast<std::size_t>(event.pair)] = event.closes;
      opened += event.closes ? 0 : 1;
      before = load;
    }
    const VectorXd expected = signorini::enumerate(at(body, until)).force;
    REQUIRE(path.force.size() == n);
    CHECK(equal_within(path.force, expected, 1e-9 * (1 + expected.norm())));
  }
  CHECK(opened > 10);
}

// A punch: every pair closes once, from the middle outwards, and no pair opens.
TEST_CASE("ex5.6 held out: a punch that is pressed in", "[ex5.6]") {
  const signorini::Indentation punch = signorini::half_plane_indentation(41);
  const VectorXd x = punch.position.array() - 0.003;  // off the middle, so that no two are alike
  const Loaded body{punch.problem.compliance, VectorXd(0.01 + 0.5 * x.array().square()),
                    VectorXd::Ones(41)};
  const Path path = load_path(body, 0.3);
  double last = -1;
  for (const Event& event : path.events) {
    CHECK(event.closes);
    CHECK(std::abs(x(event.pair)) > last);
    last = std::abs(x(event.pair));
  }
  const signorini::ContactState end = signorini::primal_dual_active_set(at(body, 0.3));
  CHECK(path.events.size() == end.active().size());
  CHECK(equal_within(path.force, end.force, 1e-10));
}
