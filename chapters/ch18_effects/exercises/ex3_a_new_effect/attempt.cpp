#include "exercise.hpp"

namespace ex18_3 {

bool present(const SpinningScene& /*spinning*/) {
  return false;  // your code here
}

void declare(const SpinningScene& /*spinning*/, signorini::Plan& /*draft*/) {
  // your code here: check the numbers, then a line for each body that spins
}

void add(const SpinningScene& /*spinning*/, signorini::Model& /*model*/) {
  // your code here: nodal forces into p, and the force per volume into the loads of the body
}

}  // namespace ex18_3
