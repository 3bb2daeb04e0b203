// What chapter 10 says of one Gauss point, by hand, and of the whole system (42) with friction.
#include <algorithm>
#include <cmath>

#include "../chapters/ch10_gauss_points/one_point.hpp"
#include "../chapters/ch10_gauss_points/whole_system.hpp"
#include "../chapters/ch11_hertz/as_printed.hpp"
#include "catch_compat.hpp"
#include "signorini/core/random.hpp"
#include "signorini/pairing/gauss_points.hpp"

using namespace ch10;

namespace {

const double root = 1 / std::sqrt(3.0);
// A cell of width 1 on one of width 2; the target lies to the left of its edge from 3 to 4.
const FourNodes X0 = (FourNodes() << 0.75, 1.1, 1.75, 1.2, 2, 1, 0, 1).finished();

FourNodes random_nodes(Random& random, double size) {
  FourNodes U;
  for (Index i = 0; i < 8; ++i) U(i / 2, i % 2) = random.uniform(-size, size);
  return U;
}

double moment(const FourNodes& X, const FourNodes& forces) {
  return X.col(0).dot(forces.col(1)) - X.col(1).dot(forces.col(0));
}

}  // namespace

TEST_CASE("a Gauss point is where the moved nodes put it: X = X0 + U", "[LinEtAl-32][exact]") {
  FourNodes U = FourNodes::Zero();
  U.row(0) << 0.25, 0.5;
  U.row(1) << 0.75, 0.25;
  const PointOverEdge at = point_over_edge(X0, U, 0.5);  // N = 1/4, 3/4
  CHECK(at.x.x() == Approx(0.25 * 1.0 + 0.75 * 2.5).epsilon(1e-14));
  CHECK(at.x.y() == Approx(0.25 * 1.6 + 0.75 * 1.45).epsilon(1e-14));
  const double turn = 0.7;  // all four nodes turn: so does the point, and the gap stays
  const Eigen::Matrix2d R =
      (Eigen::Matrix2d() << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn))
          .finished();
  const PointOverEdge before = point_over_edge(X0, FourNodes::Zero(), root);
  const PointOverEdge after = point_over_edge(X0, X0 * R.transpose() - X0, root);
  CHECK((after.x - R * before.x).norm() < 1e-14);
  CHECK((after.n - R * before.n).norm() < 1e-14);
  CHECK(after.gap == Approx(before.gap).epsilon(1e-13));
}

TEST_CASE("the place, the gap and the forces of a point are those of the library on moved meshes",
          "[LinEtAl-32][LinEtAl-33][LinEtAl-35][LinEtAl-36][LinEtAl-38][LinEtAl-40]") {
  Random random(1);
  for (int sample = 0; sample < 20; ++sample) {
    const FourNodes U = random_nodes(random, 0.1), X = X0 + U;
    Mesh source = block("source", {0.75, 1}, {1, 1}, 1, 1),
         target = block("target", {0, 0}, {2, 1}, 1, 1);
    const std::vector<Index> on = boundary_nodes(source, "bottom");
    const std::vector<Index> below = boundary_nodes(target, "top");
    for (Index k = 0; k < 2; ++k) {
      source.nodes.row(on[static_cast<std::size_t>(k)]) = X.row(k);
      target.nodes.row(below[static_cast<std::size_t>(k)]) = X.row(2 + k);
    }
    GapOptions options;
    options.n_nodes = source.n_nodes() + target.n_nodes();
    options.sliding = true;
    const Pairs pairs =
        gauss_points({source, "bottom", 0}, {target, "top", source.n_nodes()}, options);
    REQUIRE(pairs.weight.size() == 2);
    const Index row = (pairs.position.row(0).x() < pairs.position.row(1).x()) ? 0 : 1;
    const PointOverEdge at = point_over_edge(X0, U, -root);
    CHECK((pairs.position.row(row).transpose() - at.x).norm() < 1e-14);
    CHECK(pairs.initial_gap(row) == Approx(at.gap).margin(1e-14));
    CHECK(pairs.weight(row) == Approx(at.share).epsilon(1e-14));
    const FourNodes forces = forces_of_point(at, 3, 0.5);
    for (Index k = 0; k < 4; ++k) {
      const std::size_t own = static_cast<std::size_t>(k % 2);
      const Index node = k < 2 ? on[own] : source.n_nodes() + below[own];
      for (Index axis : {0, 1})
        CHECK(at.share * (3 * pairs.opening.coeff(row, 2 * node + axis) +
                          0.5 * pairs.sliding.coeff(row, 2 * node + axis)) ==
              Approx(forces(k, axis)).margin(1e-14));
    }
  }
}

