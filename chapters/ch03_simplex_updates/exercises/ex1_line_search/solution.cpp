#include <algorithm>

#include "exercise.hpp"

namespace ex3_1 {

double best_step(const Line& line, double largest) {
  // s'(t) has the sign of rise + bend * t, as long as b0 + b1 t stays positive.
  const double rise = line.b1 * line.c0 - line.b0 * line.c1;
  const double bend = line.b1 * line.c1 - line.b0 * line.c2;
  if (rise <= 0) return 0;
  if (bend >= 0) return largest;
  return std::min(largest, -rise / bend);
}

}  // namespace ex3_1
