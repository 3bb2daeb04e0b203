// What contacts bear along their sources, as curves.
#pragma once
#include <string>
#include <vector>

namespace command_line {

struct SceneRun;

/// What a contact bears over the way along its source.
struct TractionCurve {
  std::string name;  ///< of the contact
  /// A line for each pair: way, pressure, and of a frictional pair its shear traction and the bound on its size.
  std::string csv;
  double from = 0;          ///< way where the first pairs are closed, with a margin
  double to = 0;            ///< and the last
  double most = 0;          ///< largest pressure
  bool frictional = false;  ///< whether any of its pairs does
};

/// \param run  that is solved
/// \return the curve of each contact that has pairs
std::vector<TractionCurve> traction_curves(const SceneRun& run);

}  // namespace command_line
