#include "support/friction.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/rounding.hpp"

namespace signorini_test {

using signorini::pi;

signorini::ContactProblem random_friction(Random& random, Eigen::Index n, double coefficient,
                                          double cohesion) {
  const Eigen::MatrixXd C =
      Eigen::MatrixXd::NullaryExpr(2 * n, 2 * n, [&] { return random.uniform(-1, 1); });
  const auto numbers = [&](double low, double high) {
    return Eigen::VectorXd(
        Eigen::VectorXd::NullaryExpr(n, [&] { return random.uniform(low, high); }));
  };
  signorini::ContactProblem problem;
  problem.compliance = C * C.transpose() + 0.1 * Eigen::MatrixXd::Identity(2 * n, 2 * n);
  problem.free_gap = numbers(-1, 0.5);
  problem.free_slip = numbers(-1, 1);
  const Eigen::VectorXd mu = numbers(0, coefficient);
  problem.law = signorini::law_of_all(mu, numbers(0, cohesion));
  return problem;
}

signorini::ContactProblem random_floating(Random& random, Eigen::Index n, double coefficient) {
  signorini::ContactProblem problem = random_friction(random, n, coefficient);
  problem.rigid = Eigen::MatrixXd::Zero(2 * n, 2);
  problem.rigid.col(0).head(n).setOnes();
  problem.rigid.col(1).tail(n).setOnes();
  problem.resultant = Eigen::Vector2d::Zero();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double force = random.uniform(0.1, 1);
    problem.resultant(0) += force;
    problem.resultant(1) += problem.law.coefficient(i) * force * random.uniform(-0.9, 0.9);
  }
  return problem;
}

signorini::ContactProblem one_pair(const Eigen::Matrix2d& F, double gap, double slip,
                                   double coefficient, double cohesion) {
  const auto one = [](double x) { return Eigen::VectorXd(Eigen::VectorXd::Constant(1, x)); };
  return {F, one(gap), one(slip), signorini::law_of_all(one(coefficient), one(cohesion))};
}

signorini::ContactProblem frictional_only(const signorini::ContactProblem& problem,
                                          const std::vector<Eigen::Index>& pairs) {
  const Eigen::Index n = problem.free_gap.size();
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < n; ++i) rows.push_back(i);
  for (const Eigen::Index i : pairs) rows.push_back(n + i);
  return {problem.compliance(rows, rows),
          problem.free_gap,
          problem.free_slip(pairs),
          {pairs, problem.law.coefficient(pairs), problem.law.cohesion(pairs)}};
}

std::vector<Eigen::VectorXd> all_solutions(const signorini::ContactProblem& problem) {
  const signorini::ScaledProblem scaled = signorini::equilibrate(problem);
  const Eigen::Index n = problem.free_gap.size();
  std::vector<Eigen::VectorXd> found;
  for (int choice = 0; choice < 1 << (2 * n); ++choice) {
    std::vector<signorini::ContactStatus> statuses;
    bool sensible = true;  // what does not rub does not slide
    for (Eigen::Index i = 0; i < n; ++i) {
      statuses.push_back(static_cast<signorini::ContactStatus>((choice >> (2 * i)) & 3));
      sensible = sensible && (signorini::friction_sign(statuses.back()) == 0 ||
                              std::count(problem.law.pair.begin(), problem.law.pair.end(), i) > 0);
    }
    if (!sensible) continue;
    const signorini::ActiveSetSolution solution = signorini::solve_active_set(scaled, statuses);
    bool known = !signorini::solves(scaled, statuses, solution);
    for (const Eigen::VectorXd& other : found)
      known = known || (scaled.scale.cwiseInverse().cwiseProduct(other) - solution.force).norm() <=
                           1e-9 * solution.force.norm();
    if (!known) found.push_back(scaled.scale.cwiseProduct(solution.force));
  }
  return found;
}

Eigen::VectorXd forces(const signorini::ContactState& state) {
  Eigen::VectorXd both(state.force.size() + state.friction.size());
  both << state.force, state.friction;
  return both;
}

signorini::ContactProblem cylinder(Eigen::Index n, double coefficient, double part) {
  const double h = 2.6 / static_cast<double>(n);
  const auto primitive = [](double x) { return x == 0 ? 0 : x * std::log(std::abs(x)) - x; };
  Eigen::MatrixXd G(n, n);  // -2/pi times the mean of log(|x_i - s| / 10) over element j, per force
  Eigen::VectorXd x(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    x(i) = -1.3 + (static_cast<double>(i) + 0.5) * h;
    for (Eigen::Index j = 0; j < n; ++j) {
      const double far = static_cast<double>(i - j) * h;
      G(i, j) = -2 / pi * ((primitive(far + h / 2) - primitive(far - h / 2)) / h - std::log(10.0));
    }
  }
  signorini::ContactProblem problem;
  problem.compliance = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  problem.compliance.topLeftCorner(n, n) = G;
  problem.compliance.bottomRightCorner(n, n) = G;
  problem.free_gap = x.cwiseAbs2() / 2;
  problem.free_slip = Eigen::VectorXd::Zero(n);
  problem.law =
      signorini::law_of_all(Eigen::VectorXd::Constant(n, coefficient), Eigen::VectorXd::Zero(n));
  problem.rigid = Eigen::MatrixXd::Zero(2 * n, 2);
  problem.rigid.col(0).head(n).setOnes();
  problem.rigid.col(1).tail(n).setOnes();
  problem.resultant = Eigen::Vector2d(pi / 4, part * coefficient * pi / 4);
  return problem;
}

}  // namespace signorini_test
