#include "exercise.hpp"

namespace ex15_1 {

double stuck_half_width(const Map& map, std::size_t row) {
  const std::vector<signorini::ContactStatus>& contact_status = map.rows.at(row);
  return contact_status.empty() ? 0 : map.x.maxCoeff();  // your code here: only what sticks
}

std::vector<std::size_t> turns(const Map& /*map*/) {
  return {};  // your code here
}

std::vector<Eigen::Index> always_stuck(const Map& /*map*/) {
  return {};  // your code here
}

}  // namespace ex15_1
