/// \file
/// The ways to solve Hertz's contact that the first figure compares, and a point of it.
#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "papers/saddle_point_newton.hpp"
#include "papers/solver_table.hpp"
#include "runs.hpp"
#include "signorini/core/errors.hpp"

namespace ch16 {

/// What is compared: an element, an operator and a solver each.
struct Way {
  std::string name, element, gap_operator, solver;
  int points = 0;     // Gauss points of an operator that wants them
  bool meet = false;  // whether the nodes of disc and plate do
};

inline const std::string newton = "saddle_point_newton";  // as in Lin et al.: not condensed
inline const std::vector<Way> ways = {
    {"q4_incompatible", "q4_incompatible", "mortar", "primal_dual_active_set"},
    {"nodes that meet", "q4_incompatible", "mortar", "primal_dual_active_set", 0, true},
    {"q4", "q4", "mortar", "primal_dual_active_set"},
    {"q8", "q8", "mortar", "primal_dual_active_set"},
    {"nodes on segments", "q4_incompatible", "node_to_segment", "primal_dual_active_set"},
    {"two Gauss points", "q4_incompatible", "gauss_points", "quasi_active_set", 2},
    {"the same by sweeps", "q4_incompatible", "gauss_points", "projected_gauss_seidel", 2},
    {"not condensed", "q4_incompatible", "mortar", newton}};

/// \param cells  of the disc on 1.3 half-widths \return the scene
inline Scene scene_of(const Way& way, Index cells) {
  HertzProblem problem;
  problem.mesh = meshes(cells, way.meet ? cells : std::max<Index>(1, cells * 13 / 16));
  problem.element = way.element;
  problem.gap_operator = way.gap_operator;
  if (way.solver != newton) problem.solver = find_solver(way.solver);
  Scene scene = signorini_test::scene_of(problem);
  scene.contacts[0].points = way.points;
  return scene;
}

/// A point of the figure.
struct Point {
  double unknowns = 0, error = 0, operations = 0, seconds = 0;
  bool solved = false;
};

/// \param run  of the figure's contact \return its point, without seconds
inline Point point_of(const SolvedScene& run) {
  Point point;
  point.unknowns = static_cast<double>(run.model.unknowns.count);
  point.solved = run.solution.contact.report.status == SolveStatus::Solved;
  if (!point.solved) return point;
  point.operations = operations(run.solution.ledger);
  point.error = pressure_error(pressures(run), HertzProblem().theory());
  return point;
}

/// The price of an error: between two meshes, errors and costs are powers of each other.
/// \param line  from coarse to fine \param error  in percent \param cost  to be paid \return it; 0 if no two meshes have the
///   error between them
inline double price(const std::vector<Point>& line, double error, double Point::*cost) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Point &a = line[k - 1], &b = line[k];
    if (!a.solved || !b.solved || a.error < error || b.error > error) continue;
    const double share = std::log(a.error / error) / std::log(a.error / b.error);
    return a.*cost * std::pow(b.*cost / (a.*cost), share);
  }
  return 0;
}

/// The second paper's method in the place of condensing; it starts from an even pressure with the condensed sum.
inline void solve_uncondensed(SolvedScene& run) {
  const Eigen::VectorXd& weight = run.model.pairs.weight;
  SaddlePointOptions options;  // an even pressure, or nothing would hold the disc
  options.start_force = run.solution.contact.force.sum() * weight / weight.sum();
  const SaddlePointSolution found = saddle_point_newton(run.model.programme, options);
  if (found.report.status != SolveStatus::Solved)
    throw NotSolved("Newton's method found no solution");
  run.solution.contact.force = found.solution.force;
}

/// From the scene to certified forces, the median of three runs. \return a point
inline Point measured(const Way& way, Index cells) {
  Point point;
  const Scene scene = scene_of(way, cells);
  std::vector<double> took;
  while (took.size() < 3 && (took.empty() || took[0] < 1)) {  // long ones once
    double begin = processor_seconds();
    Ledger ledger;
    Model model = build(scene, ledger);
    const double built = processor_seconds();
    Condensed condensed = condense(model, ledger);
    Solution solution = solve(model, condensed, ledger);
    SolvedScene run{std::move(model), std::move(condensed), std::move(solution)};
    if (way.solver == newton) {
      begin += processor_seconds() - built;  // what it does without
      solve_uncondensed(run);
    }
    took.push_back(processor_seconds() - begin);
    point = point_of(run);
  }
  point.seconds = quantile(took, 0.5);
  return point;
}

}  // namespace ch16
