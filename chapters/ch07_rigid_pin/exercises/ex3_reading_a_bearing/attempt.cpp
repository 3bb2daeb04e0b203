#include "exercise.hpp"

namespace ex7_3 {

double load_carried(const std::vector<Row>& rows) {
  double sum = 0;
  for (const Row& row : rows) sum += row.force;  // your code here: along the pole, and both halves
  return sum;
}

bool rightly_held(const std::vector<Row>& /*rows*/) {
  return true;  // your code here
}

End end_of_contact(const std::vector<Row>& /*rows*/) {
  return {0, 180};  // your code here
}

double piece_of(const std::vector<Row>& /*rows*/, std::size_t /*k*/) {
  return 0;  // your code here
}

double half_within(const std::vector<Row>& /*rows*/) {
  return 180;  // your code here
}

}  // namespace ex7_3
