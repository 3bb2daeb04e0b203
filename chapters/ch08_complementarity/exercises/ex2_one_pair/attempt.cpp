#include "exercise.hpp"
#include "signorini/closing/complementarity_functions.hpp"

namespace ex8_2 {

System equations(const Pair& /*pair*/, const Eigen::Vector4d& /*unknowns*/) {
  // your code here: gap, slip and bound first, then four residuals, then sixteen derivatives
  return {Eigen::Vector4d::Ones(), Eigen::Matrix4d::Identity()};
}

}  // namespace ex8_2
