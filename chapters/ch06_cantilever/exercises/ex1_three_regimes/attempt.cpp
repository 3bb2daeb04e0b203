#include "exercise.hpp"

namespace ex6_1 {

FoundationContact touch_foundation(const Cantilever& beam) {
  // your code here: the beam is free; add the regimes of tip and line contact
  return {beam.length, 0, 0};
}

}  // namespace ex6_1
