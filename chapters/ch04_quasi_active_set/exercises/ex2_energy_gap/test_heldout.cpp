#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/random.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// A random programme whose rows all have u = 0 inside, and two balanced states of it: one strictly
/// feasible near 0, and the optimum of the first rows alone.
struct Case {
  DenseProgramme q;
  ex4_2::Balanced from;
  ex4_2::Balanced towards;
};

Case random_case(std::uint64_t seed) {
  Random random(seed);
  Case made{rosen_suzuki(6, 8, seed).programme, {}, {}};
  DenseProgramme& q = made.q;
  made.from.force.resize(8);
  for (double& f : made.from.force) f = random.uniform(0, 1);
  for (double& g : q.initial_gap) g = random.uniform(0.05, 0.5);
  for (double& p : q.load) p = random.uniform(-5, 5);
  const CholeskyFactor K(q.stiffness);
  const VectorXd u = K.solve(q.load - q.A.transpose() * made.from.force);
  q.initial_gap += (q.A * u).cwiseMax(0.0);  // now u is feasible
  made.from.displacement = u;
  const Eigen::MatrixXd rows = q.A.topRows(3);
  const ContactProblem part{rows * K.solve_columns(rows.transpose()),
                            q.initial_gap.head(3) - rows * K.solve(q.load)};
  made.towards.force = VectorXd::Zero(8);
  made.towards.force.head(3) = find_solver("enumerate").solve(part, {}).force;
  made.towards.displacement = K.solve(q.load - q.A.transpose() * made.towards.force);
  return made;
}

double energy(const DenseProgramme& q, const VectorXd& u) {
  return 0.5 * u.dot(q.stiffness * u) - q.load.dot(u);
}

double least_energy(const DenseProgramme& q) {
  const CholeskyFactor K(q.stiffness);
  const ContactProblem all{q.A * K.solve_columns(q.A.transpose()),
                           q.initial_gap - q.A * K.solve(q.load)};
  const ContactState best = find_solver("enumerate").solve(all, {});
  REQUIRE(best.report.status == SolveStatus::Solved);
  return energy(q, K.solve(q.load - q.A.transpose() * best.force));
}

}  // namespace

TEST_CASE("ex4.2 held out: the end is feasible, balanced, lower, and the bound holds", "[ex4.2]") {
  const std::uint64_t seed = GENERATE(range(1U, 61U));
  const auto [q, from, towards] = random_case(seed);
  const ex4_2::End end = ex4_2::last_step(q, from, towards);
  CAPTURE(seed, end.fraction);
  REQUIRE(end.state.displacement.size() == 6);
  REQUIRE(end.state.force.size() == 8);
  const VectorXd& u = end.state.displacement;
  const VectorXd gap = q.initial_gap - q.A * u;
  CHECK(end.fraction > 0);
  CHECK(end.fraction <= 1);
  CHECK(gap.minCoeff() > -1e-13);
  if (end.fraction < 1) CHECK(gap.minCoeff() < 1e-13);  // it goes as far as it can
  CHECK(end.state.force.minCoeff() >= 0);
  CHECK((q.stiffness * u + q.A.transpose() * end.state.force - q.load).norm() < 1e-12);
  CHECK(end.energy == Approx(energy(q, u)).epsilon(1e-13));
  CHECK(end.energy < energy(q, from.displacement));
  const double lost = end.energy - least_energy(q);
  CHECK(lost <= end.energy_gap + 1e-12);
  CHECK(end.energy_gap == Approx(end.state.force.dot(gap)).epsilon(1e-11).margin(1e-13));
  CHECK(end.optimal == (end.energy_gap <= 1e-12 * (1 + std::abs(end.energy))));
  if (end.optimal) CHECK(lost <= 1e-11);
}

// The target is on a row but for rounding; it must not be stopped there.
TEST_CASE("ex4.2 held out: a row that the target just touches does not stop it", "[ex4.2]") {
  const double third = 1 / 3.0;
  DenseProgramme q{Eigen::Matrix2d::Identity(), Eigen::Vector2d(1, 1), Eigen::MatrixXd(1, 2),
                   VectorXd::Constant(1, 0.2)};
  q.A << third, 0.1;
  const double force = (third + 0.1 - 0.2) / (third * third + 0.01);
  const ex4_2::Balanced towards{q.load - force * q.A.row(0).transpose(),
                                VectorXd::Constant(1, force)};
  const ex4_2::Balanced from{q.load - 2 * force * q.A.row(0).transpose(),
                             VectorXd::Constant(1, 2 * force)};
  const ex4_2::End end = ex4_2::last_step(q, from, towards);
  CHECK(end.fraction == Approx(1).epsilon(1e-12));
  CHECK(end.optimal);
}
