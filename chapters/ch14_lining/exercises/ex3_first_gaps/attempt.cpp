#include "exercise.hpp"

namespace ex14_3 {

FirstGaps first_gaps(const signorini::Scene& scene) {
  const signorini::Plan planned = signorini::plan(scene);
  FirstGaps gaps;
  gaps.pairs = planned.gaps.A.rows();
  return gaps;  // your code here
}

bool as_drawn(const FirstGaps& /*gaps*/, double /*drawn*/, double /*part*/) {
  return true;  // your code here
}

Eigen::Index sides_needed(double /*radius*/, double /*gap*/, double /*part*/) {
  return 9;  // your code here
}

}  // namespace ex14_3
