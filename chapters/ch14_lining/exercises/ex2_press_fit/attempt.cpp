#include "exercise.hpp"

namespace ex14_2 {

FitStress press_fit(const Fit& /*fit*/) {
  // your code here: the interference is what the hub widens and the shaft narrows
  return {0, 0, 0};
}

}  // namespace ex14_2
