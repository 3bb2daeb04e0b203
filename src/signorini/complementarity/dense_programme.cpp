#include "signorini/complementarity/dense_programme.hpp"

#include <utility>

#include "signorini/complementarity/refine.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {

using Eigen::Index;

DenseCondensed condense(const DenseProgramme& programme) {
  const Index n = programme.load.size();
  const Index m = programme.initial_gap.size();
  require(programme.stiffness.rows() == n && programme.stiffness.cols() == n &&
              programme.A.rows() == m && programme.A.cols() == n,
          "quadratic programme: K must be ", n, " x ", n, " and A ", m, " x ", n, ", got ",
          programme.stiffness.rows(), " x ", programme.stiffness.cols(), " and ",
          programme.A.rows(), " x ", programme.A.cols());
  require(programme.stiffness.allFinite() && programme.load.allFinite() &&
              programme.A.allFinite() && programme.initial_gap.allFinite(),
          "quadratic programme: K, p, A and g must be finite");
  DenseCondensed condensed{Eigen::LLT<Eigen::MatrixXd>(programme.stiffness), {}, {}};
  if (condensed.factor.info() != Eigen::Success)
    throw ProblemError(
        "quadratic programme: K is not positive definite, so the least energy may have no limit; "
        "add equations that hold the free directions");
  condensed.free_displacement = condensed.factor.solve(programme.load);
  condensed.problem.half = condensed.factor.matrixL().solve(programme.A.transpose());
  condensed.problem.free_gap = programme.initial_gap - programme.A * condensed.free_displacement;
  return condensed;
}

DenseSolution solve(const DenseProgramme& programme, const Solver& solver,
                    const SolverOptions& options) {
  const DenseCondensed condensed = condense(programme);
  ContactState state = solver.solve_half != nullptr
                           ? solver.solve_half(condensed.problem, options)
                           : solver.solve(multiplied_out(condensed.problem), options);
  DenseSolution solution;
  solution.report = std::move(state.report);
  solution.active = std::move(state.active);
  solution.infeasibility = std::move(state.infeasibility);
  solution.refined.force = std::move(state.force);
  solution.gap = std::move(state.gap);
  solution.refined.displacement =
      condensed.factor.solve(programme.load - programme.A.transpose() * solution.refined.force);
  if (solution.report.status != Status::Solved) return solution;
  const QuadraticProgramme original = sparse(programme);
  Refinement refined = refine(
      original, [&](const Eigen::VectorXd& f) { return condensed.factor.solve(f).eval(); },
      multiplied_out(condensed.problem).compliance, std::move(solution.refined), solution.active);
  solution.refined = std::move(refined.solution);
  solution.gap = std::move(refined.gap);
  solution.certificate = certify(original, solution.refined);
  return solution;
}

QuadraticProgramme sparse(const DenseProgramme& programme) {
  require(programme.equations == 0, "sparse: equations have no place in this form, got ",
          programme.equations);
  QuadraticProgramme result;
  result.stiffness = programme.stiffness.sparseView();
  result.load = programme.load;
  result.A = programme.A.sparseView();
  result.initial_gap = programme.initial_gap;
  return result;
}

}  // namespace signorini
