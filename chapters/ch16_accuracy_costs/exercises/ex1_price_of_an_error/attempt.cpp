#include "exercise.hpp"

namespace ex16_1 {

double order(const std::vector<Point>& /*line*/) {
  return 0;  // your code here
}

double price(const std::vector<Point>& line, double factor) {
  return factor * order(line);  // your code here
}

}  // namespace ex16_1
