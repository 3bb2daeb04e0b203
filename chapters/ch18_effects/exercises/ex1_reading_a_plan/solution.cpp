#include <algorithm>

#include "exercise.hpp"
#include "signorini/scene/effects.hpp"

namespace ex18_1 {
namespace {

using Names = std::vector<std::string>;

Names without(const Names& names, const Names& others) {
  Names left;
  for (const std::string& name : names)
    if (std::find(others.begin(), others.end(), name) == others.end()) left.push_back(name);
  return left;
}

}  // namespace

Needs needs_of(const signorini::Scene& scene) {
  const signorini::Plan planned = signorini::plan(scene);
  Needs needs;
  needs.unknowns = planned.unknowns.count;
  needs.gaps = planned.gaps.A.rows();
  needs.slips = static_cast<Eigen::Index>(planned.law.pair.size());
  needs.amplitudes = static_cast<Eigen::Index>(planned.modes.size());
  needs.gaps_of.resize(scene.contacts.size());
  needs.slips_of.resize(scene.contacts.size());
  for (const std::size_t contact : planned.contact_of) ++needs.gaps_of[contact];
  for (const Eigen::Index pair : planned.law.pair)
    ++needs.slips_of[planned.contact_of[static_cast<std::size_t>(pair)]];
  for (const signorini::Effect* effect : planned.effects) needs.on.emplace_back(effect->name);
  return needs;
}

Step step(const signorini::Scene& from, const signorini::Scene& to) {
  const Needs one = needs_of(from);
  const Needs two = needs_of(to);
  return {two.unknowns - one.unknowns, two.gaps + two.slips - one.gaps - one.slips,
          two.amplitudes - one.amplitudes, without(two.on, one.on), without(one.on, two.on)};
}

}  // namespace ex18_1
