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
  const VectorXd u0 = factor.solve(p);
  Round now{u0, VectorXd::Zero(g.size())};
  while (static_cast<int>(rounds.size()) < most) {
    const VectorXd gap = g - A * now.displacement;
    std::vector<Index> rows;
    bool violated = false;
    for (Index i = 0; i < g.size(); ++i) {
      if (gap(i) < -1e-12) violated = true;
      if (gap(i) < -1e-12 || now.force(i) > 0) rows.push_back(i);
    }
    if (!violated) break;
    // The least of the first energy under these rows: all forces, from the displacements without contact.
    const Eigen::MatrixXd some = A(rows, Eigen::all);
    const Eigen::MatrixXd response = factor.solve_columns(some.transpose());
    const VectorXd free_gap = (g - A * u0)(rows);
    now.force.setZero();
    now.force(rows) = signorini::quasi_active_set({some * response, free_gap}).force;
    now.displacement = u0 - factor.solve(A.transpose() * now.force);
    rounds.push_back(now);
  }
  return rounds;
}

}  // namespace ex4_6
