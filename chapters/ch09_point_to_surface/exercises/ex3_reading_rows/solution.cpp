#include <algorithm>
#include <stdexcept>

#include "exercise.hpp"

namespace ex9_3 {

Reading reading_of(const Row& row) {
  const auto of_source = [](const Entry& entry) { return entry.of_source; };
  if (std::count_if(row.begin(), row.end(), of_source) != 1)
    throw std::invalid_argument("reading_of: expected one node of the source in a row");
  const Entry source = *std::find_if(row.begin(), row.end(), of_source);
  Reading reading{source.node, source.x, source.y, {}};
  for (const Entry& entry : row) {
    const double N = -(entry.x * reading.nx + entry.y * reading.ny);
    if (N > 1e-12) reading.shares.push_back({entry.node, N});
  }
  std::sort(reading.shares.begin(), reading.shares.end(),
            [](const Share& a, const Share& b) { return a.node < b.node; });
  return reading;
}

std::vector<double> reached(const std::vector<Row>& rows, const std::vector<double>& force,
                            const std::vector<int>& nodes) {
  if (force.size() != rows.size())
    throw std::invalid_argument("reached: expected as many forces as rows");
  std::vector<double> sums(nodes.size(), 0);
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const Share& share : reading_of(rows[k]).shares)
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i] == share.node) sums[i] += share.N * force[k];
  return sums;
}

std::vector<int> untouched(const std::vector<Row>& rows, const std::vector<int>& nodes) {
  const std::vector<double> sums = reached(rows, std::vector<double>(rows.size(), 1), nodes);
  std::vector<int> found;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (sums[i] == 0) found.push_back(nodes[i]);
  return found;
}

}  // namespace ex9_3
