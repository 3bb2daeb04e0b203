// Small problems in whole numbers, full of ties and repeated rows, and what every exact method must do.
#pragma once
#include <string>

#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/examples.hpp"
#include "signorini/programme/dense_programme.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/problems.hpp"

namespace signorini_test {

/// H with entries of -3 to 3, often with fewer rows than columns or a column twice, and d of -3 to 3, often
/// all equal.
inline signorini::HalfProblem whole_problem(Random& random) {
  const int n = random.whole(1, 7);
  signorini::HalfProblem problem{Eigen::MatrixXd(random.whole(1, n + 1), n), Eigen::VectorXd(n)};
  for (Eigen::Index k = 0; k < problem.half.size(); ++k)
    problem.half.data()[k] = random.whole(-3, 3);
  if (n > 1 && random.whole(0, 1) == 0) problem.half.col(n - 1) = problem.half.col(0);
  for (Eigen::Index i = 0; i < n; ++i) problem.free_gap(i) = random.whole(-3, 3);
  if (random.whole(0, 4) == 0) problem.free_gap.setConstant(-1);
  return problem;
}

/// Whether y proves that nothing solves a problem: y >= 0, G y = 0 and d^T y < 0.
inline bool proves_infeasible(const signorini::ContactProblem& problem, const Eigen::VectorXd& y) {
  if (y.size() != problem.free_gap.size() || (y.array() < 0).any()) return false;
  const double largest = problem.compliance.cwiseAbs().maxCoeff() * y.sum();
  return (problem.compliance * y).cwiseAbs().maxCoeff() <= 1e-12 * largest &&
         problem.free_gap.dot(y) < -1e-12 * problem.free_gap.cwiseAbs().dot(y);
}

/// Compares an answer with that of enumeration. Forces of dependent pairs are not unique, gaps are.
/// \return whether there is a solution
inline bool agrees_with_enumeration(const signorini::ContactProblem& problem,
                                    const signorini::ContactState& state) {
  const signorini::ContactState sure = signorini::enumerate(problem);
  REQUIRE(to_string(state.report.status) == std::string(to_string(sure.report.status)));
  if (sure.report.status == signorini::Status::Solved) {
    const Eigen::VectorXd moved = problem.compliance * (state.force - sure.force);
    CHECK(moved.norm() <= 1e-11 * (problem.free_gap.norm() + sure.gap.norm()));
    CHECK(certify(problem, state).worst() <= 1e-12);
    return true;
  }
  if (sure.report.status == signorini::Status::Infeasible)
    CHECK(proves_infeasible(problem, state.infeasibility));
  return false;
}

/// Solves one random programme of each size of Table 1 of the paper and compares the displacements.
inline void solves_table_1(const signorini::Solver& solver) {
  for (const Eigen::Index n : {10, 20, 50})
    for (const Eigen::Index twice : {1, 2, 4, 8}) {
      const signorini::KnownProgramme known = signorini::rosen_suzuki(n, n * twice / 2, 7);
      const signorini::DenseSolution solution = solve(known.programme, solver);
      CAPTURE(solver.name, n, n * twice / 2);
      REQUIRE(solution.report.status == signorini::Status::Solved);
      CHECK(solution.certificate.worst() <= 1e-12);
      CHECK((solution.refined.displacement - known.displacement).norm() <=
            1e-9 * known.displacement.norm());
      CHECK(solution.report.iterations <= 3 * n + 10);
    }
}

/// Solves a problem again with its rows scaled by 1e-8 to 1e8 and in other units.
/// \return by how much the number of iterations differs
template <typename Method>
Eigen::Index changes_with_scale(Random& random, const Method& method) {
  const signorini::ContactProblem problem = random_problem(random, random.whole(2, 8));
  Eigen::VectorXd row(problem.free_gap.size());
  for (Eigen::Index i = 0; i < row.size(); ++i) row(i) = std::pow(10.0, random.uniform(-8, 8));
  const double force = std::pow(10.0, random.uniform(-6, 6));
  const signorini::ContactState plain = method(problem);
  const signorini::ContactState other = method(in_units(with_rows(problem, row), 1e3, force));
  REQUIRE(plain.report.status == signorini::Status::Solved);
  REQUIRE(other.report.status == signorini::Status::Solved);
  CHECK(other.active == plain.active);
  const Eigen::VectorXd back = other.force.cwiseProduct(row) / force;
  CHECK((back - plain.force).norm() <= 1e-11 * plain.force.norm());
  return other.report.iterations - plain.report.iterations;
}

}  // namespace signorini_test
