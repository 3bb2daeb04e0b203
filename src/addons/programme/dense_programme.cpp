#include "addons/programme/dense_programme.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "addons/certified/proofs.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "addons/programme/active_set_programme.hpp"
#include "addons/programme/equation_imbalance.hpp"
#include "addons/programme/equation_split.hpp"
#include "addons/programme/programme_rows.hpp"
#include "addons/programme/proximal_programme.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/triangular.hpp"
#include "signorini/problem/systems.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Rows = std::vector<Index>;

/// Sets to 0 what may be rounding alone.
void without_rounding(VectorXd& gap, const VectorXd& rounding) {
  for (Index i = 0; i < gap.size(); ++i)
    if (std::abs(gap(i)) <= rounding(i)) gap(i) = 0;
}

DenseCondensed condensed_by(ProgrammeRows& data) {
  const ActiveSetFactor equations = data.basis_of({});
  VectorXd gap;
  VectorXd rounding;
  data.gaps(equations, gap, rounding);
  DenseCondensed condensed{data.factor(), {}, {}, data.displacement()};
  const Index first = data.equations();
  condensed.problem.free_gap = gap.tail(data.count() - first);
  condensed.half.setZero(condensed.free_displacement.size(), data.count() - first);
  if (first == data.count()) return condensed;
  ActiveSetFactor::Candidates rows;
  rows.rows.resize(static_cast<std::size_t>(data.count() - first));
  std::iota(rows.rows.begin(), rows.rows.end(), first);
  data.fetch(gap, rounding, rows);
  const auto Q = equations.directions();
  rows.columns -= Q * (Q.transpose() * rows.columns).eval();
  // What is left of a row that depends on the equations, and of a gap that they close, is rounding.
  for (Index i = 0; i < data.count() - first; ++i)
    if (rows.columns.col(i).norm() <= equations.smallest_distance()) rows.columns.col(i).setZero();
  without_rounding(condensed.problem.free_gap, rounding.tail(data.count() - first));
  condensed.half = rows.columns * data.norms().tail(data.count() - first).asDiagonal();
  condensed.problem.compliance = gram(condensed.half);
  return condensed;
}

/// Numbers of the inequalities as numbers of all rows.
VectorXd of_all_rows(const VectorXd& inequalities, Index count) {
  VectorXd all = VectorXd::Zero(count);
  all.tail(inequalities.size()) = inequalities;
  return all;
}

/// What a solver says of the condensed problem, of the programme.
DenseSolution claimed(const DenseCondensed& condensed, const ProgrammeRows& data,
                      ContactState state) {
  DenseSolution solution;
  solution.report = std::move(state.report);
  solution.active = state.active();
  for (Index& row : solution.active) row += data.equations();
  solution.gap = of_all_rows(state.gap, data.count());
  VectorXd pushed = condensed.half * state.force;
  solve_lower_transposed(condensed.factor.lower(), pushed);
  solution.refined.displacement = condensed.free_displacement - pushed;
  solution.refined.force = of_all_rows(state.force, data.count());
  if (state.farkas_certificate.size() > 0)
    solution.farkas_certificate = of_all_rows(state.farkas_certificate, data.count());
  return solution;
}

/// Lets the equations carry what an end without a solution, and a proof, lack of their balance.
void balance_by_equations(const DenseProgramme& programme, ProgrammeRows& data,
                          DenseSolution& solution) {
  const ActiveSetFactor equations = data.basis_of({});
  PrimalDual& last = solution.refined;
  last.force += data.carried(equations, programme.load - programme.stiffness * last.displacement -
                                            programme.A.transpose() * last.force);
  VectorXd& proof = solution.farkas_certificate;
  if (proof.size() > 0) proof -= data.carried(equations, programme.A.transpose() * proof);
}

