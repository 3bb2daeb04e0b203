#include <stdexcept>

#include "exercise.hpp"

namespace ex21_2 {

Price price(const Front& front) {
  if (front.own < 0 || front.rim < 0 || front.rows < 0)
    throw std::invalid_argument("price: a count of a front is negative");
  Price sum;
  for (int k = 0; k < front.own; ++k) {
    const double below = front.own - 1 - k + front.rim;
    sum.factor += below + below * (below + 1) / 2;
    sum.compliance += front.rows * (1 + below);
  }
  sum.compliance += 0.5 * front.own * front.rows * (front.rows + 1.0);
  return sum;
}

double share_of_contact(const std::vector<Front>& fronts) {
  Price sum;
  for (const Front& front : fronts) {
    const Price one = price(front);
    sum.factor += one.factor;
    sum.compliance += one.compliance;
  }
  return sum.factor > 0 ? sum.compliance / sum.factor : 0;
}

}  // namespace ex21_2
