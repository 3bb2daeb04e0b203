#include "exercise.hpp"

namespace ex2_3 {

Answers answers() {
  Answers mine;
  mine.yield = {0.218 / 0.775, 0.969 / 9.319, 0.718 / 2.629};  // overlap over force, (23)
  const double all_nine = 9 * 0.635 / 10.975;                  // each weight is a third
  mine.coupling = (all_nine - mine.yield[0] - mine.yield[1] - mine.yield[2]) / 6;
  mine.best_pair = 1;
  mine.share = 4.513 / 7.092;
  mine.at_least = -13.462 + 3.483;  // the energy without contact, and what the trade adds
  mine.missing = 7.092 - 3.483;
  return mine;
}

}  // namespace ex2_3
