#include "exercise.hpp"

namespace ex1_3 {

Body without(const Body& body, Eigen::Index /*unknown*/) {
  return body;  // your code here
}

Condensed condense(const Body& /*body*/, const std::vector<Eigen::Index>& /*touching*/,
                   const Eigen::VectorXd& initial_gap) {
  return {{}, initial_gap};  // your code here
}

}  // namespace ex1_3
