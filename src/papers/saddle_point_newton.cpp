// # Newton's method on the whole system
//
// One unknown with \f$ K = 1 \f$, \f$ p = 2 \f$ and a stop at \f$ g = 1 \f$: the solution is
// \f$ u = 1 \f$ with the force 1. The equations are
// \f[ u + \lambda - 2 = 0, \qquad \varphi(1 - u, \lambda) = 0. \f]
// From nothing the first step ignores the stop, because the pair is open. The next ones push back:
//
//     step    u        force
//     1       2        0
//     2       1.3333   0.6667
//     3       1.0680   0.9320
//     4       1.0025   0.9975
//
// Equilibrium holds from the first step on, as it is linear. Near the end each step doubles the
// digits.
//
// What the method costs is a factor of the whole Jacobian in every step. The condensed methods of
// the library factor K once.

#include "papers/saddle_point_newton.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "papers/saddle_point_equations.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/line_search.hpp"
#include "signorini/core/sparse_lu.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using saddle_point::Point;
using saddle_point::Units;

// Goes as far as Armijo's rule allows for |F|^2; an exact step promises the slope -2 |F|^2 of it.
// \return false if it falls no more
// A whole step may overshoot where \f$ \varphi \f$ bends. The residual is the measure: it has to
// fall.
bool search(const QuadraticProgramme& programme, const Units& units, const VectorXd& step,
            Point& point) {
  Point trial;
  const auto merit_at = [&](double length) {
    trial = saddle_point::moved(programme, units, point, step, length);
    return trial.size * trial.size;
  };
  const double merit = point.size * point.size;
  if (armijo(merit, -2 * merit, merit_at) == 0) return false;
  std::swap(point, trial);
  return true;
}

// A pair counts as closed if its scaled force exceeds its scaled gap. The history tells how many
// there are and how many have changed.
Iteration summary(const Units& units, const Point& point, const std::vector<bool>& last,
                  std::vector<bool>& closed, double first) {
  Iteration entry{};
  const VectorXd& force = point.solution.force;
  for (Index i = 0; i < force.size(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    closed[k] = force(i) * units.force(i) > point.gap(i) / units.force(i);
    entry.active += closed[k] ? 1 : 0;
    entry.changes += closed[k] != last[k] ? 1 : 0;
    entry.penetration = std::max(entry.penetration, -point.gap(i));
    entry.tension = std::max(entry.tension, -force(i));
  }
  entry.residual = first == 0 ? 0 : point.size / first;
  return entry;
}

/// The forces to start from.
VectorXd start(const QuadraticProgramme& programme, const SaddlePointOptions& options) {
  const Index pairs = programme.initial_gap.size();
  if (options.start_force.size() == 0) return VectorXd::Zero(pairs);
  require_argument(options.start_force.size() == pairs && options.start_force.allFinite(),
                   "saddle_point_newton: need ", pairs, " finite forces to start from, got ",
                   options.start_force.size());
  return options.start_force;
}

// One step of the method.
// \return false if J is singular or |F| falls no more; the point is where it was
// The factor of a matrix that is singular up to rounding exists and is of no use. Its step is
// recognised by the system that it does not solve.
bool step_on(const QuadraticProgramme& programme, const Units& units, SparseLuFactor& factor,
             bool whole, Point& point) {
  const Eigen::SparseMatrix<double> J = saddle_point::jacobian(programme, units, point);
  if (!factor.factorise(J)) return false;
  const VectorXd step = factor.solve(-point.residual);
  // A factor of a singular J gives a step that does not even solve for half of F.
  if (!step.allFinite() || (J * step + point.residual).norm() > 0.5 * point.size) return false;
  if (!whole) return search(programme, units, step, point);
  point = saddle_point::moved(programme, units, point, step, 1);
  return true;
}

}  // namespace

// The two forms differ in when they stop. In the printed form we stop when F is small compared with its
// start, as the paper names no test, and what there is then is tested by the certificate. In one unit
// the certificate itself decides.
SaddlePointSolution saddle_point_newton(const QuadraticProgramme& programme,
                                        const SaddlePointOptions& options) {
  const Index n = programme.load.size();
  const bool as_printed = options.form == SaddlePointForm::AsPrinted;
  const Units units = saddle_point::units_of(programme, options.form);
  Point point{{VectorXd::Zero(n), VectorXd::Zero(n), start(programme, options)}, {}, {}};
  saddle_point::evaluate(programme, units, point);
  const double first = point.size;
  std::vector<bool> closed(static_cast<std::size_t>(point.gap.size()));
  Report report;
  report.status = SolveStatus::Breakdown;
  SparseLuFactor factor;
  const auto done = [&] {
    return as_printed ? point.size <= options.tolerance * first
                      : certify(programme, point.solution).holds(options.tolerance);
  };
  while (!done()) {
    if (report.iterations >= options.iteration_limit) {
      report.status = SolveStatus::IterationLimit;
      return {std::move(point.solution), std::move(report)};
    }
    ++report.iterations;
    ++report.factorisations;
    // Equilibrium is linear: from the first step on, which is whole, it holds.
    if (!step_on(programme, units, factor, as_printed || report.iterations == 1, point)) {
      if (!as_printed) return {std::move(point.solution), std::move(report)};
      break;
    }
    const std::vector<bool> last = closed;
    report.history.push_back(summary(units, point, last, closed, first));
  }
  if (!as_printed || certify(programme, point.solution).holds())
    report.status = SolveStatus::Solved;
  return {std::move(point.solution), std::move(report)};
}

}  // namespace signorini
