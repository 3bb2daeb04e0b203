#include "catch_compat.hpp"
#include "signorini/complementarity/saddle_point_newton.hpp"
#include "signorini/scene/solved.hpp"
#include "support/cantilever.hpp"

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

QuadraticProgramme programme(const Scene& scene) {
  Ledger ledger;
  return build(scene, ledger).programme;
}

SaddlePointSolution solved(const QuadraticProgramme& programme, bool scaled) {
  SaddlePointOptions options;
  options.scaled = scaled;
  return saddle_point_newton(programme, options);
}

/// Three nodes that move up and down; only bending strains them, so two rigid modes are free. Supports
/// under the ends, `gap` below; the weight 6 on the middle.
QuadraticProgramme beam(double gap) {
  const Vector3d bending(1, -2, 1);
  QuadraticProgramme programme;
  programme.stiffness = MatrixXd(3 * bending * bending.transpose()).sparseView();
  programme.load = Vector3d(0, -6, 0);
  programme.A = (MatrixXd(2, 3) << -1, 0, 0, 0, 0, -1).finished().sparseView();
  programme.initial_gap = Vector2d(gap, gap);
  return programme;
}

}  // namespace

TEST_CASE("the saddle point has the forces of the condensed problem",
          "[saddle-point][LinEtAl-28][LinEtAl-30][LinEtAl-31]") {
  for (const char* element : {"q4", "q8"})
    for (const bool scaled : {true, false}) {
      const Scene scene = cantilever(element, 40, 4);
      const SaddlePointSolution saddle = solved(programme(scene), scaled);
      const VectorXd force = solve(scene).contact.force;
      CAPTURE(element, scaled, saddle.report.iterations);
      REQUIRE(saddle.report.status == Status::Solved);
      CHECK((saddle.solution.force - force).norm() <= 1e-11 * force.norm());
      CHECK(saddle.report.iterations <= 25);
      CHECK(saddle.report.history.size() == static_cast<std::size_t>(saddle.report.iterations));
      CHECK(saddle.report.history.back().residual <= 1e-9);
    }
}

TEST_CASE("units change the path of the literal form only", "[saddle-point]") {
  const auto iterations = [](const Units& units, bool scaled) {
    return solved(programme(cantilever("q4", 40, 4, 3.6, units)), scaled).report.iterations;
  };
  const auto reference = iterations({}, true);
  for (const Units& units : {Units{1e-3, 1}, Units{1e3, 1e-3}, Units{1e-2, 1e3}})
    CHECK(iterations(units, true) == reference);
  CHECK(iterations({1e3, 1e-3}, false) != iterations({}, false));
}

TEST_CASE("a body that floats is solved where it touches, and refused where all pairs are open",
          "[saddle-point][closed-form]") {
  const SaddlePointSolution touching = solved(beam(0), true);
  REQUIRE(touching.report.status == Status::Solved);
  CHECK((touching.solution.force - Vector2d(3, 3)).norm() <= 1e-12);
  CHECK((touching.solution.displacement - Vector3d(0, -0.5, 0)).norm() <= 1e-12);
  for (const bool scaled : {true, false})
    CHECK(solved(beam(1), scaled).report.status == Status::Breakdown);
}

TEST_CASE("a limit is a limit, and nothing to do is done", "[saddle-point]") {
  SaddlePointOptions options;
  options.iteration_limit = 2;
  const SaddlePointSolution short_of =
      saddle_point_newton(programme(cantilever("q4", 40, 4)), options);
  CHECK(short_of.report.status == Status::IterationLimit);
  CHECK(short_of.report.iterations == 2);
  QuadraticProgramme rest = beam(1);
  rest.load.setZero();
  CHECK(solved(rest, true).report.status == Status::Solved);
  CHECK(solved(rest, true).report.iterations == 0);
}
