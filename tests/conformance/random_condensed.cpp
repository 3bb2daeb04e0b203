// Three thousand random condensed problems: nobody may be wrong, and two members solve nearly all.
#include "support/random_condensed.hpp"

#include <map>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/chosen.hpp"

using namespace signorini;
using namespace signorini_test;

TEST_CASE("every solver: none is wrong about a random condensed problem", "[conformance]") {
  for (const Solver& solver : chosen(solvers()))
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const RandomCondensed random = random_condensed(seed);
      CAPTURE(solver.name, random.name);
      CHECK(verdict(random, solve_with_proofs(random.problem, solver)) != Verdict::Wrong);
    }
}

TEST_CASE("every solver: the default solves all but three in a thousand random condensed problems",
          "[conformance]") {
  for (const Solver& solver :
       chosen<Solver>({find_solver("primal_dual_active_set"), find_solver("quasi_active_set")})) {
    std::map<Verdict, int> feasible;
    std::map<Verdict, int> infeasible;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
      const RandomCondensed random = random_condensed(seed);
      const Verdict found = verdict(random, solve_with_proofs(random.problem, solver));
      CAPTURE(solver.name, random.name);
      CHECK(found != Verdict::Wrong);
      ++(random.feasible ? feasible : infeasible)[found];
    }
    CAPTURE(solver.name);
    CHECK(feasible[Verdict::Solved] >= 2000);
    // Those that remain have forces which nearly cancel, of nearly opposite rows.
    CHECK(1000 * feasible[Verdict::Failed] < 3 * feasible[Verdict::Solved]);
    CHECK(infeasible[Verdict::Refuted] >= 400);
    CHECK(20 * infeasible[Verdict::Failed] < infeasible[Verdict::Refuted]);
  }
}

TEST_CASE("the judge of random condensed problems finds what is wrong", "[conformance]") {
  Eigen::Matrix2d G;
  G << 1, -1, -1, 1;
  const RandomCondensed wedged{"wedged", {G, Eigen::Vector2d(-1, 0.5)}, false};
  const RandomCondensed grazing{"grazing", {G, Eigen::Vector2d(-1, 1)}, true};
  ContactState state{Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0),
                     {ContactStatus::Stick, ContactStatus::Open}, {}};
  state.report.status = SolveStatus::Solved;
  CHECK(verdict(grazing, state) == Verdict::Solved);
  CHECK(verdict(wedged, state) == Verdict::Wrong);
  state.force(0) = 0.9;
  CHECK(verdict(grazing, state) == Verdict::Wrong);
  state.report.status = SolveStatus::Infeasible;
  CHECK(verdict(wedged, state) == Verdict::Wrong);
  state.farkas_certificate = Eigen::Vector2d(1, 1);
  CHECK(verdict(wedged, state) == Verdict::Refuted);
  CHECK(verdict(grazing, state) == Verdict::Wrong);
  state.farkas_certificate = Eigen::Vector2d(1, 0.9);
  CHECK(verdict(wedged, state) == Verdict::Wrong);
  state.report.status = SolveStatus::Breakdown;
  CHECK(verdict(wedged, state) == Verdict::Failed);
}
