// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What is computed of each cell, on as many threads as the program allows, and added up in the order of the cells.
///
/// Neighbouring cells add to the same nodes, and a sum depends on its order. So all that a cell needs for itself, most of the
/// work, is computed whenever a thread is free. The results of some hundred cells are kept, and then taken in the order of the
/// cells. On four threads as on one, a node between cells 3 and 4 gets what cell 3 adds first.
#pragma once
#include <algorithm>
#include <vector>

#include "signorini/core/parts.hpp"
#include "signorini/fem/cells.hpp"

namespace signorini {

/// Calls compute(cell) for every cell of a body, on threads(), and take(cells, results) for runs of cells, in their order.
/// \tparam Result   of a cell
/// \param cells     of the body
/// \param compute   gets a Cell and its Result from before, whose memory it may use again
/// \param take      gets the first number of a run, the one behind its last, and the results, of which the first is that of
///   the first cell
/// \throws what compute() throws, of several cells that of the first
template <typename Result, typename Compute, typename Take>
void visit_results(const Cells& cells, Compute&& compute, Take&& take) {
  constexpr Eigen::Index run = 1024;  // the results of q8 take 2 MB, which stay in the cache
  constexpr Eigen::Index at_a_time = 64;
  std::vector<Result> results(at(std::min(run, cells.count())));
  for (Eigen::Index first = 0; first < cells.count(); first += run) {
    const Eigen::Index count = std::min(run, cells.count() - first);
    for_ranges(count, at_a_time, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index k = begin; k < end; ++k) compute(cells[first + k], results[at(k)]);
    });
    take(first, first + count, results);
  }
}

}  // namespace signorini
