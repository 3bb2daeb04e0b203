#include "exercise.hpp"

namespace ex7_2 {

ContactAngle half_contact_angle(double /*wanted*/, double /*stiffness_ratio*/) {
  // your code here: a range that holds the root, and a rule that makes it smaller
  return {0, 0};
}

}  // namespace ex7_2
