#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex7_3 {

static void require_rows(const std::vector<Row>& rows) {
  if (rows.size() < 2 || rows[0].angle != 0)
    throw std::invalid_argument("a bearing has two rows or more, and the first is the pole");
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (!(rows[k].angle > rows[k - 1].angle && rows[k].angle <= 180))
      throw std::invalid_argument("the angles must rise, to 180 at most");
}

static double along_the_pole(const Row& row) {
  return 2 * row.force * std::cos(row.angle * std::acos(-1.0) / 180);
}

double load_carried(const std::vector<Row>& rows) {
  require_rows(rows);
  double sum = 0;
  for (const Row& row : rows) sum += along_the_pole(row);
  return sum;
}

bool rightly_held(const std::vector<Row>& rows) {
  require_rows(rows);
  return rows[0].force >= 0;
}

End end_of_contact(const std::vector<Row>& rows) {
  require_rows(rows);
  for (std::size_t k = rows.size(); k > 0; --k)
    if (rows[k - 1].force > 0) return {rows[k - 1].angle, k < rows.size() ? rows[k].angle : 180};
  throw std::invalid_argument("end_of_contact: no node has a force");
}

double piece_of(const std::vector<Row>& rows, std::size_t k) {
  require_rows(rows);
  if (k >= rows.size()) throw std::invalid_argument("piece_of: there is no such row");
  return rows[k].pressure == 0 ? 0 : rows[k].force / rows[k].pressure;
}

double half_within(const std::vector<Row>& rows) {
  const double load = load_carried(rows);
  if (!(load > 0)) throw std::invalid_argument("half_within: the load is not positive");
  double sum = 0;
  for (const Row& row : rows) {
    sum += along_the_pole(row);
    if (sum >= load / 2) return row.angle;
  }
  return rows.back().angle;
}

}  // namespace ex7_3
