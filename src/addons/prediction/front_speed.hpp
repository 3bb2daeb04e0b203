// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How fast this machine works through fronts just now.
#pragma once
#include "addons/frontal/fronts.hpp"

namespace signorini {

/// Operations and bytes per second, measured in a few milliseconds; other runs measure others.
struct FrontSpeed {
  double elimination = 0;  ///< on fronts as the factor has them [1/s]
  double carrying = 0;     ///< of rows up such fronts [1/s]
  double memory = 0;       ///< walking through numbers as many as the factor has [byte/s]
};

/// Measures the dense kernels of the factor on fronts of the sizes in which its operations are: those below which
/// a sixth, half, and five sixths of them are done. A very large one is made smaller, to take no longer than
/// some milliseconds; its operations per second no longer depend on its size then.
/// \param fronts  of K
/// \param paths   of the rows of A
/// \return what was measured
[[nodiscard]] FrontSpeed measure_speed(const Fronts& fronts, const RowPaths& paths);

}  // namespace signorini