TEST_CASE("a pressure of 3 and a shear of 1 at the point of the chapter",
          "[LinEtAl-33][LinEtAl-34][LinEtAl-35][LinEtAl-36][LinEtAl-38][LinEtAl-39][LinEtAl-40]"
          "[LinEtAl-41][closed-form]") {
  const FourNodes flat = (FourNodes() << 0.75, 1, 1.75, 1, 2, 1, 0, 1).finished();
  const PointOverEdge at = point_over_edge(flat, FourNodes::Zero(), -root);
  CHECK(at.gap == 0);
  const FourNodes fn = forces_of_point(at, 3, 0), tau = forces_of_point(at, 0, 1);
  CHECK(fn.col(0).norm() == 0);
  CHECK(tau.col(1).norm() == 0);
  CHECK(fn(0, 1) == Approx(0.75 * (1 + root)).epsilon(1e-14));  // l_12/2 * 3 * N_1
  CHECK(tau(0, 0) == Approx(0.25 * (1 + root)).epsilon(1e-14));
  CHECK(fn(2, 1) + fn(3, 1) == Approx(-1.5).epsilon(1e-14));
  CHECK(tau(2, 0) + tau(3, 0) == Approx(-0.5).epsilon(1e-14));
  CHECK(fn(2, 1) == Approx(-1.5 * at.x.x() / 2).epsilon(1e-14));
  CHECK(moment(flat, fn) == Approx(0).margin(1e-14));
}

TEST_CASE(
    "the row of the gap is the derivative of the gap at any displacement, and K lacks that of the "
    "forces",
    "[LinEtAl-31][LinEtAl-32][LinEtAl-37]") {
  Random random(2);
  const double h = 1e-6;
  const FourNodes U = random_nodes(random, 0.3);
  const FourNodes row = forces_of_point(point_over_edge(X0, U, root), 1, 0) /
                        point_over_edge(X0, U, root).share;  // n N_i, as b_1 and a_1 have it
  double turned = 0;
  for (Index i = 0; i < 8; ++i) {
    FourNodes step = FourNodes::Zero();
    step(i / 2, i % 2) = h;
    const PointOverEdge up = point_over_edge(X0, U + step, root);
    const PointOverEdge down = point_over_edge(X0, U - step, root);
    CHECK((up.gap - down.gap) / (2 * h) == Approx(row(i / 2, i % 2)).margin(1e-8));
    turned = std::max(turned,
                      (forces_of_point(up, 1, 0) - forces_of_point(down, 1, 0)).norm() / (2 * h));
  }
  CHECK(turned > 0.1);  // a pressure of 1 adds this to the stiffness; (31) has K alone
}

TEST_CASE(
    "(42) with friction and all displacements has the forces of the library, and either meaning of "
    "f_n",
    "[LinEtAl-31][LinEtAl-37][LinEtAl-42]") {
  for (const double side : {0.3, 1.0}) {
    WholeSystem whole = whole_system(sheared_blocks(side));
    const Index n = whole.run.model.programme.load.size(), m = whole.normal.cols();
    const WholeRun run = newton(whole);
    CAPTURE(side, run.residuals.size(), run.residuals.back());
    REQUIRE(run.solved);
    const ContactState& contact = whole.run.solution.contact;
    const VectorXd weight = whole.run.model.pairs.weight;
    CHECK((run.x.segment(n, m) - contact.force.cwiseQuotient(weight)).norm() < 1e-8);
    CHECK((run.x.segment(n + m, m) - contact.friction.cwiseQuotient(weight)).norm() < 1e-8);
    CHECK((run.x.segment(n + 2 * m, m) - run.x.tail(m) - contact.slip).norm() < 1e-12);
    CHECK((run.x.head(n) - whole.run.solution.refined.displacement).norm() < 1e-11);
    whole.reading = NormalTraction::Stress;
    const WholeRun image = newton(whole);
    REQUIRE(image.solved);
    // The same steps up to rounding, as fullPivLu() may take another of two equal pivots: perhaps one more, or one less.
    CHECK(image.residuals.size() <= run.residuals.size() + 1);
    CHECK(run.residuals.size() <= image.residuals.size() + 1);
    CHECK((image.x.segment(n, 2 * m) + run.x.segment(n, 2 * m)).norm() < 1e-9);
    CHECK((image.x.segment(n + 2 * m, m) - run.x.tail(m)).norm() < 1e-12);
  }
}

TEST_CASE("the Jacobian of the whole system is that of its equations", "[LinEtAl-31][LinEtAl-42]") {
  WholeSystem whole = whole_system(sheared_blocks(0.3));
  for (const auto reading : {NormalTraction::Pressure, NormalTraction::Stress}) {
    whole.reading = reading;
    Random random(3);
    VectorXd x = newton(whole).x, way(x.size());
    for (double& at : x) at += random.uniform(0.5, 1);  // away from kinks
    for (double& at : way) at = random.uniform(-1, 1);
    const double h = 1e-7;
    const VectorXd rise =
        (evaluate(whole, x + h * way).residual - evaluate(whole, x - h * way).residual) / (2 * h);
    CHECK((evaluate(whole, x).jacobian * way - rise).norm() < 1e-5 * rise.norm());
  }
}

TEST_CASE(
    "the method as printed, without friction: one point on an edge has the forces of the library",
    "[LinEtAl-31][LinEtAl-37][LinEtAl-42][hertz]") {
  const HertzCase one = example_with(1, false);
  const PrintedRun run = run_as_printed(one, {});
  REQUIRE(run.residuals.back() < printed_residual);
  CHECK(run.steps() > 0);
  CHECK(run.steps() <= 30);
  const SolvedScene library = signorini::solved(hertz_scene(one), "disc");
  const VectorXd pressure = library.solution.pressure;
  CHECK((run.pressure - pressure).norm() < 1e-8 * pressure.norm());
  CHECK(run.gap.minCoeff() > -1e-9);
}
