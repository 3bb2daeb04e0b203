#include "exercise.hpp"

namespace ex19_2 {

Term nitsche_term(const Point& /*at*/, const Eigen::VectorXd& u, double /*gamma*/,
                  double /*theta*/) {
  // your code here
  return {Eigen::VectorXd::Zero(u.size()), Eigen::MatrixXd::Zero(u.size(), u.size())};
}

}  // namespace ex19_2
