#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex11_4;

// Ten meshes, each twice as fine as the one before.
template <class Error>
static std::vector<Mesh> halved(Error error) {
  std::vector<Mesh> meshes;
  for (int k = 0; k < 10; ++k) meshes.push_back({std::pow(0.5, k), error(std::pow(0.5, k))});
  return meshes;
}

TEST_CASE("ex11.4 a clean row is used whole", "[ex11.4]") {
  const Fit fit = fit_of_order(halved([](double h) { return -3 * h * h; }));
  CHECK(fit.order == Approx(2).epsilon(1e-12));
  CHECK(fit.first == 0);
  CHECK(fit.count == 10);
}

TEST_CASE("ex11.4 coarse meshes that know higher powers are left out", "[ex11.4]") {
  const Fit fit = fit_of_order(halved([](double h) { return h * h + 30 * std::pow(h, 5); }));
  CHECK(fit.order == Approx(2).margin(0.1));
  CHECK(fit.first > 0);
  CHECK(fit.first + fit.count == 10);
}

TEST_CASE("ex11.4 errors that end at another number are left out", "[ex11.4]") {
  const Fit fit = fit_of_order(halved([](double h) { return h * h + 1e-4; }));
  CHECK(fit.order == Approx(2).margin(0.1));
  CHECK(fit.first == 0);
  CHECK(fit.count < 9);
  CHECK(fit.count > 4);
}

// The trapezoidal rule has the order 2, but not for an ellipse, whose slope is infinite at its ends.
TEST_CASE("ex11.4 the load of an ellipse of pressure by trapezia", "[ex11.4]") {
  std::vector<Mesh> meshes;
  for (int cells = 4; cells <= 256; cells *= 2) {
    const double h = 2.0 / cells;
    double sum = 0;
    for (int k = 1; k < cells; ++k) sum += h * std::sqrt(1 - std::pow(k * h - 1, 2));
    meshes.push_back({h, sum - std::acos(-1.0) / 2});
  }
  const Fit fit = fit_of_order(meshes);
  CHECK(fit.order == Approx(1.5).margin(0.02));
  CHECK(fit.count == 7);
}

// What the chapters have, in percent; cells are halved from mesh to mesh.
TEST_CASE("ex11.4 rows of the book", "[ex11.4]") {
  const auto row = [](double coarse, double middle, double fine) {
    return fit_of_order({{1, coarse}, {0.5, middle}, {0.25, fine}});
  };
  CHECK(row(0.0942, 0.0212, 0.0050).order ==
        Approx(2).margin(0.2));  // chapter 12, disc between plates
  CHECK(row(0.0942, 0.0212, 0.0050).count == 3);
  CHECK(row(0.0416, -0.0313, -0.0475).count == 0);  // the same meshes against (44)
  CHECK(row(-0.082, -0.092, -0.007).count == 0);    // chapter 11, half-width
}

TEST_CASE("ex11.4 sizes that do not fall are refused", "[ex11.4]") {
  CHECK_THROWS_AS(fit_of_order({{1, 1}, {2, 1}}), std::invalid_argument);
}
