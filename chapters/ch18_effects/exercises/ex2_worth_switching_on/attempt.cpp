#include "exercise.hpp"

namespace ex18_2 {

std::vector<Change> changes(const Fit& /*fit*/) {
  // your code here: four numbers over p0, sorted
  return {{"body force", 0}, {"edge loads", 0}, {"temperature", 0}, {"friction", 0}};
}

std::vector<std::string> worth_switching_on(const Fit& fit, double /*accuracy*/) {
  std::vector<std::string> names;
  for (const Change& change : changes(fit)) names.push_back(change.effect);
  return names;  // your code here: not all of them
}

}  // namespace ex18_2
