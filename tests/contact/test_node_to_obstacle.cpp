#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/contact/node_to_obstacle.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/assembly.hpp"
#include "support/message.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::problem_message;

namespace {

Mesh plate(MeshOrder order = MeshOrder::Linear) {
  return block("block", {0, 0}, {4, 1}, 4, 1, order);
}

/// The pairs of 'bottom' or another boundary that can still move.
Gaps gaps_of(const Mesh& mesh, const Obstacle& obstacle, const std::vector<Support>& supports,
             double thickness = 1, const char* boundary = "bottom") {
  const Surface source{mesh, boundary};
  GapOptions options;
  options.n_nodes = mesh.n_nodes();
  options.depth.factor = thickness;
  return reduce(node_to_obstacle(source, obstacle, options), source,
                number_unknowns(mesh, supports));
}

std::string complaint(const Mesh& mesh, const Obstacle& obstacle,
                      const std::vector<Support>& supports) {
  return problem_message([&] { static_cast<void>(gaps_of(mesh, obstacle, supports)); });
}

}  // namespace

TEST_CASE("every free node of the boundary makes a pair, in walking order", "[gaps]") {
  const Gaps gaps = gaps_of(plate(), half_plane({0, -0.5}, {0, 1}), {});
  REQUIRE(gaps.pairs.node == std::vector<Index>{0, 1, 2, 3, 4});
  for (Index pair = 0; pair < 5; ++pair) {
    CHECK(gaps.pairs.position.row(pair) == Eigen::RowVector2d(static_cast<double>(pair), 0));
    CHECK(gaps.pairs.normal.row(pair) == Eigen::RowVector2d(0, 1));
    CHECK(gaps.pairs.initial_gap(pair) == 0.5);
  }
}

TEST_CASE("a row of A is minus the normal in the unknowns of its node", "[gaps][XuanLi2002-13]") {
  const Mesh mesh = plate();
  const Unknowns unknowns = number_unknowns(mesh, {fixed("right")});
  const Gaps gaps = gaps_of(mesh, disc({1, -5}, 4), {fixed("right")});
  REQUIRE(gaps.A.rows() == 4);
  REQUIRE(gaps.A.cols() == unknowns.count);
  for (Index pair = 0; pair < gaps.A.rows(); ++pair) {
    const Index node = gaps.pairs.node[static_cast<std::size_t>(pair)];
    Eigen::VectorXd row = Eigen::VectorXd::Zero(unknowns.count);
    for (int axis = 0; axis < 2; ++axis)
      row(unknowns.number(node, axis)) = -gaps.pairs.normal(pair, axis);
    CHECK((Eigen::VectorXd(gaps.A.row(pair).transpose()) - row).norm() == 0);
    CHECK(gaps.pairs.normal(pair, 1) > 0.7);  // out of the disc, up to the body
  }
}

TEST_CASE("the linear gap is the first-order change of the true one",
          "[gaps][derivative][LinEtAl-1]") {
  const Mesh mesh = plate();
  const Unknowns unknowns = number_unknowns(mesh, {});
  // Nodes lie on the profile, where its normal is exact; a circle's normal is exact everywhere.
  const Obstacle valley = profile(
      [](double x) { return 0.1 * x * (4 - x) * (x - 1) * (x - 2) * (x - 3); },
      [](double x) {
        const double h = 1e-6;
        const auto f = [](double s) { return 0.1 * s * (4 - s) * (s - 1) * (s - 2) * (s - 3); };
        return (f(x + h) - f(x - h)) / (2 * h);
      });
  signorini_test::Random random(3);
  for (const Obstacle& obstacle :
       {half_plane({0, -1}, {1, 4}), disc({1, -5}, 4), hole({2, 9}, 12), valley}) {
    CAPTURE(obstacle.name);
    const Gaps gaps = gaps_of(mesh, obstacle, {});
    NodeArray direction(mesh.n_nodes(), 2);
    for (Index k = 0; k < direction.size(); ++k) direction.data()[k] = random.uniform(-1, 1);
    Eigen::VectorXd u(unknowns.count);
    for (Index k = 0; k < u.size(); ++k) u(k) = direction(k / 2, k % 2);
    const Eigen::VectorXd rate = -(gaps.A * u);
    const double h = 1e-5;
    for (Index pair = 0; pair < rate.size(); ++pair) {
      const Index node = gaps.pairs.node[static_cast<std::size_t>(pair)];
      const Vector2d x = mesh.nodes.row(node).transpose();
      const Vector2d along = direction.row(node).transpose();
      const double difference =
          (obstacle.look(x + h * along).gap - obstacle.look(x - h * along).gap) / (2 * h);
      CHECK(rate(pair) == Approx(difference).epsilon(0).margin(1e-8));
    }
  }
}

