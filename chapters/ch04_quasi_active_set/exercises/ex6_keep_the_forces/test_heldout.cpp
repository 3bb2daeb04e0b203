#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "signorini/core/random.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ex4_6::outer_loop;
using ex4_6::Round;
using signorini::DenseProgramme;

namespace {

double dual_energy(const DenseProgramme& q, const VectorXd& force) {
  const signorini::ContactProblem problem = signorini::condense(q).problem;
  return -force.dot(problem.free_gap + 0.5 * (problem.compliance * force));
}

}  // namespace

TEST_CASE("ex4.6 held out: programmes whose solution is known", "[ex4.6]") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const signorini::KnownProgramme known = signorini::rosen_suzuki(15, 30, seed);
    const DenseProgramme& q = known.programme;
    double energy = 0;
    const std::vector<Round> rounds = outer_loop(q, 60);
    REQUIRE(!rounds.empty());
    for (const Round& round : rounds) {
      CHECK((q.stiffness * round.displacement + q.A.transpose() * round.force - q.load).norm() <
            1e-10);
      CHECK(dual_energy(q, round.force) > energy);  // no set of rows comes back
      energy = dual_energy(q, round.force);
    }
    CHECK(equal_within(rounds.back().displacement, known.displacement, 1e-10));
    CHECK(equal_within(rounds.back().force, known.force, 1e-9));
  }
}

// Few unknowns and many rows in whole numbers: forces are taken back, and rows depend on each other.
TEST_CASE("ex4.6 held out: the least energy, however many rows", "[ex4.6]") {
  signorini::Random random(46);
  for (int sample = 0; sample < 300; ++sample) {
    DenseProgramme q;
    q.stiffness = Eigen::Matrix3d::Identity();
    q.load = VectorXd(3);
    q.A = MatrixXd(8, 3);
    q.initial_gap = VectorXd(8);
    for (double& entry : q.load) entry = random.whole(-6, 6);
    for (double& entry : q.A.reshaped()) entry = random.whole(-3, 3);
    for (double& entry : q.initial_gap) entry = random.whole(0, 2);
    CAPTURE(sample);
    const VectorXd force = signorini::enumerate(signorini::condense(q).problem).force;
    const VectorXd expected = q.load - q.A.transpose() * force;
    const std::vector<Round> rounds = outer_loop(q, 40);
    REQUIRE(rounds.size() < 40);
    const VectorXd u = rounds.empty() ? q.load : rounds.back().displacement;
    CHECK(equal_within(u, expected, 1e-10));
  }
}
