#include "addons/checks/sides.hpp"

#include <algorithm>

#include "signorini/fem/side_curve.hpp"
#include "signorini/pairing/target_search.hpp"

namespace signorini {

using Eigen::Index;

PenetratingNodes penetrating_nodes(const Surface& source, const Surface& target) {
  const std::vector<SideCurve> sides = side_curves(source.mesh, source.boundary);
  const TargetSearch search(target.mesh, target.boundary);
  PenetratingNodes passed;
  for (const auto& [number, node] : nodes_on_sides(sides)) {
    const Projection place = search.closest(source.mesh.nodes.row(number).transpose(), node.normal);
    if (place.found || place.inside || place.penetration == 0) continue;
    passed.nodes.push_back(number);
    passed.farthest = std::max(passed.farthest, place.penetration);
  }
  return passed;
}

}  // namespace signorini
