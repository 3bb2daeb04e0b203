#include "command_line/outcome.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "addons/certified/solve_with_proofs.hpp"
#include "addons/checks/undetermined.hpp"
#include "addons/programme/dense_programme.hpp"
#include "addons/programme/floating_programme.hpp"
#include "command_line/ambiguity.hpp"
#include "command_line/run_monitor.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;

/// Why a solver is not tried; empty if it is.
std::string reason_against(const Solver& solver, Index pairs, bool asymmetric) {
  if (asymmetric && may_fail(solver, Trait::Asymmetric)) return "needs a symmetric matrix";
  return too_many(solver, pairs);
}

std::string names(const std::vector<Outcome>& outcomes) {
  std::string all;
  for (const Outcome& outcome : outcomes)
    all += (all.empty() ? "" : ", ") + std::string(outcome.solver->name);
  return all;
}

/// The solvers that are asked for, with the reasons why some of them are not tried.
std::vector<Outcome> candidates(const std::vector<Solver>& family, const std::string& asked,
                                Index pairs, bool asymmetric) {
  std::vector<Outcome> all;
  for (const Solver& solver : family) {
    Outcome outcome;
    outcome.solver = &solver;
    outcome.word = "not tried";
    outcome.why = reason_against(solver, pairs, asymmetric);
    all.push_back(outcome);
  }
  if (asked == "all") return all;
  const auto chosen = std::find_if(all.begin(), all.end(), [&](const Outcome& outcome) {
    return asked.empty() ? outcome.why.empty() : asked == outcome.solver->name;
  });
  require_input(chosen != all.end() || asked.empty(), "--solver: ", asked,
                " does not take such problems; expected one of ", names(all),
                ", or all of them: all");
  return chosen == all.end() ? all : std::vector<Outcome>{*chosen};
}

/// Runs `run` on a solver, and accepts a solution that the certificate confirms.
template <typename Run>
void attempt(Outcome& outcome, double tolerance, Run&& run) {
  const Progress progress(text("solving by ", outcome.solver->name));
  const auto begin = std::chrono::steady_clock::now();
  try {
    run(outcome);
    outcome.ran = true;
    outcome.accepted =
        outcome.status == SolveStatus::Solved && outcome.certificate.holds(tolerance);
    outcome.word = signorini::to_string(outcome.status);
  } catch (const std::invalid_argument& error) {
    outcome.word = "refused";
    outcome.why = error.what();
  } catch (const ProblemError& error) {
    outcome.word = "refused";
    outcome.why = error.what();
  }
  const auto end = std::chrono::steady_clock::now();
  outcome.seconds = std::chrono::duration<double>(end - begin).count();
}

/// Whether a solver has come to nothing that another one might not come to.
bool lost(const Outcome& outcome) {
  return !outcome.accepted && (!outcome.ran || outcome.status == SolveStatus::Breakdown ||
                               outcome.status == SolveStatus::IterationLimit);
}

/// Whether a solver promises to end with a solution or a proof, but for matrices that are odd and numbers that are bad.
bool promises(const Solver& solver) {
  return !may_fail(solver, Trait::Ordinary) && !may_fail(solver, Trait::Dependent) &&
         !may_fail(solver, Trait::Degenerate) && !may_fail(solver, Trait::Infeasible);
}

/// Runs `run` on each solver that is asked for and can be tried; where none is named and the first is lost, on the next that
/// promise as much.
template <typename Run>
std::vector<Outcome> each(const std::vector<Solver>& family, const std::string& asked, Index pairs,
                          bool asymmetric, double tolerance, Run&& run) {
  std::vector<Outcome> outcomes = candidates(family, asked, pairs, asymmetric);
  for (Outcome& outcome : outcomes)
    if (outcome.why.empty()) attempt(outcome, tolerance, run);
  if (!asked.empty() || outcomes.size() != 1) return outcomes;
  for (Outcome& next : candidates(family, "all", pairs, asymmetric)) {
    if (!lost(outcomes.back())) break;
    const bool again = next.solver == outcomes.front().solver;
    if (again || !next.why.empty() || !promises(*next.solver)) continue;
    attempt(next, tolerance, run);
    outcomes.push_back(std::move(next));
  }
  return outcomes;
}

/// The number with one digit that is not below.
double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)));
  return std::ceil(value / unit) * unit;
}

/// What keeps the certificate of a programme from holding: forces that cancel leave their rounding; or nothing that is known.
std::string lost_digits(const DenseProgramme& programme, const PrimalDual& solution) {
  const Eigen::MatrixXd terms = programme.A.transpose() * solution.force.asDiagonal();
  const double most = terms.size() > 0 ? terms.cwiseAbs().maxCoeff() : 0;
  const double net = std::max(largest(programme.load), largest(terms.rowwise().sum()));
  const double rounding = 0.5 * epsilon * most;
  if (!(largest(equilibrium_residual(sparse(programme), solution)) <=
        static_cast<double>(terms.cols()) * rounding))
    return {};
  return text("; forces up to ", number(most, "%.1e"), " cancel, to ", number(net, "%.1e"),
              ": what rounding of one of them leaves is ", number(ratio(rounding, net), "%.1e"));
}

}  // namespace

