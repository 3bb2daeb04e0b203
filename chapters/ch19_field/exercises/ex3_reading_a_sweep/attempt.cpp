#include "exercise.hpp"

namespace ex19_3 {

Reading read_sweep(const std::vector<Row>& rows) {
  Reading mine;  // your code here
  mine.enough = rows.front().parameter;
  return mine;
}

}  // namespace ex19_3
