#include <algorithm>
#include <stdexcept>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"

namespace ex5_6 {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Lines {
  VectorXd start, slope;  // of gaps of open pairs and of forces of closed ones, over the load
};

Lines lines_of(const Loaded& body, const std::vector<Index>& closed) {
  Lines lines{body.initial_gap, -body.response};
  if (closed.empty()) return lines;
  const MatrixXd& G = body.compliance;
  const signorini::CholeskyFactor factor(G(closed, closed));
  const VectorXd start = factor.solve(-body.initial_gap(closed));
  const VectorXd slope = factor.solve(body.response(closed));
  const MatrixXd columns = G(Eigen::all, closed);
  lines.start += columns * start;
  lines.slope += columns * slope;
  lines.start(closed) = start;
  lines.slope(closed) = slope;
  return lines;
}

}  // namespace

Path load_path(const Loaded& body, double until) {
  const Index n = body.initial_gap.size();
  if (body.response.size() != n || body.compliance.rows() != n || body.compliance.cols() != n)
    throw std::invalid_argument("load_path: sizes do not fit");
  if (!(body.initial_gap.array() > 0).all())
    throw std::invalid_argument("load_path: all pairs are open at first");
  Path path;
  std::vector<Index> closed;
  for (double load = 0;;) {
    const Lines lines = lines_of(body, closed);
    Index next = -1;
    double at = until;
    for (Index i = 0; i < n; ++i) {
      if (!(lines.slope(i) < 0)) continue;  // also that of the pair that has just changed
      const double zero = std::max(load, -lines.start(i) / lines.slope(i));
      if (zero >= at) continue;
      next = i;
      at = zero;
    }
    if (next < 0) {
      path.force.setZero(n);
      for (const Index i : closed) path.force(i) = lines.start(i) + until * lines.slope(i);
      return path;
    }
    const auto place = std::lower_bound(closed.begin(), closed.end(), next);
    const bool closes = place == closed.end() || *place != next;
    path.events.push_back({at, next, closes});
    if (closes)
      closed.insert(place, next);
    else
      closed.erase(place);
    load = at;
  }
}

}  // namespace ex5_6
