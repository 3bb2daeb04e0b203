#include "exercise.hpp"

namespace ex5_4 {

Answers answers() {
  Answers mine;
  mine.lemke_ticks = 1;  // 0.0547 s, and a tick is 0.0549 s
  mine.paper_ticks = 2;
  mine.undecided = 3;  // 10 x 5, 10 x 40, 20 x 10: less than 0.1098 s apart
  mine.uncertainty = 0.0549 / 0.7188;
  mine.best_n = 20;  // 5.1641 / 1.5391 = 3.36
  mine.best_m = 80;
  mine.exponent = 2.82;  // ln(10.2734 / 0.1094) / ln 5
  mine.above_one = 11;   // all but 10 x 20
  return mine;
}

}  // namespace ex5_4
