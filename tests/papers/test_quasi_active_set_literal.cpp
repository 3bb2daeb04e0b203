// The quasi-active-set method as printed: its way, and that it says truly how it ended.
#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/closest_point.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

ClosestPoint zigzag() {
  Eigen::Matrix2d A;
  A << 0, 1, 1, -1;
  return {A, Vector2d(1, 2), Vector2d(0, 0)};
}

ClosestPoint counter_example() {
  Eigen::MatrixXd A(4, 3);
  A << -3, -2, 3, 1, -3, 3, -1, 2, 0, 2, -3, 3;
  return {A, Vector3d(0, -1, 6), Eigen::Vector4d(1, 1, 1, 2)};
}

double dual_energy(const ContactProblem& problem, const VectorXd& force) {
  return -problem.free_gap.dot(force) - 0.5 * force.dot(problem.compliance * force);
}

/// Energy above that without contact.
double potential_energy(const ContactProblem& problem, const VectorXd& force) {
  return 0.5 * force.dot(problem.compliance * force);
}

}  // namespace

TEST_CASE("moved minima zigzag between two lines and halve their distance from the corner",
          "[literal][closed-form][XuanLi2002-30][XuanLi2002-31][XuanLi2002-32][XuanLi2002-36]"
          "[XuanLi2002-37][XuanLi2002-38][XuanLi2002-39]") {
  const ClosestPoint plane = zigzag();
  for (Index k = 1; k <= 20; ++k) {
    SolverOptions options;
    options.iteration_limit = k;
    const ContactState state = quasi_active_set_literal(plane.problem(), options);
    const double x = std::ldexp(1, -static_cast<int>(k / 2));
    CAPTURE(k);
    CHECK(state.report.status == SolveStatus::IterationLimit);
    CHECK((plane.displacement(state) - Vector2d(x, k % 2 == 1 ? 0 : x)).norm() < 1e-15);
    CHECK(state.report.history.size() == static_cast<std::size_t>(k + 1));
  }
  const QuasiActiveRun run = run_quasi_active_set_literal(plane.problem());
  REQUIRE(run.state.report.status == SolveStatus::Solved);
  CHECK(run.outer_steps >= 2 * 39);  // until 2^-k/2 is below 1e-12
  CHECK(run.tight == std::vector<Index>{0, 1});
  CHECK((run.state.force - Vector2d(3, 1)).norm() < 1e-14);
}

TEST_CASE("the last step of the paper ends where it is feasible and not optimal",
          "[literal][closed-form][XuanLi2002-33][XuanLi2002-34][XuanLi2002-35]") {
  const ClosestPoint space = counter_example();
  const ContactProblem problem = space.problem();
  const QuasiActiveRun run = run_quasi_active_set_literal(problem);
  REQUIRE(run.state.report.status == SolveStatus::Feasible);
  CHECK(run.tight == std::vector<Index>{2, 3});
  CHECK((run.left_over == std::vector<Index>{0, 1}));
  CHECK((run.fraction > 0 && run.fraction < 0.1));
  const VectorXd u = space.displacement(run.state);
  CHECK((u - Vector3d(1, 1, 1)).norm() < 1e-9);  // the limit is met to 1e-12, times its condition
  CHECK(space.energy(u) == Approx(-3.5).epsilon(1e-9));
  const ContactState best = enumerate(problem);
  REQUIRE(best.report.status == SolveStatus::Solved);
  CHECK((49 * best.force - Eigen::Vector4d(1, 83, 87, 0)).norm() < 1e-12);
  CHECK((7 * space.displacement(best) - Vector3d(1, 4, 6)).norm() < 1e-13);
  CHECK(space.energy(space.displacement(best)) == Approx(-395 / 98.0).epsilon(1e-14));
  CHECK(energy_gap(run.state) >= -3.5 + 395 / 98.0);
}

