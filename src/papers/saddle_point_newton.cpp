#include "papers/saddle_point_newton.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/line_search.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/sparse_lu.hpp"
#include "signorini/problem/complementarity_functions.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// What rows and unknowns are multiplied by to have one unit.
struct Units {
  VectorXd row;    ///< of equilibrium; u / row has the unit of energy^1/2
  VectorXd force;  ///< of lambda; gaps are divided by it
};

/// The largest gap, against that of a pair alone, that forces 1 on all pairs make: from one factor of K, or
/// the number of pairs if K is singular to rounding. Forces and gaps are scaled by `units`.
double reach_of(const QuadraticProgramme& programme, const Units& units) {
  const double pairs = static_cast<double>(std::max<Index>(1, units.force.size()));
  const Eigen::SparseMatrix<double> K =
      units.row.asDiagonal() * programme.stiffness * units.row.asDiagonal();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
  const double rounding = static_cast<double>(K.rows() + 1) * epsilon;
  if (K.rows() == 0 || factor.info() != Eigen::Success || factor.vectorD().minCoeff() <= rounding)
    return pairs;
  const VectorXd forces = programme.A.transpose() * units.force.cwiseInverse();
  const VectorXd moved = factor.solve(units.row.cwiseProduct(forces));
  const VectorXd gap =
      (programme.A * units.row.cwiseProduct(moved)).cwiseQuotient(units.force).cwiseAbs();
  const double reach = gap.size() == 0 ? 0 : gap.maxCoeff();
  return reach > 0 && std::isfinite(reach) ? reach : pairs;
}

Units units_of(const QuadraticProgramme& programme, SaddlePointForm form) {
  Units units{VectorXd::Ones(programme.load.size()), VectorXd::Ones(programme.initial_gap.size())};
  if (form == SaddlePointForm::AsPrinted) return units;
  const VectorXd diagonal = programme.stiffness.diagonal();
  for (Index j = 0; j < units.row.size(); ++j)
    if (diagonal(j) > 0) units.row(j) = 1 / std::sqrt(diagonal(j));
  for (Index i = 0; i < units.force.size(); ++i) {
    double compliance = 0;
    for (RowMatrix::InnerIterator at(programme.A, i); at; ++at)
      compliance += std::pow(at.value() * units.row(at.col()), 2);
    if (compliance > 0) units.force(i) = std::sqrt(compliance);
  }
  units.force *= std::sqrt(reach_of(programme, units));
  return units;
}

/// An iterate, and F there: rows and arguments in one unit.
struct Point {
  PrimalDual solution;
  VectorXd gap;
  VectorXd residual;
  double size = 0;  ///< |F|
};

void evaluate(const QuadraticProgramme& programme, const Units& units, Point& point) {
  const Index n = programme.load.size();
  point.gap = gaps(programme, point.solution);
  point.residual.resize(n + point.gap.size());
  point.residual.head(n) = -units.row.cwiseProduct(equilibrium_residual(programme, point.solution));
  for (Index i = 0; i < point.gap.size(); ++i)
    point.residual(n + i) =
        fischer_burmeister(point.gap(i) / units.force(i), point.solution.force(i) * units.force(i));
  point.size = point.residual.norm();
}

/// J in the same units. \PaperEq{LinEtAl, 31}
Eigen::SparseMatrix<double> jacobian(const QuadraticProgramme& programme, const Units& units,
                                     const Point& point) {
  const Index n = programme.load.size();
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(static_cast<std::size_t>(programme.stiffness.nonZeros() +
                                           2 * programme.A.nonZeros() + point.gap.size()));
  const auto add = [&](Index row, Index column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (Index j = 0; j < n; ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator at(programme.stiffness, j); at; ++at)
      add(at.row(), j, units.row(at.row()) * at.value() * units.row(j));
  for (Index i = 0; i < point.gap.size(); ++i) {
    const double unit = units.force(i);
    const ComplementaritySlope slope =
        fischer_burmeister_slope(point.gap(i) / unit, point.solution.force(i) * unit);
    for (RowMatrix::InnerIterator at(programme.A, i); at; ++at) {
      const double value = at.value() * units.row(at.col()) / unit;
      add(at.col(), n + i, value);
      add(n + i, at.col(), -slope.a * value);
    }
    add(n + i, n + i, slope.b);
  }
  Eigen::SparseMatrix<double> J(n + point.gap.size(), n + point.gap.size());
  J.setFromTriplets(entries.begin(), entries.end());
  return J;
}

/// The point a part of a step away.
Point moved(const QuadraticProgramme& programme, const Units& units, const Point& from,
            const VectorXd& step, double length) {
  const Index n = programme.load.size();
  Point to{from.solution, {}, {}};
  add_displacement(to.solution, length * units.row.cwiseProduct(step.head(n)));
  to.solution.force += length * step.tail(step.size() - n).cwiseQuotient(units.force);
  evaluate(programme, units, to);
  return to;
}

/// Goes as far as Armijo's rule allows for |F|^2; an exact step promises the slope -2 |F|^2 of it.
/// \return false if it falls no more
bool search(const QuadraticProgramme& programme, const Units& units, const VectorXd& step,
            Point& point) {
  Point trial;
  const auto merit_at = [&](double length) {
    trial = moved(programme, units, point, step, length);
    return trial.size * trial.size;
  };
  const double merit = point.size * point.size;
  if (armijo(merit, -2 * merit, merit_at) == 0) return false;
  std::swap(point, trial);
  return true;
}

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

/// One step of the method.
/// \return false if J is singular or |F| falls no more; the point is where it was
bool step_on(const QuadraticProgramme& programme, const Units& units, SparseLuFactor& factor,
             bool whole, Point& point) {
  const Eigen::SparseMatrix<double> J = jacobian(programme, units, point);
  if (!factor.factorise(J)) return false;
  const VectorXd step = factor.solve(-point.residual);
  // A factor of a singular J gives a step that does not even solve for half of F.
  if (!step.allFinite() || (J * step + point.residual).norm() > 0.5 * point.size) return false;
  if (!whole) return search(programme, units, step, point);
  point = moved(programme, units, point, step, 1);
  return true;
}

}  // namespace

SaddlePointSolution saddle_point_newton(const QuadraticProgramme& programme,
                                        const SaddlePointOptions& options) {
  const Index n = programme.load.size();
  const bool as_printed = options.form == SaddlePointForm::AsPrinted;
  const Units units = units_of(programme, options.form);
  Point point{{VectorXd::Zero(n), VectorXd::Zero(n), start(programme, options)}, {}, {}};
  evaluate(programme, units, point);
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
