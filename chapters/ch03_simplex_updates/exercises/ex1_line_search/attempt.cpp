#include "exercise.hpp"

namespace ex3_1 {

double best_step(const Line& /*line*/, double largest) {
  return largest;  // the literal rule: your code here
}

}  // namespace ex3_1
