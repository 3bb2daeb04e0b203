#include "exercise.hpp"

namespace ex4_5 {

Answers answers() {
  Answers mine;  // your answers here
  mine.eta_20 = 2;
  return mine;
}

}  // namespace ex4_5
