#include "exercise.hpp"

namespace ex21_2 {

Price price(const Front& /*front*/) {
  return {};  // your code here
}

double share_of_contact(const std::vector<Front>& /*fronts*/) {
  return 0;  // your code here
}

}  // namespace ex21_2
