#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "exercise.hpp"

namespace ex19_3 {

Reading read_sweep(const std::vector<Row>& rows) {
  if (rows.size() < 2) throw std::invalid_argument("read_sweep: need two rows");
  double last = 0;
  Reading mine{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0};
  for (const Row& row : rows) {
    if (!(row.parameter > last) || !(row.error > 0) || !(row.condition > 0))
      throw std::invalid_argument("read_sweep: numbers must be positive, parameters increase");
    last = row.parameter;
    mine.floor = std::min(mine.floor, row.error);
  }
  for (auto row = rows.rbegin(); row != rows.rend() && row->error <= 1.1 * mine.floor; ++row)
    mine.enough = row->parameter;
  const Row& end = rows.back();
  const Row& before = rows[rows.size() - 2];
  mine.order =
      std::log(end.condition / before.condition) / std::log(end.parameter / before.parameter);
  return mine;
}

}  // namespace ex19_3
