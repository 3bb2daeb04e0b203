// # On the line through the last two steps
//
// As long as no pair begins to slide, to stick, to open or to close, everything is linear in the loads. Two points of a line
// give the third: if loads of 1 and 2 bend a beam by 3 and 5, a load of 3 bends it by 7. No system is solved for that.
//
// The digits matter. The difference of two numbers of 16 digits that agree in two has 14, and after fifty such steps
// there were less. So the way has two doubles for each number, as u and the forces have.

#include <algorithm>
#include <cmath>

#include "addons/steps/step_parts.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

namespace {

/// What loads of a part are multiplied by.
struct Factors {
  double began;  // when the last step began
  double now;    // where it ended
  double then;   // at the end of the step

  /// Whether they go on by a share of how far they went, but for rounding: of the three, which histories interpolate, and of two differences.
  [[nodiscard]] bool are_in_proportion(double share) const {
    constexpr double roundings = 8;
    const double largest = std::max({std::abs(began), std::abs(now), std::abs(then)});
    return std::abs((then - now) - share * (now - began)) <=
           roundings * epsilon * (1 + share) * largest;
  }
};

Factors factors_of(const LoadPart& part, const PathState& past, double time, const Model& model) {
  const auto factor = [&](double when) {
    return factor_of(model.path.histories, part.history, when);
  };
  return {factor(past.began), factor(past.time), factor(time)};
}

/// high + low += share * (way + rest), number by number.
void add_multiple(double share, const VectorXd& way, const VectorXd& rest, VectorXd& high,
                  VectorXd& low) {
  for (Index i = 0; i < high.size(); ++i) {
    ExactSum sum(high(i), low(i) + share * rest(i));
    sum.add_product(share, way(i));
    high(i) = sum.value();
    low(i) = (sum.high() - high(i)) + sum.low();
  }
}

}  // namespace

double share_gone_on(const PathState& past, double time, const Model& model) {
  double along = 0;
  double last = 0;
  for (const LoadPart& part : model.parts) {
    const Factors factors = factors_of(part, past, time, model);
    const double change = factors.now - factors.began;
    along += change * (factors.then - factors.now);
    last += change * change;
  }
  return along > 0 ? along / last : 0;
}

bool is_linear(const Model& model) { return !model.loop && !model.equations && model.modes.empty(); }

std::optional<PrimalDual> extrapolated(const PathState& past, double time, const Model& model) {
  if (!is_linear(model) || past.way.force_low.size() == 0) return std::nullopt;
  const double share = share_gone_on(past, time, model);
  // Loads are rounded, and so many times as much in what they foretell: beyond this no certificate could hold.
  if (share * epsilon > certificate_tolerance) return std::nullopt;
  const auto goes_on = [&](const LoadPart& part) {
    return factors_of(part, past, time, model).are_in_proportion(share);
  };
  if (share == 0 || !std::all_of(model.parts.begin(), model.parts.end(), goes_on))
    return std::nullopt;
  PrimalDual end = past.solution;
  const PrimalDual& way = past.way;
  add_multiple(share, way.displacement, way.displacement_low, end.displacement,
               end.displacement_low);
  add_multiple(share, way.force, way.force_low, end.force, end.force_low);
  return end;
}

PrimalDual way_between(const PrimalDual& from, const PrimalDual& to) {
  if (from.force_low.size() == 0 || to.force_low.size() == 0) return {};
  PrimalDual way{to.displacement, to.displacement_low, to.force, {}, to.force_low};
  add_multiple(-1, from.displacement, from.displacement_low, way.displacement,
               way.displacement_low);
  add_multiple(-1, from.force, from.force_low, way.force, way.force_low);
  return way;
}

}  // namespace signorini
