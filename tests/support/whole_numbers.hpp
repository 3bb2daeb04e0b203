// Small problems in whole numbers, full of ties and repeated rows, and what every exact method must do.
#pragma once
#include <string>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/problems.hpp"

namespace signorini_test {

/// K = I, A = H^T with entries of -3 to 3, often with fewer unknowns than rows or a row twice, and g of -3 to 3,
/// often all equal.
inline signorini::DenseProgramme whole_programme(Random& random) {
  const int n = random.whole(1, 7);
  Eigen::MatrixXd half(random.whole(1, n + 1), n);
  Eigen::VectorXd gap(n);
  for (Eigen::Index k = 0; k < half.size(); ++k) half.data()[k] = random.whole(-3, 3);
  if (n > 1 && random.whole(0, 1) == 0) half.col(n - 1) = half.col(0);
  for (Eigen::Index i = 0; i < n; ++i) gap(i) = random.whole(-3, 3);
  if (random.whole(0, 4) == 0) gap.setConstant(-1);
  return {Eigen::MatrixXd::Identity(half.rows(), half.rows()), Eigen::VectorXd::Zero(half.rows()),
          half.transpose(), gap, 0};
}

/// \param programme  with K = I and no load
/// \return G = A A^T and d = g, of whole numbers as those are
inline signorini::ContactProblem whole_problem(const signorini::DenseProgramme& programme) {
  return {programme.A * programme.A.transpose(), programme.initial_gap};
}

/// The same as a condensed problem.
inline signorini::ContactProblem whole_problem(Random& random) {
  return whole_problem(whole_programme(random));
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
  if (sure.report.status == signorini::SolveStatus::Solved) {
    const Eigen::VectorXd moved = problem.compliance * (state.force - sure.force);
    CHECK(moved.norm() <= 1e-11 * (problem.free_gap.norm() + sure.gap.norm()));
    CHECK(certify(problem, state).worst() <= 1e-12);
    return true;
  }
  if (sure.report.status == signorini::SolveStatus::Infeasible)
    CHECK(proves_infeasible(problem, state.farkas_certificate));
  return false;
}

/// Solves one random programme of each size of Table 1 of the paper and compares the displacements.
inline void solves_table_1(const signorini::Solver& solver) {
  for (const Eigen::Index n : {10, 20, 50})
    for (const Eigen::Index twice : {1, 2, 4, 8}) {
      const signorini::KnownProgramme known = signorini::rosen_suzuki(n, n * twice / 2, 7);
      const signorini::DenseSolution solution = solve(known.programme, solver);
      CAPTURE(solver.name, n, n * twice / 2);
      REQUIRE(solution.report.status == signorini::SolveStatus::Solved);
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
  REQUIRE(plain.report.status == signorini::SolveStatus::Solved);
  REQUIRE(other.report.status == signorini::SolveStatus::Solved);
  CHECK(other.active() == plain.active());
  const Eigen::VectorXd back = other.force.cwiseProduct(row) / force;
  CHECK((back - plain.force).norm() <= 1e-11 * plain.force.norm());
  return other.report.iterations - plain.report.iterations;
}

}  // namespace signorini_test
