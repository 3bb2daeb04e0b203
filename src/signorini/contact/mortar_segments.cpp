#include "signorini/contact/mortar_segments.hpp"

#include <algorithm>
#include <map>

#include "signorini/elasticity/element.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

/// Cuts that are closer than this are one, up to rounding; the sliver joins the next segment [-].
constexpr double sliver = 1e-12;

/// Sorts cuts and drops those that would leave a sliver.
void tidy(std::vector<double>& cuts) {
  std::sort(cuts.begin(), cuts.end());
  std::vector<double> kept;
  for (const double cut : cuts)
    if (cut > (kept.empty() ? -1 : kept.back()) + sliver && cut < 1 - sliver) kept.push_back(cut);
  cuts = kept;
}

}  // namespace

std::vector<std::vector<double>> segment_cuts(const Interface& interface) {
  const TargetSearch source(interface.source().mesh, interface.source().boundary);
  const TargetSearch& target = interface.search();
  std::vector<std::vector<double>> cuts(static_cast<std::size_t>(source.n_sides()));
  const auto cut = [&](const Vector2d& from, const Vector2d& normal) {
    const Projection seen = source.along(from, normal);
    if (seen.found) cuts[static_cast<std::size_t>(seen.side)].push_back(seen.xi);
  };
  std::map<Index, Vector2d> before;  // normal of the side that ends, or begins, at a node
  for (Index s = 0; s < target.n_sides(); ++s) {
    const SideCurve& side = target.side(s);
    for (const int end : {-1, 1}) {
      const Vector2d normal = side.normal(end);
      cut(side.point(end), normal);
      const auto [other, first] =
          before.emplace(end < 0 ? side.nodes().front() : side.nodes().back(), normal);
      if (!first) cut(side.point(end), (other->second + normal).normalized());
    }
  }
  for (std::vector<double>& list : cuts) tidy(list);
  return cuts;
}

EdgeSamples sample_edge(const SideCurve& edge, const Interface& interface,
                        const std::vector<double>& cuts, int points) {
  EdgeSamples samples;
  double begin = -1;
  for (std::size_t k = 0; k <= cuts.size(); ++k) {
    const double end = k < cuts.size() ? cuts[k] : 1;
    const double half = 0.5 * (end - begin);
    for (const GaussPoint& gauss : gauss_line(points)) {
      const double s = 0.5 * (begin + end) + half * gauss.xi;
      const EdgePoint at{s, half * gauss.weight * edge.tangent(s).norm()};
      samples.share += at.length * corner_shape(s);
      const Projection seen = interface.closest(edge.point(s), edge.normal(s));
      if (seen.found) samples.facing.push_back({at, seen});
    }
    begin = end;
  }
  return samples;
}

}  // namespace signorini
