// The safeguarded quasi-active set: exact on programmes with known solutions, degenerate and dependent rows
// included, in few steps, with a proof where nothing solves the problem.
#include <algorithm>
#include <cmath>

#include "addons/programme/active_set_programme.hpp"
#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

const Solver& method() { return find_solver("quasi_active_set"); }

struct Size {
  Index n, m;
};
const Size table_1[] = {{10, 5},  {10, 10}, {10, 20}, {10, 40}, {20, 10},  {20, 20},
                        {20, 40}, {20, 80}, {50, 25}, {50, 50}, {50, 100}, {50, 200}};

/// The programme with p and g such that u and force solve it with these gaps.
void pose(KnownProgramme& known, const VectorXd& gap) {
  DenseProgramme& programme = known.programme;
  programme.load = programme.stiffness * known.displacement + programme.A.transpose() * known.force;
  programme.initial_gap = programme.A * known.displacement + gap;
}

VectorXd gaps_of(const KnownProgramme& known) {
  return known.programme.initial_gap - known.programme.A * known.displacement;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Small whole numbers, often with rows that repeat or add up.
DenseProgramme whole_programme(Random& random) {
  const Index n = random.whole(1, 6);
  const Index m = random.whole(1, 9);
  const auto draw = [&](Index rows, Index cols, int most) {
    MatrixXd matrix(rows, cols);
    for (Index i = 0; i < matrix.size(); ++i) matrix.data()[i] = random.whole(-most, most);
    return matrix;
  };
  const MatrixXd B = draw(n, n, 2);
  DenseProgramme programme{B * B.transpose() + MatrixXd::Identity(n, n), draw(n, 1, 6),
                           draw(m, n, 3), draw(m, 1, 4)};
  if (m > 2 && random.whole(0, 1) == 1)
    programme.A.row(m - 1) = random.whole(-1, 2) * programme.A.row(0);
  if (m > 3 && random.whole(0, 1) == 1)
    programme.A.row(m - 2) = programme.A.row(0) + programme.A.row(1);
  return programme;
}

}  // namespace

TEST_CASE("programmes of table 1 are solved to rounding in a few steps", "[quasi_active_set]") {
  for (const Size size : table_1) {
    std::vector<double> steps;
    std::vector<double> factorisations;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const KnownProgramme known = rosen_suzuki(size.n, size.m, seed);
      const DenseSolution solution = solve(known.programme, method());
      CAPTURE(size.n, size.m, seed);
      REQUIRE(solution.report.status == SolveStatus::Solved);
      CHECK(solution.certificate.worst() <= 1e-13);
      CHECK((solution.refined.displacement - known.displacement).norm() <=
            1e-13 * known.displacement.norm());
      CHECK((solution.refined.force - known.force).norm() <= 1e-11 * known.force.norm());
      CHECK(static_cast<Index>(solution.active.size()) == std::min(size.n, size.m) / 2);
      steps.push_back(static_cast<double>(solution.report.iterations));
      factorisations.push_back(static_cast<double>(solution.report.factorisations));
    }
    CHECK(median(steps) <= 6);
    CHECK(median(factorisations) <= 15);
  }
}

TEST_CASE("programmes with 4000 small whole numbers are solved or refuted with a proof",
          "[quasi_active_set]") {
  Random random(7);
  int solved = 0;
  int refuted = 0;
  for (int sample = 0; sample < 4000; ++sample) {
    const DenseProgramme programme = whole_programme(random);
    const DenseSolution solution = solve(programme, method());
    CAPTURE(sample, to_string(solution.report.status));
    if (solution.report.status == SolveStatus::Solved) {  // unique u: the certificate is a proof
      CHECK(solution.certificate.worst() <= 1e-12);
      ++solved;
      continue;
    }
    REQUIRE(solution.report.status == SolveStatus::Infeasible);
    // y >= 0 with A^T y = 0 and g.y < 0: no u has A u <= g.
    const VectorXd& y = solution.farkas_certificate;
    REQUIRE(y.size() == programme.A.rows());
    CHECK(y.minCoeff() >= 0);
    CHECK((programme.A.transpose() * y).norm() <= 1e-12 * y.norm());
    CHECK(programme.initial_gap.dot(y) < -1e-6 * y.norm());
    ++refuted;
  }
  CHECK(solved > 2500);
  CHECK(refuted > 500);
}

