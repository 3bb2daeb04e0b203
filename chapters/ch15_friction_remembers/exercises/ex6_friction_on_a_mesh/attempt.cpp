#include "exercise.hpp"

namespace ex15_6 {

std::vector<Pair> pairs_of(const signorini::SolvedScene& run) {
  std::vector<Pair> pairs;
  for (Eigen::Index i = 0; i < run.solution.contact.force.size(); ++i)
    pairs.push_back({run.model.pairs.position(i, 0), run.solution.contact.gap(i),
                     run.solution.contact.force(i)});  // your code here: what friction does
  return pairs;
}

std::vector<State> states_of(const std::vector<Pair>& pairs) {
  return std::vector<State>(pairs.size(), State::Stick);  // your code here
}

Breach breach_of(const std::vector<Pair>& /*pairs*/) {
  return {};  // your code here
}

}  // namespace ex15_6
