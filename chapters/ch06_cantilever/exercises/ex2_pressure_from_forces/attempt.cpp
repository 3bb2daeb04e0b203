#include "exercise.hpp"

namespace ex6_2 {

ContactLine contact_line(const Eigen::VectorXd& position, const Eigen::VectorXd& /*contact_force*/,
                         signorini::MeshOrder /*order*/, double /*thickness*/) {
  // your code here: weights edge by edge, then pressures, then the touchdown
  return {Eigen::VectorXd::Zero(position.size()), 0};
}

}  // namespace ex6_2