TEST_CASE("the energy gap is potential minus dual energy and bounds what is lost", "[literal]") {
  int feasible = 0;
  for (const auto& [n, m] : {std::pair<Index, Index>{10, 10}, {10, 40}, {20, 20}, {20, 80}})
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const KnownProgramme known = rosen_suzuki(n, m, seed);
      const DenseCondensed condensed = condense(known.programme);
      const ContactProblem problem = condensed.problem;
      const ContactState state = quasi_active_set_literal(problem);
      CAPTURE(n, m, seed, to_string(state.report.status));
      REQUIRE((state.report.status == SolveStatus::Solved ||
               state.report.status == SolveStatus::Feasible));
      CHECK(state.force.minCoeff() >= 0);
      const Certificate certificate = certify(problem, state);
      CHECK(certificate.penetration <= 1e-12);
      CHECK(certificate.equilibrium <= 1e-12);
      const double least = dual_energy(problem, known.force);  // no dual energy exceeds it
      const double excess = potential_energy(problem, state.force) - least;
      const double dual = dual_energy(problem, state.force);
      const double gap = energy_gap(state);
      CHECK(std::abs(potential_energy(problem, state.force) - dual - gap) <= 1e-12 * least);
      CHECK(excess <= gap + 1e-12 * least);
      CHECK(state.report.history.back().dual_energy == Approx(dual).epsilon(1e-12));
      if (state.report.status == SolveStatus::Solved) {
        CHECK(certificate.worst() <= 1e-12);
        CHECK(gap <= 1e-12 * least);
      } else {
        ++feasible;
        CHECK(excess > 1e-9 * least);  // there is truly less energy elsewhere
      }
    }
  CHECK(feasible > 40);
}

TEST_CASE("a compliance without negative entries needs one step", "[literal]") {
  // Forces then open every other gap: what did not overlap does not begin to.
  Random random(4);
  for (int sample = 0; sample < 50; ++sample) {
    ContactProblem problem = random_problem(random, 12);
    const Eigen::MatrixXd positive = problem.compliance.cwiseAbs();
    const Eigen::VectorXd sums = positive.rowwise().sum();
    problem.compliance = positive;
    problem.compliance.diagonal() = sums;  // dominant, so positive definite
    const QuasiActiveRun run = run_quasi_active_set_literal(problem);
    CHECK(run.outer_steps <= 1);
    CHECK(run.state.report.status == SolveStatus::Solved);
  }
}

TEST_CASE("a set of pairs that contradict each other is proved infeasible", "[literal][hard]") {
  Eigen::Matrix2d G;
  G << 1, -1, -1, 1;
  const ContactState state = quasi_active_set_literal({G, Vector2d(-1, -0.5)});
  REQUIRE(state.report.status == SolveStatus::Infeasible);
  REQUIRE(state.farkas_certificate.size() == 2);
  CHECK((G * state.farkas_certificate).norm() < 1e-15);
  CHECK(state.farkas_certificate.dot(Vector2d(-1, -0.5)) < 0);
  // The same walls, of which only one is violated at a time: the loop never ends, and says so.
  CHECK(quasi_active_set_literal({G, Vector2d(-1, 0.5)}).report.status ==
        SolveStatus::IterationLimit);
}

TEST_CASE("rows that become tight in the limit count, even from inside", "[literal]") {
  // u_1 >= 0 holds all along the zigzag with the gap 2^-k/2. At u^0 the second row is open, b = -1, so
  // that (26) fails for the rows of (33).
  ClosestPoint plane = zigzag();
  plane.A.conservativeResize(3, 2);
  plane.A.row(2) << -1, 0;
  plane.g = Vector3d::Zero();
  CHECK(plane.problem().free_gap(1) > 0);
  const QuasiActiveRun run = run_quasi_active_set_literal(plane.problem());
  CHECK(run.tight == std::vector<Index>{0, 1, 2});
  CHECK(run.left_over.empty());
  CHECK(run.state.report.status == SolveStatus::Solved);
  CHECK(plane.displacement(run.state).norm() < 1e-14);
}
