// What a page calls: live_answer() computes, live_data() and live_size() give the numbers of its arrays, -1 behind the last.
#include <cstddef>

#include "live/figure.hpp"

namespace {
std::vector<Eigen::VectorXd> arrays;  // of the last answer
}

extern "C" {
const char* live_answer(const char* words) {
  static std::string last;
  last = live::answer(words, arrays);
  return last.c_str();
}
const double* live_data(int array) { return arrays[static_cast<std::size_t>(array)].data(); }
int live_size(int array) {
  const auto k = static_cast<std::size_t>(array);
  return k < arrays.size() ? static_cast<int>(arrays[k].size()) : -1;
}
}
