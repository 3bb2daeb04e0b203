// A live figure is a function that returns it, in a file of its own in the folder `live` of its chapter, and its
// name in this table.
#define SIGNORINI_LIVE_FIGURES(FIGURE) \
  FIGURE(press)                        \
  FIGURE(weights)                      \
  FIGURE(rules)                        \
  FIGURE(groups)                       \
  FIGURE(cantilever)                   \
  FIGURE(pin)                          \
  FIGURE(newton)                       \
  FIGURE(corner)                       \
  FIGURE(points)                       \
  FIGURE(hertz)                        \
  FIGURE(footing)                      \
  FIGURE(lining)                       \
  FIGURE(friction)                     \
  FIGURE(work_precision)               \
  FIGURE(hard)                         \
  FIGURE(effects)                      \
  FIGURE(die)

#include "live/figure.hpp"

namespace live {

#define FIGURE(name) Figure name();
SIGNORINI_LIVE_FIGURES(FIGURE)
#undef FIGURE

const std::vector<Figure>& figures() {
#define FIGURE(name) name(),
  static const std::vector<Figure> all = {SIGNORINI_LIVE_FIGURES(FIGURE)};
#undef FIGURE
  return all;
}

}  // namespace live
