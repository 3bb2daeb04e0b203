// Three thousand random condensed problems: nobody may be wrong, and two members solve nearly all.
#include "support/random_condensed.hpp"

#include <map>

#include "catch_compat.hpp"
#include "signorini/complementarity/solvers.hpp"

using namespace signorini;
using namespace signorini_test;

TEST_CASE("every solver: none is wrong about a random condensed problem", "[conformance]") {
  for (const Solver& solver : solvers())
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const RandomCondensed random = random_condensed(seed);
      CAPTURE(solver.name, random.name);
      CHECK(outcome(random, solver.solve(random.problem, {})) != Outcome::Wrong);
    }
}

TEST_CASE("every solver: the default solves all but three in a thousand random condensed problems",
          "[conformance]") {
  for (const char* name : {"primal_dual_active_set", "quasi_active_set"}) {
    const Solver& solver = find_solver(name);
    std::map<Outcome, int> feasible;
    std::map<Outcome, int> infeasible;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
      const RandomCondensed random = random_condensed(seed);
      const Outcome found = outcome(random, solver.solve(random.problem, {}));
      CAPTURE(name, random.name);
      CHECK(found != Outcome::Wrong);
      ++(random.feasible ? feasible : infeasible)[found];
    }
    CAPTURE(name);
    CHECK(feasible[Outcome::Solved] >= 2000);
    // Those that remain have forces which nearly cancel, of nearly opposite rows.
    CHECK(1000 * feasible[Outcome::Failed] < 3 * feasible[Outcome::Solved]);
    CHECK(infeasible[Outcome::Refuted] >= 400);
    CHECK(20 * infeasible[Outcome::Failed] < infeasible[Outcome::Refuted]);
  }
}

TEST_CASE("the judge of random condensed problems finds what is wrong", "[conformance]") {
  Eigen::Matrix2d G;
  G << 1, -1, -1, 1;
  const RandomCondensed wedged{"wedged", {G, Eigen::Vector2d(-1, 0.5)}, false};
  const RandomCondensed grazing{"grazing", {G, Eigen::Vector2d(-1, 1)}, true};
  ContactState state{Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0), {0}, {}};
  state.report.status = Status::Solved;
  CHECK(outcome(grazing, state) == Outcome::Solved);
  CHECK(outcome(wedged, state) == Outcome::Wrong);
  state.force(0) = 0.9;
  CHECK(outcome(grazing, state) == Outcome::Wrong);
  state.report.status = Status::Infeasible;
  CHECK(outcome(wedged, state) == Outcome::Wrong);
  state.infeasibility = Eigen::Vector2d(1, 1);
  CHECK(outcome(wedged, state) == Outcome::Refuted);
  CHECK(outcome(grazing, state) == Outcome::Wrong);
  state.infeasibility = Eigen::Vector2d(1, 0.9);
  CHECK(outcome(wedged, state) == Outcome::Wrong);
  state.report.status = Status::Breakdown;
  CHECK(outcome(wedged, state) == Outcome::Failed);
}
