#include "exercise.hpp"

namespace ex20_2 {

Reading read(const std::vector<bool>& /*overlapping*/, const std::vector<Exchange>& /*exchanges*/) {
  return {};  // your code here
}

}  // namespace ex20_2
