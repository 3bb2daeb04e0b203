#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex11_4;

// Meshes of halved cells with these orders between neighbours.
static std::vector<Mesh> of_orders(const std::vector<double>& orders, double error = 1) {
  std::vector<Mesh> meshes = {{1, error}};
  for (const double order : orders)
    meshes.push_back({meshes.back().h / 2, meshes.back().error * std::pow(0.5, order)});
  return meshes;
}

TEST_CASE("ex11.4 held out: uneven steps of h, and neither unit matters", "[ex11.4]") {
  for (const double length : {1e-6, 1.0, 1e6})
    for (const double unit : {-1e9, 1e-9}) {
      std::vector<Mesh> meshes;
      for (const double h : {1.0, 0.7, 0.3, 0.26, 0.1})
        meshes.push_back({h * length, unit * std::pow(h, 1.3)});
      const Fit fit = fit_of_order(meshes);
      CHECK(fit.order == Approx(1.3).epsilon(1e-10));
      CHECK(fit.count == 5);
    }
}

TEST_CASE("ex11.4 held out: orders that drift belong together only as far as the spread",
          "[ex11.4]") {
  const Fit drift = fit_of_order(of_orders({1.0, 1.2, 1.4, 1.6, 1.8}));
  CHECK(drift.count == 3);
  CHECK(drift.first == 3);  // of several rows of one length the finest
  CHECK(drift.order == Approx(1.7).epsilon(1e-10));
  CHECK(fit_of_order(of_orders({1.0, 1.2, 1.4, 1.6, 1.8}), 1).count == 6);
  CHECK(fit_of_order(of_orders({2, 2, 2, 1, 1}), 0.1).first == 0);
  CHECK(fit_of_order(of_orders({2, 2, 2, 1, 1}), 0.1).count == 4);
  CHECK(fit_of_order(of_orders({2, 2, 1, 1}), 0.1).first == 2);
}

// h^2 - 1e-3 is zero between two meshes: errors before and behind it are no one's order.
TEST_CASE("ex11.4 held out: a change of sign is not passed", "[ex11.4]") {
  std::vector<Mesh> meshes;
  for (int k = 0; k < 12; ++k) meshes.push_back({std::pow(0.5, k), std::pow(0.25, k) - 1e-3});
  const Fit fit = fit_of_order(meshes);
  CHECK(fit.first == 0);
  CHECK(fit.count >= 3);
  CHECK(fit.count <= 5);  // 4^-5 is less than 1e-3
  CHECK(fit.order == Approx(2).margin(0.1));
  CHECK(fit_of_order({{4, 16}, {2, -4}, {1, 1}}).count == 0);
  CHECK(fit_of_order({{4, -16}, {2, -4}, {1, -1}}).count == 3);
}

TEST_CASE("ex11.4 held out: errors of zero, errors that grow and short rows have no order",
          "[ex11.4]") {
  CHECK(fit_of_order({{4, 1}, {2, 0}, {1, 0}}).count == 0);
  CHECK(fit_of_order({{4, 1}, {2, 1}, {1, 1}}).count == 0);
  CHECK(fit_of_order({{4, 1}, {2, 2}, {1, 4}}).count == 0);
  CHECK(fit_of_order({{4, 4}, {2, 1}}).count == 0);
  CHECK(fit_of_order({}).count == 0);
  CHECK(fit_of_order({{4, 4}, {2, 1}}).order == 0);
}

TEST_CASE("ex11.4 held out: what is no row of meshes is refused", "[ex11.4]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double much = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(fit_of_order({{1, 1}, {2, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(fit_of_order({{1, 1}, {1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(fit_of_order({{1, 1}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(fit_of_order({{none, 1}, {0.1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(fit_of_order({{much, 1}, {0.1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(fit_of_order({{1, none}}), std::invalid_argument);
  CHECK_THROWS_AS(fit_of_order({{1, 1}, {0.5, much}}), std::invalid_argument);
  CHECK_THROWS_AS(fit_of_order({{1, 1}}, -0.1), std::invalid_argument);
  CHECK_THROWS_AS(fit_of_order({{1, 1}}, none), std::invalid_argument);
}
