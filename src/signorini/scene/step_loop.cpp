// # Steps that are loops
//
// A load step is one linear problem, as long as pairs and forces do not depend on where the bodies are. Where they do, an
// effect hands a loop to the plan, and the add-on steps asks it for each step. The library itself has no such effect.

#include "signorini/scene/step_loop.hpp"

namespace signorini {

// What supports give is exact, and has no second part.
Displaced displaced(const Unknowns& unknowns, const PrimalDual& solution) {
  Displaced all(expand(unknowns, solution.displacement));
  if (solution.displacement_low.size() == 0) return all;
  for (Eigen::Index node = 0; node < all.low.rows(); ++node)
    for (const int axis : {0, 1})
      if (const Eigen::Index k = unknowns.number(node, axis); k >= 0)
        all.low(node, axis) = solution.displacement_low(k);
  return all;
}

}  // namespace signorini
