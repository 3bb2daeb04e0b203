#include "exercise.hpp"

namespace ex7_5 {

Bearing pole_free(const HeldPlate& plate) {
  return {plate.load, 0, Eigen::VectorXd::Zero(plate.free_gap.size())};  // your code here
}

}  // namespace ex7_5