TEST_CASE("both input forms close the same pairs", "[quasi_active_set]") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const KnownProgramme known = rosen_suzuki(20, 15, seed);
    const ContactProblem problem = condense(known.programme).problem;
    const ContactState state = quasi_active_set(problem);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.active() == quasi_active_set(known.programme).active);
    CHECK((state.force - known.force).norm() <= 1e-10 * known.force.norm());
  }
}

TEST_CASE("ill-conditioned stiffness costs steps and no accuracy of the conditions",
          "[quasi_active_set][hard]") {
  for (const double condition : {1e6, 1e10, 1e13}) {
    KnownProgramme known = rosen_suzuki(30, 60, 1);
    Random random(5);
    // Reflections of a graded diagonal: the condition is that of the diagonal.
    VectorXd diagonal(30);
    for (Index i = 0; i < 30; ++i) diagonal(i) = std::pow(condition, -static_cast<double>(i) / 29);
    MatrixXd Q = MatrixXd::Identity(30, 30);
    for (int k = 0; k < 3; ++k) {
      VectorXd v(30);
      for (Index i = 0; i < 30; ++i) v(i) = random.uniform(-1, 1);
      v.normalize();
      Q -= 2 * v * (v.transpose() * Q).eval();
    }
    MatrixXd K = Q * diagonal.asDiagonal() * Q.transpose();
    known.programme.stiffness = 0.5 * (K + K.transpose());
    pose(known, gaps_of(known));
    const DenseSolution solution = solve(known.programme, method());
    CAPTURE(condition);
    CHECK(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.worst() <= 1e-14);  // u is refined and kept in two parts
  }
}

TEST_CASE("nearly parallel rows are told apart down to the last digits",
          "[quasi_active_set][hard]") {
  for (const double angle : {1e-4, 1e-8, 1e-12}) {
    KnownProgramme known = rosen_suzuki(20, 40, 2);
    Random random(6);
    VectorXd gap = gaps_of(known);
    Index closed = 0;
    while (known.force(closed) == 0) ++closed;
    Index open = 0;
    while (known.force(open) > 0) ++open;
    for (Index j = 0; j < 20; ++j)
      known.programme.A(open, j) = known.programme.A(closed, j) + angle * random.uniform(-1, 1);
    known.force(open) = 1;
    gap(open) = 0;
    pose(known, gap);
    const DenseSolution solution = solve(known.programme, method());
    CAPTURE(angle);
    CHECK(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.worst() <= 1e-14);
    CHECK((solution.refined.displacement - known.displacement).norm() <=
          1e-14 / angle *
              known.displacement.norm());  // rows are rounded, and lean on their difference
  }
}

TEST_CASE("equations hold exactly, contradictory ones are refuted", "[quasi_active_set]") {
  KnownProgramme known = rosen_suzuki(12, 9, 3);
  DenseProgramme& programme = known.programme;
  programme.equations = 3;
  const DenseSolution solution = solve(programme, method());
  REQUIRE(solution.report.status == SolveStatus::Solved);
  CHECK(solution.certificate.worst() <= 1e-14);
  CHECK((programme.A.topRows(3) * solution.refined.displacement - programme.initial_gap.head(3))
            .norm() <= 1e-14);
  CHECK(solve(programme, find_solver("primal_dual_active_set")).active == solution.active);

  programme.A.row(2) = programme.A.row(0) + programme.A.row(1);
  programme.initial_gap(2) = programme.initial_gap(0) + programme.initial_gap(1);
  CHECK(solve(programme, method()).report.status ==
        SolveStatus::Solved);  // follows from the others
  programme.initial_gap(2) += 1;
  CHECK(solve(programme, method()).report.status == SolveStatus::Infeasible);
}

TEST_CASE("the same steps in other units and with other row scales", "[quasi_active_set]") {
  Random random(9);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const KnownProgramme known = rosen_suzuki(20, 40, seed);
    const DenseSolution plain = quasi_active_set(known.programme);
    DenseProgramme scaled = known.programme;
    for (Index i = 0; i < 40; ++i) {
      const double factor = std::pow(10.0, random.uniform(-8, 8));
      scaled.A.row(i) *= factor;
      scaled.initial_gap(i) *= factor;
    }
    scaled.stiffness *= 1e9;
    scaled.load *= 1e9;
    const DenseSolution other = quasi_active_set(scaled);
    CHECK(other.active == plain.active);
    CHECK(other.report.iterations == plain.report.iterations);
    CHECK((other.refined.displacement - plain.refined.displacement).norm() <= 1e-13);
  }
}
