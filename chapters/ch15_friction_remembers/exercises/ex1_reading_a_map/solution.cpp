#include <algorithm>
#include <limits>

#include "exercise.hpp"

namespace ex15_1 {

using Eigen::Index;
using signorini::ContactStatus;

double stuck_half_width(const Map& map, std::size_t row) {
  const std::vector<ContactStatus>& contact_status = map.rows.at(row);
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (Index i = 0; i < map.x.size(); ++i) {
    if (contact_status[static_cast<std::size_t>(i)] != ContactStatus::Stick) continue;
    first = std::min(first, map.x(i));
    last = std::max(last, map.x(i));
  }
  return std::max(0.0, 0.5 * (last - first));
}

std::vector<std::size_t> turns(const Map& map) {
  std::vector<std::size_t> found;
  for (std::size_t row = 1; row < map.rows.size(); ++row) {
    bool turned = false;
    for (std::size_t i = 0; i < map.rows[row].size(); ++i) {
      const ContactStatus before = map.rows[row - 1][i], now = map.rows[row][i];
      const bool slid =
          before == ContactStatus::SlipForward || before == ContactStatus::SlipBackward;
      if (slid && now != before && now != ContactStatus::Open) turned = true;
    }
    if (turned) found.push_back(row);
  }
  return found;
}

std::vector<Index> always_stuck(const Map& map) {
  std::vector<Index> found;
  for (Index i = 0; i < map.x.size(); ++i) {
    const auto sticks = [i](const std::vector<ContactStatus>& row) {
      return row[static_cast<std::size_t>(i)] == ContactStatus::Stick;
    };
    if (std::all_of(map.rows.begin(), map.rows.end(), sticks)) found.push_back(i);
  }
  return found;
}

}  // namespace ex15_1
