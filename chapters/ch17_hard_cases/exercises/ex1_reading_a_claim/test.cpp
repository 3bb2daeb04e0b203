#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using ex17_1::Fault;
using ex17_1::fault_of;
using signorini::ContactProblem;

static ContactProblem three() {
  Matrix3d G;
  G << 4, -6, -4, -6, 10, 8, -4, 8, 9;
  return {G, Vector3d(3, -4, -1)};
}

static VectorXd gaps(const ContactProblem& problem, const VectorXd& force) {
  return problem.free_gap + problem.compliance * force;
}

TEST_CASE("ex17.1 the solution has no fault", "[ex17.1]") {
  CHECK(fault_of(three(), Vector3d(0, 0.4, 0), Vector3d(0.6, 0, 2.2)) == Fault::None);
}

TEST_CASE("ex17.1 five forgeries", "[ex17.1]") {
  const ContactProblem problem = three();
  const auto fault = [&](const Vector3d& force) {
    return fault_of(problem, force, gaps(problem, force));
  };
  CHECK(fault_of(problem, Vector3d(0, 0.4, 0), Vector3d(0.6, 0, 2.3)) == Fault::Movement);
  CHECK(fault(Vector3d(0, 0.3, 0)) == Fault::Overlap);
  CHECK(fault(Vector3d(-0.01, 0.42, 0)) == Fault::Tension);
  CHECK(fault(Vector3d(0, 0.45, 0)) == Fault::AcrossAGap);
  CHECK(fault(Vector3d(0, 0.4 - 1e-6, 0)) == Fault::Overlap);
}

TEST_CASE("ex17.1 the same in other units", "[ex17.1]") {
  for (const double length : {1e-6, 1.0, 1e6}) {
    ContactProblem problem = three();
    problem.compliance *= length;
    problem.free_gap *= length;
    CHECK(fault_of(problem, Vector3d(0, 0.4, 0), length * Vector3d(0.6, 0, 2.2)) == Fault::None);
    CHECK(fault_of(problem, Vector3d(0, 0.3, 0), gaps(problem, Vector3d(0, 0.3, 0))) ==
          Fault::Overlap);
  }
}