/// Solves the condensed problem, refines, and solves again while the refinement refutes the set.
DenseSolution solve_condensed(const DenseProgramme& programme, const Solver& solver,
                              const SolverOptions& options) {
  ProgrammeRows data(programme);
  const DenseCondensed condensed = condensed_by(data);
  ContactProblem problem = condensed.problem;
  for (std::set<Rows> refuted;;) {
    DenseSolution solution = claimed(condensed, data, solve_with_proofs(problem, solver, options));
    if (solution.report.status != SolveStatus::Solved) {
      balance_by_equations(programme, data, solution);
      return solution;
    }
    ActiveSetFactor basis = data.basis_of(solution.active);
    VectorXd gap;
    VectorXd rounding;
    data.gaps(basis, gap, rounding);
    ProgrammeRows::Refined refined = data.refine(basis);
    solution.refined = std::move(refined.solution);
    solution.gap = std::move(refined.gap);
    // Rounding cannot decide between sets that come back; the certificate will say whether it matters.
    if (refined.confirmed() || !refuted.insert(solution.active).second) return solution;
    const VectorXd force = solution.refined.force.tail(problem.free_gap.size());
    const VectorXd moved = condensed.half.transpose() * (condensed.half * force);
    problem.free_gap = solution.gap.tail(force.size()) - moved;
    without_rounding(problem.free_gap, epsilon * moved.cwiseAbs());
  }
}

/// Whether the original data confirm that nothing overlaps or pulls, and that forces balance.
bool balanced(const DenseProgramme& programme, const PrimalDual& solution) {
  Certificate certificate = certify(programme, solution);
  certificate.complementarity = certificate.duality_gap = 0;
  return certificate.holds();
}

/// What stands of a claim once the original data have been asked.
DenseSolution confirmed(const DenseProgramme& programme, DenseSolution solution) {
  SolveStatus& status = solution.report.status;
  if (status == SolveStatus::Infeasible &&
      !proves_infeasible(programme, solution.farkas_certificate, solution.refined.displacement)) {
    status = SolveStatus::Breakdown;
    solution.farkas_certificate.resize(0);
  }
  if (status == SolveStatus::Feasible && !balanced(programme, solution.refined))
    status = SolveStatus::Breakdown;
  if (status != SolveStatus::Solved) return solution;
  for (Index i = programme.equations; i < solution.refined.force.size(); ++i)
    solution.refined.force(i) = std::max(0.0, solution.refined.force(i));
  solution.certificate = certify(programme, solution.refined);
  if (!solution.certificate.holds()) status = SolveStatus::Breakdown;
  return solution;
}

/// With springs that make K definite; goldfarb_idnani() stands for methods that do not condense all rows, because its single steps
/// do not prefer rows that nearly depend on others.
DenseSolution by_proximal_points(const DenseProgramme& programme, const Solver& solver,
                                 const SolverOptions& options) {
  return confirmed(
      programme, proximal_solution(programme, [&](const DenseProgramme& near, SolverOptions from) {
        if (on_programmes(solver) == nullptr) return solve_condensed(near, solver, options);
        from.iteration_limit = options.iteration_limit;
        return goldfarb_idnani(near, from);
      }));
}

/// The same where springs do not make K definite, because it is negative across the equations: with a K that is nowhere negative, and
/// forces of the equations from the balance of the programme as it was posed.
DenseSolution by_convex_form(const DenseProgramme& programme, const Solver& solver,
                             const SolverOptions& options) {
  try {
    return by_proximal_points(programme, solver, options);
  } catch (const NotDefinite&) {
    const std::optional<DenseProgramme> convex = convex_form(programme);
    if (!convex) throw;
    DenseSolution solution = by_proximal_points(*convex, solver, options);
    if (solution.report.status == SolveStatus::Solved)
      solution.refined.force.head(programme.equations) =
          equation_forces(programme, solution.refined);
    return confirmed(programme, std::move(solution));
  }
}

