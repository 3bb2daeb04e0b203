#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/errors.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/stress.hpp"
#include "support/message.hpp"
#include "support/random.hpp"
#include "support/shrink_fit.hpp"

using ex18_3::add;
using ex18_3::plan_spinning;
using ex18_3::present;
using ex18_3::solve_spinning;
using ex18_3::Spin;
using ex18_3::SpinningScene;
using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;

namespace {

struct Fit {
  double bore = 10, radius = 20, outside = 40, modulus = 210e3, ratio = 0.3, interference = 0.002;
};

constexpr double rho = 7.85e-9;

/// At which the fit is loose: (3 + nu) rho omega^2 b (c^2 - a^2) = 4 E delta.
double loose_at(const Fit& fit) {
  return std::sqrt(
      4 * fit.modulus * fit.interference /
      ((3 + fit.ratio) * rho * fit.radius * (fit.outside * fit.outside - fit.bore * fit.bore)));
}

double pressure_at(const Fit& fit, double speed) {
  return signorini_test::mean_pressure(
      solve_spinning({signorini_test::bare_fit(fit), {Spin{rho, speed}, Spin{rho, speed}}}));
}

/// A block on a support, turned about any point, with its own weight.
SpinningScene random_block(std::uint64_t seed) {
  signorini_test::Random random(seed);
  BlockSpec spec;
  spec.corner = {random.uniform(-3, 3), random.uniform(-3, 3)};
  spec.cells_x = random.whole(2, 5);
  spec.cells_y = random.whole(2, 5);
  SpinningScene spinning;
  Body& body = spinning.scene.bodies[0];
  body.mesh = make_block(spec);
  body.material = {random.uniform(1, 1e5), 0.3, PlaneState::Strain, random.uniform(0.1, 10)};
  body.supports = {fixed("bottom")};
  body.loads.body_force = [](const Vector2d& /*x*/) { return Vector2d(0, -1e-3); };
  spinning.spin = {Spin{random.uniform(0.1, 10),
                        -random.uniform(0.1, 1),
                        {random.uniform(-3, 3), random.uniform(-3, 3)}}};
  return spinning;
}

}  // namespace

TEST_CASE("ex18.3 held out: a shrink fit gets loose with the square of the speed", "[ex18.3]") {
  const Fit fit = GENERATE(Fit{}, Fit{3, 5, 6, 70e3, 0.4, 0.001});
  const double loose = loose_at(fit);
  const double p0 = pressure_at(fit, 0);
  for (const double part : {0.3, 0.6, 0.9}) {
    CAPTURE(fit.bore, part);
    CHECK(pressure_at(fit, part * loose) ==
          Approx((1 - part * part) * p0).epsilon(0).margin(2e-3 * p0));
  }
  CHECK(pressure_at(fit, 1.01 * loose) == 0);
}

// Equilibrium, to rounding: what supports bear is minus mass times omega^2 times the arm of the middle, and the weight.
TEST_CASE("ex18.3 held out: weight and spin about any point on the same supports", "[ex18.3]") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    const SpinningScene spinning = random_block(seed);
    const SolvedScene run = solve_spinning(spinning);
    const Body& body = spinning.scene.bodies[0];
    const Spin& spin = *spinning.spin[0];
    const double volume = body.material.thickness;
    const Vector2d middle = body.mesh.nodes.row(0).transpose() + Vector2d(0.5, 0.5);
    const Vector2d pull = spin.density * volume * spin.speed * spin.speed * (middle - spin.centre);
    const Vector2d load = pull + Vector2d(0, -1e-3 * volume);
    const Vector2d held = support_forces(run.model, run.solution).colwise().sum().transpose();
    CHECK((held + load).norm() <= 1e-9 * (pull.norm() + 1e-3 * volume));
  }
}

// Several bodies: p has the force where its own body has it, and nothing else.
TEST_CASE("ex18.3 held out: only the body that spins is loaded", "[ex18.3]") {
  const Scene scene = signorini_test::bare_fit(Fit{});
  Ledger ledger;
  const Model before = build(scene, ledger);
  for (const std::size_t turning : {0U, 1U}) {
    CAPTURE(turning);
    SpinningScene spinning{scene, {std::nullopt, std::nullopt}};
    spinning.spin[turning] = Spin{rho, 100};
    const Plan planned = plan_spinning(spinning);
    CHECK(planned.on.size() == plan(scene).on.size() + 1);
    CHECK(planned.on.back().find(turning == 0 ? "'shaft'" : "'hub'") != std::string::npos);
    Model model = before;
    add(spinning, model);
    const Eigen::VectorXd more = model.programme.load - before.programme.load;
    for (std::size_t b = 0; b < 2; ++b) {
      const BodyModel& body = model.bodies[b];
      const double size = more.segment(body.first_unknown, body.unknowns.count).norm();
      CHECK((size > 0) == (b == turning));
      CHECK(static_cast<bool>(body.loads.body_force) == (b == turning));
    }
    CHECK(model.programme.A.isApprox(before.programme.A, 0));
    CHECK(model.programme.initial_gap == before.programme.initial_gap);
  }
}

// A long cylinder about its axis, held at both ends: (3 - 2 nu)/(1 - nu) rho omega^2 R^2 / 8 in its middle,
// wherever along the axis the centre is.
TEST_CASE("ex18.3 held out: a body of revolution about its own axis", "[ex18.3]") {
  SpinningScene spinning;
  Body& body = spinning.scene.bodies[0];
  body.mesh = block("block", {0, 0}, {50, 10}, 16, 2, MeshOrder::Quadratic);
  body.material = {210e3, 0.3, PlaneState::Axial, 1};
  body.supports = {symmetric("bottom"), symmetric("top")};
  spinning.spin = {Spin{rho, 2000, {0, GENERATE(0.0, 30.0)}}};
  const SolvedScene run = solve_spinning(spinning);
  const BodyModel& model = run.model.bodies[0];
  const StressArray stress =
      nodal_stress(model.mesh, model.element, model.material, run.solution.displacements[0]);
  const double middle = (3 - 2 * 0.3) / (1 - 0.3) / 8 * rho * 4e6 * 2500;
  CHECK(stress(0, 0) == Approx(middle).epsilon(5e-3));
  CHECK(stress(0, 3) == Approx(middle).epsilon(5e-3));
}

TEST_CASE("ex18.3 held out: what cannot spin is refused", "[ex18.3]") {
  const SpinningScene good = random_block(1);
  CHECK_NOTHROW(plan_spinning(good));
  const auto refused = [&good](const auto& change) {
    SpinningScene bad = good;
    change(bad);
    REQUIRE(present(bad));
    CHECK_THROWS_AS(plan_spinning(bad), ProblemError);
    return signorini_test::problem_message([&] { static_cast<void>(plan_spinning(bad)); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double wrong : {-1.0, nan, inf})
    CHECK(refused([&](SpinningScene& s) { s.spin[0]->density = wrong; }).find("'block'") !=
          std::string::npos);
  for (const double wrong : {nan, inf}) {
    refused([&](SpinningScene& s) { s.spin[0]->speed = wrong; });
    refused([&](SpinningScene& s) { s.spin[0]->centre.y() = wrong; });
  }
  refused([](SpinningScene& s) { s.spin.push_back(Spin{1, 1}); });
  refused([](SpinningScene& s) {
    s.scene.bodies[0].mesh.nodes.col(0).array() += 5;
    s.scene.bodies[0].material.state = PlaneState::Axial;
    s.scene.bodies[0].material.thickness = 1;
    s.spin[0]->centre = {1, 0};
  });
}
