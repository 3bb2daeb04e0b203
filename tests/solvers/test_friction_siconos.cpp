// Problems of other people: tests/data/siconos_fc2d, see tests/data/SOURCES.md.
#include <cmath>
#include <stdexcept>
#include <string>

#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/solvers.hpp"
#include "support/friction.hpp"
#include "support/friction_contact_file.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

ContactProblem from_file(const std::string& name) {
  return read_friction_contact(std::string(SIGNORINI_TEST_DATA) + "/siconos_fc2d/" + name + ".dat");
}

}  // namespace

TEST_CASE("plane problems of Siconos: the figures of its sweeps", "[friction][data]") {
  struct Known {
    const char* name;
    double normal;    // sum of the normal forces
    double force;     // norm of all forces
    double movement;  // norm of all gaps and slips
  };
  for (const Known& known :
       {Known{"FrictionContactProblem00031", 0.00063460885615, 0.00063460887884, 0.236118273128},
        Known{"FrictionContactProblem00374", 1624.542732095, 514.649024451, 127.435638165}}) {
    const ContactProblem problem = from_file(known.name);
    for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister",
                             "friction_split", "friction_split_literal"}) {
      const Solver& solver = find_solver(name);
      const ContactState state = solver.solve(problem, {});
      CAPTURE(known.name, solver.name, state.reason);
      REQUIRE(state.report.status == Status::Solved);
      CHECK(certify(problem, state).worst() <= 1e-14);
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
  const ContactState state = friction_solvers().front().solve(problem, {});
  REQUIRE(state.report.status == Status::Solved);
  CHECK(certify(problem, state).worst() <= 1e-14);
  CHECK(forces(state).norm() <= 1e-14);
  CHECK(forces(state).norm() > 0);
}

TEST_CASE("a matrix that no elastic body has is refused", "[friction][data][errors]") {
  // Both are unsymmetric in the seventh digit.
  for (const char* name : {"FC2D_SliderCrankLagrangian00000", "FC2D_SliderCrankLagrangian00001"})
    CHECK_THROWS_AS(friction_solvers().front().solve(from_file(name), {}), std::invalid_argument);
}
