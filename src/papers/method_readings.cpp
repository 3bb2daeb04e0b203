// # Readings of one method
//
// A paper prints a method in words and formulas, and numbers that its program has computed. Words can
// be read in several ways. Each way is a program, and each program leaves its mark on the numbers. If
// forces \f$ \lambda \f$ balance the load, their displacements have the energy
// \f[ \pi = -\tfrac12 p^T K^{-1} p + \tfrac12 \lambda^T G \lambda, \f]
// whatever program has found them. Forces of one weighted gap have at most the energy of the solution:
// they are a lower bound, and leave overlaps. Forces that are added up and never taken back have more,
// and leave gaps.
//
// An example with two pairs, the zigzag of the outer loop:
// \f[ G = \begin{pmatrix} 1 & -1 \\ -1 & 2 \end{pmatrix}, \quad d = (-2, 1), \quad \lambda^* = (3, 1),
// \quad \tfrac12 \lambda^{*T} G \lambda^* = \tfrac52. \f]
// To the letter, all weight goes from the first pair to the second, which alone needs no force: the
// energy 0. Each row once, the loop ends at (2, 1/2), with the energy 5/4, and the first pair still
// overlaps by 1/2. With the rows again and again it tends to the solution, as here both rows are tight
// in the end.

#include "papers/method_readings.hpp"

#include <algorithm>

#include "papers/weight_iteration.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Rows = QuasiActiveRows;

// Where all violated rows are independent, the choices by number and by overlap are the choice of all.
// That saves two of three runs for most problems.
bool took_all(const QuasiActiveRun& run) {
  return std::all_of(run.steps.begin(), run.steps.end(), [](const QuasiActiveStep& step) {
    return step.quasi_active == step.violated;
  });
}

}  // namespace

// A rule makes so many steps and is stopped, wherever it is. The literal rule stops by itself when a
// vertex comes back, others at the solution. No row is scaled: the paper scales none.
VectorXd stopped_weights(const ContactProblem& problem, WeightRule rule, Index steps) {
  check_plain(problem, "stopped_weights");
  WeightIteration run(problem, rule);
  for (Index k = 0; k < steps && run.step();) ++k;
  return run.total_force() * run.weights();
}

// With the moved minimum the present gaps take the place of the first ones. What the weights leave
// undone in one step overlaps a little in the next. Nearly closed pairs are pressed again and again,
// so forces that are too large stay, as in the loop with exact steps.
VectorXd loop_of_stopped_weights(const ContactProblem& problem, Index steps, double tolerance) {
  check_plain(problem, "loop_of_stopped_weights");
  VectorXd force = VectorXd::Zero(problem.free_gap.size());
  VectorXd gap = problem.free_gap;
  const double small = tolerance * std::max(0.0, -gap.minCoeff());
  for (int k = 0; k < 1000; ++k) {
    std::vector<Index> rows;
    for (Index i = 0; i < gap.size(); ++i)
      if (gap(i) < -small) rows.push_back(i);
    if (rows.empty()) break;
    const ContactProblem part{problem.compliance(rows, rows), gap(rows)};
    force(rows) += stopped_weights(part, WeightRule::Harmonic, steps);
    gap = problem.free_gap + problem.compliance * force;
  }
  return force;
}

// Between u^k and u^{k+1} a gap changes in proportion to the way. A pair that overlaps at u^k is not
// met on it. In the zigzag, (33) leads from (2, 1/2) back to no forces at all, and no pair is met.
VectorXd last_step_to_open_pairs(const ContactProblem& problem, const QuasiActiveRun& run) {
  if (run.next.size() == 0) return run.state.force;
  const VectorXd before = problem.free_gap + problem.compliance * run.moved;
  const VectorXd after = problem.free_gap + problem.compliance * run.next;
  double fraction = 1;
  for (const Index i : run.left_over)
    if (before(i) >= 0) fraction = std::min(fraction, before(i) / (before(i) - after(i)));
  return run.moved + fraction * (run.next - run.moved);
}

// Weights as printed, sets as printed, then what stops early. A loop may need thousands of steps to come
// within rounding of its limit. After a thousand it is stopped, and its last step is left out.
std::vector<MethodReading> method_readings(const ContactProblem& problem) {
  SolverOptions options;
  options.iteration_limit = 1000;  // outer steps, each a solved problem
  const auto run = [&](Rows rows, QuasiActivePool pool) {
    return run_quasi_active_set_literal(problem, options, rows, pool);
  };
  const QuasiActiveRun by_number = run(Rows::IndependentByIndex, QuasiActivePool::AllPairs);
  const auto force_of = [&](Rows rows) {
    return took_all(by_number) ? by_number.state.force
                               : run(rows, QuasiActivePool::AllPairs).state.force;
  };
  const QuasiActiveRun once = run(Rows::AllViolated, QuasiActivePool::UnusedPairs);
  return {
      {"letter", "(28) to the letter", stopped_weights(problem, WeightRule::LiteralVertex, 1000)},
      {"all", "loop, all violated rows", force_of(Rows::AllViolated)},
      {"number", "loop, independent by number", by_number.state.force},
      {"overlap", "loop, independent by overlap", force_of(Rows::IndependentByViolation)},
      {"most", "loop, the most violated row",
       run(Rows::MostViolated, QuasiActivePool::AllPairs).state.force},
      {"once", "loop, each row once, (34) as printed", once.state.force},
      {"met", "loop, each row once, (34) for rows it meets", last_step_to_open_pairs(problem, once)},
      {"loop", "loop, 2/(k+2), 1000 steps each", loop_of_stopped_weights(problem, 1000, 1e-4)},
      {"hundred", "weights, 2/(k+2), 100 steps", stopped_weights(problem, WeightRule::Harmonic, 100)},
      {"thousand", "weights, 2/(k+2), 1000 steps", stopped_weights(problem, WeightRule::Harmonic, 1000)},
      {"search", "weights, line search, 1000 steps", stopped_weights(problem, WeightRule::LineSearch, 1000)}};
}

}  // namespace signorini
