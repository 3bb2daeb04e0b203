#include "exercise.hpp"

namespace ex5_6 {

Path load_path(const Loaded& body, double /*until*/) {
  return {{},
          Eigen::VectorXd::Zero(body.initial_gap.size())};  // nothing ever touches: your code here
}

}  // namespace ex5_6
