// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What holds bodies together: equations between displacements, as a scene asks for them.
#pragma once
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Two sides whose gap is and stays zero: they carry tension as well as pressure. A rigid obstacle may be the target.
struct Tie {
  /// Source, target, operator, and `adjust`: what else a contact may have is none of a tie.
  ContactSpec sides;
  bool slides = false;  ///< whether the source may slide along the target, without friction
};

/// All of a scene, see Scene::bonds.
struct Bonds {
  std::vector<Tie> ties = {};  ///< none by default
  /// Numbers of contacts of the scene whose pairs never lift off; none by default. Pairs in tension have forces and
  /// pressures < 0, and rub as pairs in compression do.
  std::vector<std::size_t> two_sided = {};
};

}  // namespace signorini
