#include "signorini/problem/friction.hpp"

#include "signorini/core/errors.hpp"

namespace signorini {

void check_problem(const FrictionProblem& problem) {
  const Eigen::Index n = problem.free_gap.size();
  const Eigen::Index modes = problem.resultant.size();
  require(problem.free_slip.size() == n && problem.coefficient.size() == n &&
              problem.cohesion.size() == n,
          "friction problem: free_slip, coefficient and cohesion need one entry per pair, ", n,
          ", got ", problem.free_slip.size(), ", ", problem.coefficient.size(), " and ",
          problem.cohesion.size());
  require(problem.compliance.rows() == 2 * n && problem.compliance.cols() == 2 * n,
          "friction problem: compliance must be ", 2 * n, " x ", 2 * n,
          " (all gaps, then all slips), got ", problem.compliance.rows(), " x ",
          problem.compliance.cols());
  require(modes == 0 ? problem.rigid.cols() == 0
                     : problem.rigid.rows() == 2 * n && problem.rigid.cols() == modes,
          "friction problem: rigid must be ", 2 * n, " x ", modes,
          " (one column per entry of resultant), got ", problem.rigid.rows(), " x ",
          problem.rigid.cols());
  for (Eigen::Index i = 0; i < n; ++i)
    require(problem.coefficient(i) >= 0 && problem.cohesion(i) >= 0, "friction problem: pair ",
            i + 1, " has the friction coefficient ", problem.coefficient(i), " and the cohesion ",
            problem.cohesion(i), "; both must be >= 0");
  require(problem.coefficient.allFinite() && problem.cohesion.allFinite() &&
              problem.rigid.allFinite() && problem.resultant.allFinite(),
          "friction problem: coefficient, cohesion, rigid and resultant must be finite");
  Eigen::VectorXd free(2 * n);
  free << problem.free_gap, problem.free_slip;
  check_problem(ContactProblem{problem.compliance, free});
}

}  // namespace signorini