TEST_CASE("the weights are the shares of the boundary", "[gaps]") {
  const Obstacle ground = half_plane({0, -1}, {0, 1});
  const Gaps linear = gaps_of(plate(), ground, {}, 0.5);
  Eigen::VectorXd share(5);
  share << 0.25, 0.5, 0.5, 0.5, 0.25;
  CHECK((linear.pairs.weight - share).norm() < 1e-14);
  const Gaps quadratic = gaps_of(plate(MeshOrder::Quadratic), ground, {});
  REQUIRE(quadratic.pairs.weight.size() == 9);
  CHECK(quadratic.pairs.weight(0) == Approx(1.0 / 6.0).epsilon(1e-14));
  CHECK(quadratic.pairs.weight(1) == Approx(4.0 / 6.0).epsilon(1e-14));
  CHECK(quadratic.pairs.weight(2) == Approx(2.0 / 6.0).epsilon(1e-14));
}

TEST_CASE("a held corner node is left out and the others keep their weights", "[gaps]") {
  const Gaps gaps = gaps_of(plate(), half_plane({0, -0.5}, {0, 1}), {fixed("left")});
  CHECK(gaps.pairs.node == std::vector<Index>{1, 2, 3, 4});
  CHECK(gaps.pairs.weight.sum() == Approx(3.5).epsilon(1e-14));
  CHECK(gaps.pairs.weight(0) == Approx(1).epsilon(1e-14));
}

TEST_CASE("a node held along the obstacle only still makes a pair", "[gaps]") {
  const Gaps gaps = gaps_of(plate(), half_plane({0, -0.5}, {0, 1}), {symmetric("left")});
  CHECK(gaps.pairs.node.size() == 5);
}

TEST_CASE("a given displacement moves the gap", "[gaps]") {
  const Mesh mesh = plate();
  // Normal (0.6, 0.8): the given x-displacement 0.5 of the left side opens its gap by 0.3.
  const Obstacle slope = half_plane({0, -1}, {0.6, 0.8});
  const Gaps moved = gaps_of(mesh, slope, {prescribed("left", Axis::X, 0.5)});
  const Gaps still = gaps_of(mesh, slope, {});
  CHECK(moved.pairs.initial_gap(0) == Approx(still.pairs.initial_gap(0) + 0.3).epsilon(1e-14));
  CHECK(moved.pairs.initial_gap.tail(4) == still.pairs.initial_gap.tail(4));
  CHECK(moved.A.row(0).nonZeros() == 1);
}

TEST_CASE("contact on a boundary that supports hold is refused by name", "[gaps]") {
  const Obstacle ground = half_plane({0, -0.5}, {0, 1});
  for (const Support& support : {fixed("bottom"), symmetric("bottom")})
    CHECK_THAT(complaint(plate(), ground, {support}),
               ContainsSubstring("contact boundary 'bottom' is also held by a support"));
}

TEST_CASE("a node that supports hold across the obstacle makes no pair, and is told", "[gaps]") {
  const Gaps gaps = gaps_of(plate(), half_plane({0, 0.25}, {0, 1}), {fixed("left")});
  CHECK(gaps.pairs.node == std::vector<Index>{1, 2, 3, 4});
  CHECK(gaps.kept == std::vector<Index>{1, 2, 3, 4});
  CHECK(gaps.dropped == std::vector<Index>{0});
}

TEST_CASE("an unknown boundary, a gap or a profile that is not finite are named", "[gaps]") {
  CHECK_THAT(problem_message([&] {
               static_cast<void>(gaps_of(plate(), half_plane({0, 0}, {0, 1}), {}, 1, "belly"));
             }),
             ContainsSubstring("no boundary 'belly'"));
  CHECK_THAT(
      complaint(plate(), profile([](double x) { return 1 / (x - 3); }, [](double) { return 0.0; }),
                {}),
      ContainsSubstring("at x = 3"));
  const Obstacle odd{"odd", [](const Vector2d& x) {
                       return ObstacleContact{std::sqrt(1 - x.x()), Vector2d(0, 1)};
                     }};
  CHECK_THAT(complaint(plate(), odd, {}),
             ContainsSubstring("obstacle 'odd'") && ContainsSubstring("the gap at node 2"));
}
