#include <algorithm>
#include <stdexcept>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"

namespace ex6_4 {

using Eigen::Index;
using Eigen::VectorXd;

Rows closed_nodes(const signorini::ContactProblem& problem) {
  Rows closed;
  for (Index i = 0; i < problem.free_gap.size(); ++i)
    if (problem.free_gap(i) < -1e-3) closed.push_back(i);  // more than a hundredth of a millimetre
  for (int sets = 0; sets < 100; ++sets) {
    VectorXd force = VectorXd::Zero(problem.free_gap.size());
    if (!closed.empty()) {
      const signorini::CholeskyFactor factor(problem.compliance(closed, closed));
      force(closed) = factor.solve(-problem.free_gap(closed));
    }
    const VectorXd gap = problem.free_gap + problem.compliance * force;
    Rows next;
    for (Index i = 0; i < gap.size(); ++i) {
      const bool is_closed = std::binary_search(closed.begin(), closed.end(), i);
      if (is_closed ? force(i) > 1e-6 : gap(i) < -1e-9) next.push_back(i);
    }
    if (next == closed) return closed;
    closed = next;
  }
  throw std::runtime_error("closed_nodes: the sets do not settle");
}

}  // namespace ex6_4
