#include <limits>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"

namespace ex5_2 {

using Eigen::VectorXd;

signorini::DenseProgramme backwards(const Eigen::MatrixXd& K, const Eigen::MatrixXd& A,
                                    const VectorXd& u, const VectorXd& force, const VectorXd& gap) {
  return {K, K * u + A.transpose() * force, A, A * u + gap};
}

Enclosure enclose(const signorini::DenseProgramme& programme, const VectorXd& u,
                  const VectorXd& force) {
  const auto& [K, p, A, g, equations] = programme;
  const VectorXd pressing = force.cwiseMax(0);
  const VectorXd rest = p - A.transpose() * pressing;
  const double lower = -0.5 * rest.dot(signorini::CholeskyFactor(K).solve(rest)) - g.dot(pressing);
  const VectorXd size = g.cwiseAbs() + A.cwiseAbs() * u.cwiseAbs();
  const bool apart = ((g - A * u).array() >= -1e-12 * size.array()).all();
  const double energy = 0.5 * u.dot(K * u) - p.dot(u);
  return {lower, apart ? energy : std::numeric_limits<double>::infinity()};
}

}  // namespace ex5_2
