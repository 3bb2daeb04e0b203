// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Which steps of a long run its history keeps.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// The history of a million steps would fill the memory, and nobody reads it. So steps are kept more and more sparsely: 0 to
/// 31, then every second one to 63, every fourth one to 127. A table or a picture over the logarithm of the step loses
/// little. The count of steps in the report is exact.
/// \param iteration  from 0
/// \return whether the history keeps it: 0 to 31, then 16 per doubling
[[nodiscard]] inline bool is_kept(Eigen::Index iteration) {
  Eigen::Index spacing = 1;
  while (iteration / spacing >= 32) spacing *= 2;
  return iteration % spacing == 0;
}

}  // namespace signorini
