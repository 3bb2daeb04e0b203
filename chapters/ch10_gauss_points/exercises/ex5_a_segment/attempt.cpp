#include "exercise.hpp"

namespace ex10_5 {

Segment mortar_segment(const Edges& /*edges*/) {
  return {};  // your code here: cut the edge of the source, then integrate with two points
}

}  // namespace ex10_5
