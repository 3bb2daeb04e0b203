// The six solvers of the surrogate dual against closed forms and against trial of all sets.
#include <cmath>

#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/solvers.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

const WeightRule rules[] = {WeightRule::Harmonic, WeightRule::LineSearch, WeightRule::AwaySteps,
                            WeightRule::Pairwise, WeightRule::FullyCorrective};

}  // namespace

TEST_CASE("every rule but the literal one agrees with trial of all sets", "[surrogate_dual]") {
  Random random(21);
  for (int sample = 0; sample < 100; ++sample) {
    const ContactProblem problem = random_problem(random, random.whole(1, 6));
    const ContactState reference = enumerate(problem);
    for (const WeightRule rule : rules) {
      const ContactState state = surrogate_dual(problem, rule);
      CAPTURE(sample, static_cast<int>(rule));
      if (rule != WeightRule::FullyCorrective && state.report.status != SolveStatus::Solved) {
        CHECK(state.report.status == SolveStatus::IterationLimit);  // slow, and says so
        continue;
      }
      REQUIRE(state.report.status == SolveStatus::Solved);
      CHECK(state.active() == reference.active());
      CHECK((state.force - reference.force).norm() <= 1e-10 * reference.force.norm());
    }
  }
}

TEST_CASE("the literal rule solves what one pair carries", "[surrogate_dual]") {
  Eigen::Matrix3d G;
  G << 2, 1, 1, 1, 2, 0, 1, 0, 2;
  const ContactProblem problem{G, Vector3d(-6, -2, -1)};
  const ContactState state = surrogate_dual(problem, WeightRule::LiteralVertex);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK((state.force - Vector3d(3, 0, 0)).norm() < 1e-14);
  CHECK((state.gap - Vector3d(0, 1, 2)).norm() < 1e-14);
}

TEST_CASE("an indented half-plane: contact zone and total force of Hertz",
          "[surrogate_dual][closed-form]") {
  for (const Index n : {40, 200}) {
    const Indentation known = half_plane_indentation(n);
    const ContactProblem& problem = known.problem;
    const auto inside = (known.position.cwiseAbs().array() < known.half_width).count();
    for (const WeightRule rule : rules) {
      const ContactState state = surrogate_dual(problem, rule);
      CAPTURE(n, static_cast<int>(rule));
      REQUIRE(state.report.status == SolveStatus::Solved);
      CHECK(certify(problem, state).holds());
      CHECK(std::abs(static_cast<Index>(state.active().size()) - inside) <= 2);
      CHECK(state.force.sum() == Approx(known.total_force).epsilon(1e-3));
    }
  }
}

TEST_CASE("units and scales of rows change neither pairs nor iterations", "[surrogate_dual]") {
  Random random(22);
  for (int sample = 0; sample < 20; ++sample) {
    const ContactProblem problem = random_problem(random, 6);
    VectorXd row(6);
    for (double& scale : row) scale = std::ldexp(1.0, random.whole(-20, 20));  // no rounding
    for (const WeightRule rule : rules) {
      const ContactState state = surrogate_dual(problem, rule);
      const ContactState other = surrogate_dual(with_rows(problem, row), rule);
      const ContactState units = surrogate_dual(in_units(problem, 0x1p-30, 0x1p10), rule);
      CHECK(other.active() == state.active());
      CHECK(other.report.iterations == state.report.iterations);
      CHECK(units.active() == state.active());
      CHECK(units.report.iterations == state.report.iterations);
      CHECK((units.force - 0x1p10 * state.force).norm() <= 1e-12 * units.force.norm());
    }
  }
}

TEST_CASE("contradictory gaps are proven by weights that yield nowhere", "[surrogate_dual]") {
  Random random(23);
  int found = 0;
  for (int sample = 0; sample < 200; ++sample) {  // whole numbers: G is singular without rounding
    const Index n = random.whole(2, 7);
    Eigen::MatrixXd V(n, std::max<Index>(1, n - 2));
    for (double& entry : V.reshaped()) entry = random.whole(-2, 2);
    VectorXd d(n);
    for (double& gap : d) gap = random.whole(-3, 3);
    const ContactProblem problem{V * V.transpose(), d};
    const ContactState state = surrogate_dual(problem, WeightRule::FullyCorrective);
    CAPTURE(sample);
    REQUIRE(state.report.status == enumerate(problem).report.status);
    if (state.report.status == SolveStatus::Solved) {
      CHECK(certify(problem, state).holds());
      continue;
    }
    ++found;
    const VectorXd& y = state.farkas_certificate;
    REQUIRE(y.size() == n);
    CHECK(y.minCoeff() >= 0);
    CHECK(d.dot(y) < 0);
    CHECK((problem.compliance * y).norm() <= 1e-12 * problem.compliance.norm() * y.norm());
  }
  CHECK(found > 10);
}

TEST_CASE("the history stays short and begins at the start", "[surrogate_dual]") {
  const ContactState state =
      surrogate_dual(half_plane_indentation(200).problem, WeightRule::LineSearch);
  CHECK(state.report.iterations > 500);
  CHECK(state.report.history.size() < 200);
  CHECK(state.report.history.front().active == 200);  // (29): e / n_c
  for (std::size_t k = 1; k < state.report.history.size(); ++k)
    CHECK(state.report.history[k].dual_energy >= state.report.history[k - 1].dual_energy);
}

TEST_CASE("a limit on iterations is kept and reported", "[surrogate_dual]") {
  SolverOptions options;
  options.iteration_limit = 3;
  const ContactProblem problem = half_plane_indentation(60).problem;
  for (const WeightRule rule : rules) {
    const ContactState state = surrogate_dual(problem, rule, options);
    CHECK(state.report.iterations <= 3);
    CHECK(state.force.minCoeff() >= 0);
    if (rule == WeightRule::FullyCorrective)  // four vertices of thirty
      CHECK(state.report.status == SolveStatus::IterationLimit);
    else if (state.report.status == SolveStatus::Solved)  // its last guess may be right
      CHECK(certify(problem, state).holds());
    else
      CHECK(state.report.status == SolveStatus::IterationLimit);
  }
}

TEST_CASE("where the weights stop, pairs that would have to pull are left out",
          "[surrogate_dual][closed-form]") {
  // Forces (1, 1.2) open the third pair by 0.18; closed with them it would pull with 0.26.
  Eigen::Matrix3d G = Eigen::Matrix3d::Identity();
  G(0, 2) = G(2, 0) = G(1, 2) = G(2, 1) = 0.4;
  const ContactProblem problem{G, Eigen::Vector3d(-1, -1.2, -0.7)};
  SolverOptions one_step;
  one_step.iteration_limit = 1;
  const ContactState state = surrogate_dual(problem, WeightRule::LineSearch, one_step);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.active() == std::vector<Eigen::Index>{0, 1});
  CHECK((state.force - Eigen::Vector3d(1, 1.2, 0)).norm() < 1e-15);
  CHECK((state.gap - Eigen::Vector3d(0, 0, 0.18)).norm() < 1e-15);
}
