#include "exercise.hpp"

namespace ex18_1 {

Needs needs_of(const signorini::Scene& scene) {
  const signorini::Plan planned = signorini::plan(scene);
  Needs needs;
  needs.unknowns = planned.unknowns.count;
  // your code here: gaps, slips and amplitudes; the same by contact; names of the effects
  return needs;
}

Step step(const signorini::Scene& /*from*/, const signorini::Scene& /*to*/) {
  return {};  // your code here
}

}  // namespace ex18_1
