#include "exercise.hpp"

namespace ex14_1 {

Closure press_lining(const TwoRings& /*rings*/, double /*pressure*/) {
  // your code here: the inner ring alone first, then the one equation that closes the gap
  return {0, 0, 0};
}

}  // namespace ex14_1
