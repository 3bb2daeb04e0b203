#include "exercise.hpp"

namespace ex3_3 {

Answers answers() {
  Answers mine;            // your answers here
  mine.harmonic_5 = 3551;  // half of the way from 665 to 6438?
  return mine;
}

}  // namespace ex3_3
