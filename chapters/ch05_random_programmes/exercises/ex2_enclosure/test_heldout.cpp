#include <cmath>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "signorini/core/random.hpp"

using Eigen::Index;
using Eigen::VectorXd;

namespace {

VectorXd random_vector(signorini::Random& random, Index n) {
  VectorXd made(n);
  for (double& entry : made) entry = random.uniform(-1, 1);
  return made;
}

}  // namespace

TEST_CASE("ex5.2 held out: a programme made backwards is solved by what was put in", "[ex5.2]") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const signorini::KnownProgramme known = signorini::rosen_suzuki(12, 20, seed);
    const auto& [K, p, A, g, equations] = known.programme;
    const VectorXd gap = (g - A * known.displacement).cwiseMax(0);
    const signorini::DenseProgramme made =
        ex5_2::backwards(K, A, known.displacement, known.force, gap);
    CHECK(signorini::certify(made, {known.displacement, {}, known.force}).holds());
  }
}

// Weak duality, for whatever is put in: f* is never outside.
TEST_CASE("ex5.2 held out: the bounds enclose the least energy", "[ex5.2]") {
  signorini::Random random(1);
  int finite = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const signorini::KnownProgramme known =
        signorini::rosen_suzuki(5, 8, static_cast<std::uint64_t>(sample));
    const double distance = 0.3 * random.uniform(0, 1);
    const ex5_2::Enclosure bounds =
        ex5_2::enclose(known.programme, known.displacement + distance * random_vector(random, 5),
                       known.force + distance * random_vector(random, 8));
    CAPTURE(sample);
    CHECK(bounds.lower <= known.energy + 1e-12 * std::abs(known.energy));
    CHECK(bounds.upper >= known.energy - 1e-12 * std::abs(known.energy));
    finite += std::isfinite(bounds.upper) ? 1 : 0;
  }
  CHECK(finite > 10);
}

TEST_CASE("ex5.2 held out: rounding of gaps is no overlap, at any scale of a row", "[ex5.2]") {
  const signorini::KnownProgramme known = signorini::rosen_suzuki(20, 40, 1);
  signorini::DenseProgramme scaled = known.programme;
  VectorXd force = known.force;
  for (Index i = 0; i < 40; ++i) {
    const double row = i % 2 == 0 ? 1e8 : 1e-8;
    scaled.A.row(i) *= row;
    scaled.initial_gap(i) *= row;
    force(i) /= row;
  }
  const ex5_2::Enclosure bounds = ex5_2::enclose(scaled, known.displacement, force);
  CHECK(bounds.lower == Approx(known.energy).epsilon(1e-12));
  CHECK(bounds.upper == Approx(known.energy).epsilon(1e-12));
}
