#include <limits>

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Vector2d;
using Eigen::VectorXd;
using ex17_1::Fault;
using ex17_1::fault_of;
using signorini::ContactProblem;

// Rows in units of their own: no figure of one pair may be measured by those of another as they stand.
TEST_CASE("ex17.1 held out: each row in its own unit", "[ex17.1]") {
  const Eigen::Matrix2d G = (Eigen::Matrix2d() << 2, 1, 1, 3).finished();
  for (const double one : {1e-8, 1.0, 1e8})
    for (const double two : {1e-8, 1.0, 1e8}) {
      CAPTURE(one, two);
      const Vector2d row(one, two);
      const ContactProblem problem{row.asDiagonal() * G * row.asDiagonal(),
                                   row.cwiseProduct(Vector2d(-4, -5))};
      const auto fault = [&](const Vector2d& force) {
        const VectorXd claim = force.cwiseQuotient(row);
        return fault_of(problem, claim, problem.free_gap + problem.compliance * claim);
      };
      CHECK(fault(Vector2d(1.4, 1.2)) == Fault::None);
      CHECK(fault(Vector2d(1.4, 1.19)) == Fault::Overlap);
      CHECK(fault(Vector2d(1.39, 1.2)) == Fault::Overlap);
      CHECK(fault(Vector2d(1.41, 1.2)) == Fault::AcrossAGap);
      CHECK(fault(Vector2d(-1, 9)) == Fault::Tension);
      CHECK(fault_of(problem, Vector2d(1.4, 1.2).cwiseQuotient(row),
                     row.cwiseProduct(Vector2d(0, 1e-3))) == Fault::Movement);
    }
}

TEST_CASE("ex17.1 held out: nothing acts", "[ex17.1]") {
  const ContactProblem problem{Eigen::Matrix2d::Identity(), Vector2d::Zero()};
  CHECK(fault_of(problem, Vector2d::Zero(), Vector2d::Zero()) == Fault::None);
  CHECK(fault_of(problem, Vector2d::Zero(), Vector2d(0, 1e-300)) == Fault::Movement);
  CHECK(fault_of(problem, Vector2d(1, 0), Vector2d(1, 0)) == Fault::AcrossAGap);
}

TEST_CASE("ex17.1 held out: what is no number is no solution", "[ex17.1]") {
  const ContactProblem problem{Eigen::Matrix2d::Identity(), Vector2d(-1, 1)};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(fault_of(problem, Vector2d(1, 0), Vector2d(0, 1)) == Fault::None);
  CHECK(fault_of(problem, Vector2d(nan, 0), Vector2d(0, 1)) == Fault::Movement);
  CHECK(fault_of(problem, Vector2d(1, 0), Vector2d(nan, 1)) == Fault::Movement);
  CHECK(fault_of(problem, Vector2d(infinity, 0), Vector2d(infinity, 1)) == Fault::Movement);
}
