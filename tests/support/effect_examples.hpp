// A scene for each effect, without and with it.
#pragma once
#include <map>
#include <set>
#include <string>

#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// A scene without an effect and the same with it.
struct EffectExample {
  signorini::Scene without;
  signorini::Scene with;
  std::set<std::string> touched;  ///< what of the model differs
  std::set<std::string> own;      ///< what of it is empty without the effect
};

/// Reads the example that stands beside each effect, a scene file of its name: lines that end in `# with` call for the
/// effect, those that begin with `# without: ` stand in their place without it, `# changes: ` and `# adds: ` list what
/// it touches and what of that is its own.
/// \return one for each member of the family, by its name; a new member needs its own
const std::map<std::string, EffectExample>& effect_examples();

/// \return a cantilever over a foundation, without loads
signorini::Scene plain_beam();

}  // namespace signorini_test
