#include "exercise.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace ex4_6 {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<Round> outer_loop(const signorini::DenseProgramme& programme, int most) {
  const auto& [K, p, A, g, equations] = programme;
  const signorini::CholeskyFactor factor(K);
  std::vector<Round> rounds;
  Round now{factor.solve(p), VectorXd::Zero(g.size())};
  while (static_cast<int>(rounds.size()) < most) {
    const VectorXd gap = g - A * now.displacement;
    std::vector<Index> rows;
    bool violated = false;
    for (Index i = 0; i < g.size(); ++i) {
      if (gap(i) < -1e-12) violated = true;
      if (gap(i) < -1e-12) rows.push_back(i);
    }
    if (!violated) break;
    // The problem of these rows (32), with the minimum of the energy at u (31): your changes here and above.
    const Eigen::MatrixXd some = A(rows, Eigen::all);
    const Eigen::MatrixXd response = factor.solve_columns(some.transpose());
    const VectorXd free_gap = gap(rows);
    now.force.setZero();
    now.force(rows) = signorini::quasi_active_set({some * response, free_gap}).force;
    now.displacement -= factor.solve(A.transpose() * now.force);  // (36)
    rounds.push_back(now);
  }
  return rounds;
}

}  // namespace ex4_6