/// Solves by itself each system that nothing but rounding connects with the others. Nothing if all is connected or one
/// of them has no solution.
std::optional<DenseSolution> separate_solution(const DenseProgramme& programme,
                                               const Solver& solver, SolverOptions options) {
  const std::vector<SystemParts> systems = unconnected_systems(sparse(programme), {}, {}, epsilon);
  if (systems.empty()) return {};
  options.start.clear();
  DenseSolution whole;
  whole.report.status = SolveStatus::Solved;
  whole.gap.setZero(programme.initial_gap.size());
  whole.refined.force = whole.gap;
  whole.refined.displacement.setZero(programme.load.size());
  whole.refined.displacement_low = whole.refined.displacement;
  for (const SystemParts& parts : systems) {
    const auto own = std::lower_bound(parts.rows.begin(), parts.rows.end(), programme.equations);
    const DenseSolution part =
        solve({programme.stiffness(parts.unknowns, parts.unknowns), programme.load(parts.unknowns),
               programme.A(parts.rows, parts.unknowns), programme.initial_gap(parts.rows),
               static_cast<Index>(own - parts.rows.begin())},
              solver, options);
    if (part.report.status != SolveStatus::Solved) return {};
    append(whole.report, part.report);
    whole.gap(parts.rows) = part.gap;
    whole.refined.force(parts.rows) = part.refined.force;
    whole.refined.displacement(parts.unknowns) = part.refined.displacement;
    if (part.refined.displacement_low.size() > 0)
      whole.refined.displacement_low(parts.unknowns) = part.refined.displacement_low;
    for (const Index row : part.active)
      whole.active.push_back(parts.rows[static_cast<std::size_t>(row)]);
  }
  std::sort(whole.active.begin(), whole.active.end());
  whole.certificate = certify(programme, whole.refined);
  return whole;
}

}  // namespace

DenseCondensed condense(const DenseProgramme& programme) {
  ProgrammeRows data(programme);
  return condensed_by(data);
}

DenseSolution solve(const DenseProgramme& programme, const Solver& solver,
                    const SolverOptions& options) {
  const auto method = on_programmes(solver);
  DenseSolution solution;
  bool definite = true;
  try {
    solution =
        confirmed(programme, method != nullptr ? method(programme, options)
                                               : solve_condensed(programme, solver, options));
  } catch (const NotDefinite&) {
    definite = false;
    solution = by_convex_form(programme, solver, options);
  }
  if (solution.report.status != SolveStatus::Breakdown) return solution;
  std::optional<DenseSolution> other;
  try {
    other = separate_solution(programme, solver, options);
  } catch (const ProblemError&) {  // its numbers would be those of a system
  }
  // K may be definite by its rounding alone.
  if (!other && definite && method != nullptr)
    other = by_proximal_points(programme, solver, options);
  if (!other || !other->certificate.holds()) return solution;
  append(solution.report, other->report);
  other->report = std::move(solution.report);
  return std::move(*other);
}

bool proves_infeasible(const DenseProgramme& programme, const VectorXd& y, const VectorXd& u) {
  return y.size() == programme.initial_gap.size() &&
         proves_infeasible(sparse(programme), y, u, programme.equations);
}

Certificate certify(const DenseProgramme& programme, const PrimalDual& solution) {
  return certify(sparse(programme), solution, {programme.equations, equation_imbalance});
}

QuadraticProgramme sparse(const DenseProgramme& programme) {
  QuadraticProgramme result;
  result.stiffness = programme.stiffness.sparseView();
  result.load = programme.load;
  result.A = programme.A.sparseView();
  result.initial_gap = programme.initial_gap;
  return result;
}

// Only the lower triangle is computed, which takes half of the time, and the upper one is its copy. So the product is symmetric
// to the last bit, and is_symmetric() has no doubt.
Eigen::MatrixXd gram(const Eigen::MatrixXd& half) {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(half.cols(), half.cols());
  product.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

}  // namespace signorini
