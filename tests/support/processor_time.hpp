// Seconds of the processor, for what compares the prices of two ways.
#pragma once
#include <ctime>

namespace signorini_test {

/// \return processor time of this program so far [s]: what others do on the machine does not count
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

}  // namespace signorini_test
