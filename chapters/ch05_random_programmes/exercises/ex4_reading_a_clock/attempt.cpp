#include "exercise.hpp"

namespace ex5_4 {

Answers answers() {
  Answers mine;  // your answers here
  mine.above_one = 12;
  return mine;
}

}  // namespace ex5_4
