#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex15_6 {

using Eigen::Index;

std::vector<Pair> pairs_of(const signorini::SolvedScene& run) {
  const signorini::ContactState& state = run.solution.contact;
  signorini::require_argument(state.report.status == signorini::SolveStatus::Solved,
                              "pairs_of: the scene is not solved but ",
                              to_string(state.report.status));
  std::vector<Pair> pairs;
  for (Index i = 0; i < state.force.size(); ++i)
    pairs.push_back({run.model.pairs.position(i, 0), state.gap(i), state.force(i)});
  const signorini::FrictionLaw& law = run.model.law;
  for (std::size_t k = 0; k < state.frictional_pairs.size(); ++k) {
    const Index slip = static_cast<Index>(k), number = state.frictional_pairs[k];
    Pair& pair = pairs[static_cast<std::size_t>(number)];
    pair.friction = state.friction(slip);
    pair.slip = state.slip(slip);
    if (state.contact_status[static_cast<std::size_t>(number)] != signorini::ContactStatus::Open)
      pair.bound = law.coefficient(slip) * pair.force + law.cohesion(slip);
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.x < b.x; });
  return pairs;
}

namespace {

/// What lengths and forces are measured by.
struct Sizes {
  double length = 0, force = 0;
};

Sizes sizes_of(const std::vector<Pair>& pairs) {
  Sizes sizes;
  for (const Pair& pair : pairs) {
    sizes.length = std::max({sizes.length, std::abs(pair.gap), std::abs(pair.slip)});
    sizes.force = std::max(sizes.force, pair.force);
  }
  return sizes;
}

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

}  // namespace

std::vector<State> states_of(const std::vector<Pair>& pairs) {
  const Sizes sizes = sizes_of(pairs);
  std::vector<State> states;
  for (const Pair& pair : pairs) {
    const double left = share(pair.bound - std::abs(pair.friction), sizes.force);
    const double slip = share(std::abs(pair.slip), sizes.length);
    const bool open = share(pair.gap, sizes.length) > share(pair.force, sizes.force);
    states.push_back(open ? State::Open : slip > left ? State::Slide : State::Stick);
  }
  return states;
}

Breach breach_of(const std::vector<Pair>& pairs) {
  const Sizes sizes = sizes_of(pairs);
  Breach worst;
  for (const Pair& pair : pairs) {
    const double left = share(pair.bound - std::abs(pair.friction), sizes.force);
    const double slip = share(std::abs(pair.slip), sizes.length);
    worst.cone = std::max(worst.cone, -left);
    worst.sliding = std::max(worst.sliding, std::min(slip, left));
    worst.against =
        std::max(worst.against, share(pair.slip * pair.friction, sizes.length * sizes.force));
  }
  return worst;
}

}  // namespace ex15_6
