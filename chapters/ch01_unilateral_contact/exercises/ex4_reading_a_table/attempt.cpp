#include "exercise.hpp"

namespace ex1_4 {

Answers answers() {
  Answers mine;  // your answers here
  mine.overlapping = 3;
  return mine;
}

}  // namespace ex1_4
