#include "exercise.hpp"

namespace ex8_1 {

Slope slope(double /*a*/, double /*b*/) {
  // your code here: the corner first, then the digits
  return {0, 0};
}

}  // namespace ex8_1
