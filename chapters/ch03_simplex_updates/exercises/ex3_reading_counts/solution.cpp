#include <cmath>

#include "exercise.hpp"

namespace ex3_3 {

Answers answers() {
  Answers mine;
  mine.harmonic_power = std::log(100) / std::log(6438.0 / 665);
  mine.harmonic_5 = static_cast<int>(std::sqrt(665.0 * 6438));  // one of two digits
  mine.away_digit = (1018 - 575) / 2.0;
  mine.away_10 = 1018 + (1018 - 575);
  mine.pairwise_10 = 535 + (535 - 287);
  mine.corrective_12 = 119;  // it has arrived
  mine.reaching_6 = 4;
  return mine;
}

}  // namespace ex3_3
