// A scene for each effect, without and with it.
#pragma once
#include <map>
#include <set>
#include <string>

#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// A scene without an effect and what gives it to it.
struct EffectExample {
  signorini::Scene without;
  void (*give)(signorini::Scene& scene);
  std::set<std::string> touched;  ///< what of the model differs then
  std::set<std::string> own;      ///< what of it is empty without the effect
};

/// \return one for each member of the family, by its name; a new member needs its own
const std::map<std::string, EffectExample>& effect_examples();

/// \return a cantilever over a foundation, without loads
signorini::Scene plain_beam();

}  // namespace signorini_test
