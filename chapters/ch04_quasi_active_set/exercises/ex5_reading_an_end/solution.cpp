#include "exercise.hpp"

namespace ex4_5 {

Answers answers() {
  Answers mine;
  mine.overlapping = {1, 2};  // the two rows without a force; the others are tight
  mine.largest_overlap = 3 * 28.0 / 23 + 2 * 5.0 / 46 + 3 * 63.0 / 46 - 1;
  mine.pulling = 4;
  mine.missing = 1;
  mine.at_least = -611.0 / 92;  // the least with rows 3 and 4 alone
  mine.at_most = -7.0 / 2;      // (1, 1, 1) is admissible
  mine.lost = -7.0 / 2 + 395.0 / 98;
  mine.eta_20 = 1.0 / 1024;  // k = 2 j - 1 and 2 j have 2^-j
  return mine;
}

}  // namespace ex4_5
