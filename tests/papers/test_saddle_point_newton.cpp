#include "catch_compat.hpp"
#include "papers/saddle_point_newton.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

using Form = SaddlePointForm;

QuadraticProgramme programme(const Scene& scene) {
  Ledger ledger;
  return build(scene, ledger).programme;
}

SaddlePointSolution solved(const QuadraticProgramme& programme, Form form) {
  SaddlePointOptions options;
  options.form = form;
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
    for (const Form form : {Form::OneUnit, Form::AsPrinted}) {
      const Scene scene = cantilever(element, 40, 4);
      const SaddlePointSolution saddle = solved(programme(scene), form);
      const VectorXd force = solve(scene).contact.force;
      CAPTURE(element, form == Form::OneUnit, saddle.report.iterations);
      REQUIRE(saddle.report.status == SolveStatus::Solved);
      CHECK((saddle.solution.force - force).norm() <= 1e-11 * force.norm());
      CHECK(saddle.report.iterations <= 25);
      CHECK(saddle.report.history.size() == static_cast<std::size_t>(saddle.report.iterations));
      CHECK(saddle.report.history.back().residual <= 1e-9);
    }
}

TEST_CASE("units change the path of the literal form only", "[saddle-point]") {
  const auto iterations = [](const Units& units, Form form) {
    return solved(programme(cantilever("q4", 40, 4, 3.6, units)), form).report.iterations;
  };
  const auto reference = iterations({}, Form::OneUnit);
  for (const Units& units : {Units{1e-3, 1}, Units{1e3, 1e-3}, Units{1e-2, 1e3}})
    CHECK(iterations(units, Form::OneUnit) == reference);
  CHECK(iterations({1e3, 1e-3}, Form::AsPrinted) != iterations({}, Form::AsPrinted));
}

TEST_CASE("a body that floats is solved where it touches, and refused where all pairs are open",
          "[saddle-point][closed-form]") {
  const SaddlePointSolution touching = solved(beam(0), Form::OneUnit);
  REQUIRE(touching.report.status == SolveStatus::Solved);
  CHECK((touching.solution.force - Vector2d(3, 3)).norm() <= 1e-12);
  CHECK((touching.solution.displacement - Vector3d(0, -0.5, 0)).norm() <= 1e-12);
  for (const Form form : {Form::OneUnit, Form::AsPrinted})
    CHECK(solved(beam(1), form).report.status == SolveStatus::Breakdown);
}

TEST_CASE("a limit is a limit, and nothing to do is done", "[saddle-point]") {
  SaddlePointOptions options;
  options.iteration_limit = 2;
  const SaddlePointSolution short_of =
      saddle_point_newton(programme(cantilever("q4", 40, 4)), options);
  CHECK(short_of.report.status == SolveStatus::IterationLimit);
  CHECK(short_of.report.iterations == 2);
  QuadraticProgramme rest = beam(1);
  rest.load.setZero();
  CHECK(solved(rest, Form::OneUnit).report.status == SolveStatus::Solved);
  CHECK(solved(rest, Form::OneUnit).report.iterations == 0);
}

TEST_CASE("a tolerance is what the certificate then holds to", "[saddle-point]") {
  const QuadraticProgramme cantilever_programme = programme(cantilever("q4", 40, 4));
  const Eigen::Index full = solved(cantilever_programme, Form::OneUnit).report.iterations;
  SaddlePointOptions options;
  options.tolerance = 1e-1;  // so rough that fewer steps reach it
  const SaddlePointSolution rough = saddle_point_newton(cantilever_programme, options);
  CHECK(rough.report.status == SolveStatus::Solved);
  CHECK(rough.report.iterations < full);
  const Certificate certificate = certify(cantilever_programme, rough.solution);
  CHECK(certificate.holds(options.tolerance));
  CHECK_FALSE(certificate.holds());
  SECTION("as printed it stops at |F|, which is no certificate") {
    options.form = Form::AsPrinted;
    CHECK(saddle_point_newton(cantilever_programme, options).report.status ==
          SolveStatus::Breakdown);
  }
  SECTION("what rounding cannot reach is not solved") {
    options.tolerance = 0;
    CHECK(saddle_point_newton(cantilever_programme, options).report.status ==
          SolveStatus::Breakdown);
  }
}
