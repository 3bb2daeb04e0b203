#include "exercise.hpp"

namespace ex13_1 {

double force_between(double /*half_width*/, double /*load*/, double /*from*/, double /*to*/) {
  return 0;  // your code here
}

double largest_deviation(const Eigen::VectorXd& /*position*/, const Eigen::VectorXd& /*force*/,
                         double /*half_width*/, double /*load*/, double /*within*/) {
  return 0;  // your code here: the share of every node, then the worst of those that count
}

}  // namespace ex13_1
