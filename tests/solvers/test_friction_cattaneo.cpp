// Partial slip of a cylinder [\ref Johnson1985], section 7.2: with a = 1 and p0 = 1/2, the stick zone is
// |x| < c = sqrt(1 - Q/(mu P)), and the traction mu p0 (sqrt(1 - x^2) - c sqrt(1 - x^2/c^2)).
#include <cmath>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "closed_form/cattaneo.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/friction.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

constexpr Index n = 200;
constexpr double h = 2.6 / n;

double position(Index i) { return -1.3 + (static_cast<double>(i) + 0.5) * h; }

double half_ellipse(double x, double width) {
  return std::abs(x) < width ? width * std::sqrt(1 - x * x / (width * width)) : 0;
}

/// Half the width of all pairs with a status.
double half_width(const ContactState& state, bool stick_only) {
  double width = 0;
  for (const ContactStatus contact_status : state.contact_status)
    if (contact_status == ContactStatus::Stick ||
        (!stick_only && contact_status != ContactStatus::Open))
      width += h / 2;
  return width;
}

}  // namespace

TEST_CASE("a cylinder in partial slip: stick zone and traction of Cattaneo and Mindlin",
          "[friction][closed-form][LinEtAl-17][LinEtAl-18]") {
  for (const double part : {0.1, 0.6, 0.95}) {
    const double mu = 0.3;
    const PartialSlip slip{1, 0.5, mu};
    const double c = std::sqrt(1 - part);
    const ContactState state =
        solve_with_proofs(cylinder(n, mu, part), find_solver("primal_dual_active_set"));
    CAPTURE(part);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(certify(cylinder(n, mu, part), state).worst() <= 1e-14);
    CHECK(half_width(state, true) == Approx(c).margin(h));  // an element more or less
    CHECK(half_width(state, false) == Approx(1).margin(h));
    double pressure_error = 0;
    double traction_error = 0;
    for (Index i = 0; i < n; ++i) {
      const double x = position(i);
      const double exact = slip_traction(slip, part * slip_limit(slip), x);
      pressure_error += std::pow(state.force(i) / h / 0.5 - half_ellipse(x, 1), 2);
      traction_error += std::pow((state.friction(i) / h - exact) / (0.5 * mu), 2);
    }
    // The square roots at the ends of both zones cost h^(3/2): 0.0015 with 200 elements.
    CHECK(std::sqrt(pressure_error / n) <= 2e-3);
    CHECK(std::sqrt(traction_error / n) <= 2e-3);
    CHECK(state.friction.sum() == Approx(part * mu * state.force.sum()).epsilon(1e-13));
    CHECK((state.slip.array() <= 0).all());  // everything that slides moves with the push
  }
}

TEST_CASE("every method finds the same partial slip, the split as printed does not", "[friction]") {
  const ContactProblem problem = cylinder(100, 0.3, 0.6);
  const ContactState first = solve_with_proofs(problem, friction_solvers().front());
  for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister",
                           "friction_split", "friction_split_literal"}) {
    const Solver& solver = find_solver(name);
    const ContactState state = solve_with_proofs(problem, solver);
    CAPTURE(solver.name, state.reason);
    if (std::string(solver.name) == "friction_split_literal") {
      CHECK(state.report.status == SolveStatus::Breakdown);
      CHECK(state.reason.find("u+ and u- enter only by their difference") != std::string::npos);
      continue;
    }
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.contact_status == first.contact_status);
    CHECK((forces(state) - forces(first)).norm() <= 1e-12 * forces(first).norm());
    // Pivots go one by one; all others settle in few steps.
    CHECK(state.report.iterations <= (std::string(solver.name) == "lemke" ? 300 : 12));
  }
}

TEST_CASE("tiny and huge coefficients of friction: the same stick zone, within 25 steps",
          "[friction][hard]") {
  // Without coupling, tau / mu depends on Q / (mu P) alone.
  const ContactState plain = solve_with_proofs(cylinder(n, 0.3, 0.6), friction_solvers().front());
  for (const double mu : {1e-6, 1e4}) {
    const ContactState state = solve_with_proofs(cylinder(n, mu, 0.6), friction_solvers().front());
    CAPTURE(mu);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.report.iterations <= 25);
    CHECK(state.contact_status == plain.contact_status);
    CHECK((state.friction / mu - plain.friction / 0.3).norm() <=
          1e-10 * plain.friction.norm() / 0.3);
  }
}

TEST_CASE("a push beyond mu P finds no equilibrium, and the way out is shown",
          "[friction][floating]") {
  const ContactProblem problem = cylinder(60, 0.3, 1 + 1e-9);
  for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister",
                           "friction_split", "friction_split_literal"}) {
    const Solver& solver = find_solver(name);
    const ContactState state = solve_with_proofs(problem, solver);
    CAPTURE(solver.name);
    CHECK(state.report.status != SolveStatus::Solved);
    if (std::string(solver.name) == "friction_split_literal") continue;
    REQUIRE(state.report.status == SolveStatus::Infeasible);
    CHECK(state.reason.find("no contact forces") != std::string::npos);
    REQUIRE(state.unbounded_direction.size() == 2);
    // The motion opens each gap by mu times its slip, and the load works along it.
    CHECK(state.unbounded_direction(0) >=
          0.3 * std::abs(state.unbounded_direction(1)) * (1 - 1e-12));
    CHECK(problem.resultant.dot(state.unbounded_direction) < 0);
  }
  // Just below, and with cohesion to take up the rest, it holds.
  CHECK(solve_with_proofs(cylinder(60, 0.3, 1 - 1e-9), friction_solvers().front()).report.status ==
        SolveStatus::Solved);
  ContactProblem glued = problem;
  glued.law.cohesion.setConstant(1e-3);
  const ContactState state = solve_with_proofs(glued, friction_solvers().front());
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(certify(glued, state).holds());
}
