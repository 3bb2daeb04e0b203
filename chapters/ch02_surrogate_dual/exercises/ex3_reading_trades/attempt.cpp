#include "exercise.hpp"

namespace ex2_3 {

Answers answers() {
  Answers mine;  // your answers here
  mine.yield = {0.775, 9.319, 2.629};
  return mine;
}

}  // namespace ex2_3
