// Problems of other people: tests/data/siconos_fc2d, see tests/data/SOURCES.md.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "addons/certified/solve_with_proofs.hpp"
#include "addons/files/problem_file.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/friction.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

ContactProblem from_file(const std::string& name) {
  const ProblemFile file =
      read_problem(std::string(SIGNORINI_TEST_DATA) + "/siconos_fc2d/" + name + ".dat");
  return std::get<std::vector<FiledProblem>>(file).front().problem;
}

/// Largest of |r_n - max(0, r_n - u_n)| and |r_t - (r_t - u_t cut off at mu r_n)|, in the units of the file.
double natural_map(const ContactProblem& problem, const ContactState& state) {
  double worst = 0;
  const Eigen::VectorXd u = free_movement(problem) + problem.compliance * forces(state);
  const Eigen::Index n = problem.free_gap.size();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double normal = state.force(i);
    const double tangential = state.friction(i);
    const double bound = problem.law.coefficient(i) * std::max(0.0, normal);
    worst = std::max({worst, std::abs(normal - std::max(0.0, normal - u(i))),
                      std::abs(tangential - std::clamp(tangential - u(n + i), -bound, bound))});
  }
  return worst;
}

/// How many pairs carry more than rounding, and how many of these slide.
std::pair<int, int> closed_and_sliding(const ContactState& state) {
  int closed = 0;
  int sliding = 0;
  for (Eigen::Index i = 0; i < state.force.size(); ++i) {
    if (state.force(i) <= 1e-12 * state.force.maxCoeff()) continue;
    ++closed;
    sliding += std::abs(state.slip(i)) > 1e-12 * state.slip.cwiseAbs().maxCoeff() ? 1 : 0;
  }
  return {closed, sliding};
}

}  // namespace

TEST_CASE("plane problems of Siconos: the figures of its sweeps", "[friction][data]") {
  struct Known {
    const char* name;
    double normal;    // sum of the normal forces
    double force;     // norm of all forces
    double movement;  // norm of all gaps and slips
    int closed;       // pairs, none of which slides
  };
  for (const Known& known :
       {Known{"FrictionContactProblem00031", 0.00063460885615, 0.00063460887884, 0.236118273128, 1},
        Known{"FrictionContactProblem00374", 1624.542732095, 514.649024451, 127.435638165, 10}}) {
    const ContactProblem problem = from_file(known.name);
    for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister",
                             "friction_split", "friction_split_literal"}) {
      const Solver& solver = find_solver(name);
      const ContactState state = solve_with_proofs(problem, solver);
      CAPTURE(known.name, solver.name, state.reason);
      REQUIRE(state.report.status == SolveStatus::Solved);
      CHECK(certify(problem, state).worst() <= 1e-14);
      CHECK(natural_map(problem, state) <= 1e-8);
      CHECK(closed_and_sliding(state) == std::make_pair(known.closed, 0));
      // What REFERENCE_SOLUTIONS.txt gives, to the last digit it gives.
      CHECK(state.force.sum() == Approx(known.normal).epsilon(1e-11));
      CHECK(forces(state).norm() == Approx(known.force).epsilon(1e-11));
      CHECK(std::hypot(state.gap.norm(), state.slip.norm()) ==
            Approx(known.movement).epsilon(1e-11));
    }
  }
}

TEST_CASE("data that are rounding only: an answer as small", "[friction][data]") {
  const ContactProblem problem = from_file("FrictionContactProblem00394");
  const ContactState state = solve_with_proofs(problem, friction_solvers().front());
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(certify(problem, state).worst() <= 1e-14);
  CHECK(forces(state).norm() <= 1e-14);
  CHECK(forces(state).norm() > 0);
}

TEST_CASE("a matrix that is not symmetric: the only solution, both pairs sliding backwards",
          "[friction][data]") {
  struct Known {
    const char* name;
    double force[2];
  };
  // Symmetric to six digits only; r as REFERENCE_SOLUTIONS.txt gives it.
  for (const Known& known :
       {Known{"FC2D_SliderCrankLagrangian00000", {0.0557794176554, 0.0552243985743}},
        Known{"FC2D_SliderCrankLagrangian00001", {0.0445252086261, 0.0440821717245}}}) {
    const ContactProblem problem = from_file(known.name);
    REQUIRE_FALSE(is_symmetric(problem));
    for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister"}) {
      const ContactState state = solve_with_proofs(problem, find_solver(name));
      CAPTURE(known.name, name, state.reason);
      REQUIRE(state.report.status == SolveStatus::Solved);
      CHECK(certify(problem, state).worst() <= 1e-14);
      CHECK(natural_map(problem, state) <= 1e-8);
      for (Eigen::Index i = 0; i < 2; ++i) {
        CHECK(state.contact_status[static_cast<std::size_t>(i)] == ContactStatus::SlipBackward);
        CHECK(state.force(i) == Approx(known.force[i]).epsilon(1e-11));
        CHECK(state.friction(i) == Approx(0.01 * known.force[i]).epsilon(1e-11));
      }
    }
  }
}