Matrix kind_of(const ContactProblem& problem) {
  if (!is_symmetric(problem)) return Matrix::Asymmetric;
  if (!problem.law.pair.empty()) return Matrix::Symmetric;
  const Eigen::MatrixXd& M = problem.compliance;
  const Eigen::VectorXd scale =
      M.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 1.0; });
  const Eigen::MatrixXd scaled = scale.asDiagonal() * M * scale.asDiagonal();
  if (!scaled.allFinite()) return Matrix::Indefinite;
  const Eigen::VectorXd values = symmetric_eigenvalues(scaled);
  const double rounding = static_cast<double>(M.rows()) * epsilon * values.cwiseAbs().maxCoeff();
  if (values.minCoeff() > rounding) return Matrix::PositiveDefinite;
  return values.minCoeff() >= -rounding ? Matrix::PositiveSemidefinite : Matrix::Indefinite;
}

const char* to_string(Matrix kind) {
  switch (kind) {
    case Matrix::PositiveDefinite:
      return "symmetric positive definite";
    case Matrix::PositiveSemidefinite:
      return "symmetric positive semidefinite";
    case Matrix::Indefinite:
      return "symmetric indefinite";
    case Matrix::Symmetric:
      return "symmetric";
    case Matrix::Asymmetric:
      return "not symmetric";
  }
  return "unknown";
}

std::vector<Outcome> solve_all(const ContactProblem& problem, Matrix kind, const std::string& asked,
                               double tolerance) {
  const Index pairs = problem.free_gap.size();
  const Index slips = problem.free_slip.size();
  const auto run = [&](Outcome& outcome) {
    ContactState state = solve_with_proofs(problem, *outcome.solver);
    outcome.status = state.report.status;
    outcome.iterations = state.report.iterations;
    if (state.force.size() == pairs && state.gap.size() == pairs &&
        state.friction.size() == slips && state.slip.size() == slips)
      outcome.certificate = certify(problem, state);
    if (outcome.status == SolveStatus::Solved && outcome.certificate.holds(tolerance))
      outcome.undetermined = ranges_of(undetermined_forces(carried(problem, state)));
    outcome.frictional_pairs = state.frictional_pairs;
    outcome.force = std::move(state.force);
    outcome.gap = std::move(state.gap);
    outcome.why = std::move(state.reason);
    outcome.friction = std::move(state.friction);
    outcome.slip = std::move(state.slip);
    outcome.contact_status = std::move(state.contact_status);
    outcome.uniqueness = state.uniqueness;
    outcome.uniqueness_warning = state.uniqueness_warning;
  };
  return each(slips > 0 ? friction_solvers() : solvers(), asked, pairs,
              kind == Matrix::Asymmetric && slips == 0, tolerance, run);
}

std::vector<Outcome> solve_all(const TwoSidedProgramme& programme, const std::string& asked,
                               double tolerance) {
  const OneSided form = one_sided(programme);
  // Says what no solver could be blamed for.
  if (form.definite) static_cast<void>(condense(form.programme));
  const Index pairs = static_cast<Index>(form.rows.size()) - form.programme.equations;
  return each(solvers(), asked, pairs, false, tolerance, [&](Outcome& outcome) {
    const DenseSolution solution = solve(form.programme, *outcome.solver);
    outcome.status = solution.report.status;
    outcome.iterations = solution.report.iterations;
    outcome.certificate = solution.certificate;
    outcome.unknowns = solution.refined.displacement;
    outcome.force = multipliers(form, solution.refined.force, programme.lower.size());
    outcome.objective = objective(programme, solution.refined);
    // What a method has called a solution has a certificate, which may be good enough for the one who asks.
    const double worst = outcome.certificate.worst();
    if (worst <= tolerance) outcome.status = SolveStatus::Solved;
    if (outcome.status == SolveStatus::Solved && worst <= tolerance)
      outcome.undetermined = undetermined_multipliers(form, solution);
    if (outcome.status == SolveStatus::Breakdown &&
        worst < std::sqrt(epsilon))  // half of the digits
      outcome.why =
          text("--tolerance ", number(rounded_up(worst), "%.0e"), " accepts what ",
               outcome.solver->name, " has come to", lost_digits(form.programme, solution.refined));
  });
}

bool is_solved(const std::vector<Outcome>& outcomes, bool convex) {
  const bool refuted = std::any_of(outcomes.begin(), outcomes.end(), [&](const Outcome& o) {
    return o.ran && ((o.status == SolveStatus::Solved && !o.accepted) ||
                     (convex && o.status == SolveStatus::Infeasible));
  });
  return best(outcomes) != nullptr && !refuted;
}

const Outcome* best(const std::vector<Outcome>& outcomes) {
  const auto found = std::find_if(outcomes.begin(), outcomes.end(),
                                  [](const Outcome& outcome) { return outcome.accepted; });
  return found == outcomes.end() ? nullptr : &*found;
}

}  // namespace command_line
