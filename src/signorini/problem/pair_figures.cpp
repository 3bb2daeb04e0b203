// What both certificates ask of pairs.
#include <algorithm>
#include <cmath>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index;

void raise(double& figure, double value) { figure = std::max(figure, value); }

/// Numbers of a frictional pair, scaled to the unit of its rows.
struct Rubbing {
  double normal;    ///< mu lambda+, the bound of an open pair
  double cohesion;  ///< what the bound of a closed pair has more
  double friction;
  double push;
  double gap;
  double slip;
};

/// How far a pair is from the law of friction.
struct Violation {
  /// What the friction force exceeds its bound by, the gap of a closed pair, or what presses an open one.
  double cone = 0;
  double sliding = 0;  ///< what slides without being resisted
};

/// The smaller violation of the two that a pair has as an open and as a closed one.
Violation violation(const Rubbing& pair, double length, double force) {
  const auto against = [&](double bound) {
    return Violation{
        ratio(std::max(0.0, std::abs(pair.friction) - bound), force),
        std::min(ratio(std::abs(pair.slip), length),
                 ratio(std::abs(std::copysign(bound, pair.slip) + pair.friction), force))};
  };
  Violation open = against(pair.normal);
  if (pair.cohesion == 0) return open;
  open.cone = std::max(open.cone, ratio(std::max(0.0, pair.push), force));
  Violation closed = against(pair.normal + pair.cohesion);
  closed.cone = std::max(closed.cone, ratio(std::max(0.0, pair.gap), length));
  return std::max(closed.cone, closed.sliding) < std::max(open.cone, open.sliding) ? closed : open;
}

}  // namespace

Certificate pair_figures(const RowNumbers& rows, const FrictionLaw& law, Index equations) {
  const auto force = [&](Index row) { return rows.force(row) * rows.unit(row); };
  const auto movement = [&](Index row) { return rows.movement(row) / rows.unit(row); };
  const double most = rows.largest_force;
  const Index pairs = rows.movement.size() - static_cast<Index>(law.pair.size());
  Certificate certificate;
  for (Index i = 0; i < pairs; ++i) {
    const bool equation = i < equations;
    const double gap = equation ? -std::abs(movement(i)) : movement(i);
    const double push = equation ? std::abs(force(i)) : force(i);
    raise(certificate.penetration, ratio(std::max(0.0, -gap), rows.length));
    raise(certificate.tension, ratio(std::max(0.0, -push), most));
    raise(certificate.complementarity, ratio(std::abs(gap * push), rows.length * most));
  }
  for (std::size_t k = 0; k < law.pair.size(); ++k) {
    const Index row = static_cast<Index>(k);
    const Index i = law.pair[k];
    const Index slip = pairs + row;
    const double normal = law.coefficient(row) * std::max(0.0, rows.force(i)) * rows.unit(slip);
    const Violation found = violation({normal, law.cohesion(row) * rows.unit(slip), force(slip),
                                       force(i), movement(i), movement(slip)},
                                      rows.length, most);
    raise(certificate.cone, found.cone);
    raise(certificate.sliding, found.sliding);
  }
  return certificate;
}

}  // namespace signorini
