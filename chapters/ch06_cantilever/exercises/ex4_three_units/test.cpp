#include <algorithm>
#include <stdexcept>

#include "../chapters/ch06_cantilever/scene.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex6_4::closed_nodes;
using ex6_4::Rows;
using signorini::ContactProblem;

// The same problem with other units: numbers of lengths and forces are so many times as large.
static ContactProblem in_units(const ContactProblem& problem, double length, double force) {
  return {problem.compliance * (length / force), problem.free_gap * length};
}

TEST_CASE("ex6.4 the beam in five pairs of units", "[ex6.4]") {
  const signorini::SolvedScene beam = ch06::solve_cantilever(ch06::paper, "q4_incompatible", 50);
  const ContactProblem& problem = beam.condensed.problem;
  REQUIRE(beam.solution.contact.active().size() == 9);
  const auto [length, force, units] = GENERATE(table<double, double, const char*>({
      {1, 1, "cm, kN"},
      {10, 1e3, "mm, N"},
      {1e-2, 1e3, "m, N"},
      {1e-5, 1e-9, "km, TN"},
      {1e7, 1e6, "nm, mN"},
  }));
  CAPTURE(units);
  CHECK(closed_nodes(in_units(problem, length, force)) == beam.solution.contact.active());
}

// Six pairs press and six just touch: their gaps and forces are nothing but rounding.
TEST_CASE("ex6.4 what just touches has no force, in any unit", "[ex6.4]") {
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(12, 0.05, 0.95);
  Eigen::MatrixXd G(12, 12);
  for (Eigen::Index i = 0; i < 12; ++i)
    for (Eigen::Index j = 0; j < 12; ++j)
      G(i, j) = std::min(x(i), x(j)) * (1.1 - std::max(x(i), x(j)));
  const double length = GENERATE(1.0, 1e-9 / 3, 1e11 / 3);
  CAPTURE(length);
  for (int sample = 1; sample <= 20; ++sample) {
    CAPTURE(sample);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(12);
    force.head(6) << 0.3, 0.7, 0.1, 0.9, 0.2, 0.6;
    force(sample % 6) += 1.0 / sample;
    CHECK(closed_nodes(in_units({G, -G * force}, length, 1)) == Rows{0, 1, 2, 3, 4, 5});
  }
}

TEST_CASE("ex6.4 sets that go round are no answer", "[ex6.4]") {
  const ContactProblem circles{(Eigen::Matrix3d() << 4, -6, -4, -6, 10, 8, -4, 8, 9).finished(),
                               Eigen::Vector3d(3, -4, -1)};
  CHECK_THROWS_AS(closed_nodes(circles), std::runtime_error);
}
