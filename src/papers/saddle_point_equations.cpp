// # All unknowns at once
//
// Displacements and contact forces obey equilibrium and one equation per pair,
// \f[ F(u, \lambda) = \begin{pmatrix} K u + A^T\lambda - p \\ \varphi(g - A u, \lambda) \end{pmatrix} = 0, \f]
// where \f$ \varphi \f$ is the Fischer-Burmeister function. Newton's method needs F and its
// derivative J, and this file has both.
//
// The lower rows compare a gap with a force. In which units? As printed, in those of the input:
// then a change from millimetres to metres changes the steps. So gaps are divided, and forces
// multiplied, by the same number for each pair, \f$ \sqrt{s\,c_i} \f$, and both become roots of an
// energy. \f$ c_i = \sum_j A_{ij}^2 / K_{jj} \f$ is the compliance of pair i if its neighbours
// stand still, and s says how much more all pairs together move than one alone.

#include "papers/saddle_point_equations.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/complementarity_functions.hpp"

namespace signorini {
namespace saddle_point {
namespace {

using Eigen::Index, Eigen::VectorXd;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// The largest gap, against that of a pair alone, that forces 1 on all pairs make: from one factor of K, or
// the number of pairs if K is singular to rounding. Forces and gaps are scaled by `units`.
// One factor of K finds s: put the force 1 on every pair, scaled, and look for the largest gap. A
// body that can move freely has no such factor. Then the number of pairs has to do.
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

}  // namespace

// Row j of equilibrium is divided by \f$ \sqrt{K_{jj}} \f$, which makes it a root of an energy too.
// The norm of F then adds up numbers of one unit.
// For the one unknown of [saddle_point_newton.cpp](saddle_point_newton.cpp) both \f$ c_1 \f$ and s
// are 1, and the two forms are the same equations.
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

// The upper rows are linear in both unknowns. They are summed in twice the working precision, so
// that the last steps of the method improve u and do not follow the rounding of a residual.
// The lower rows are one number per pair: zero if the pair is open without force, or closed and
// pressed.
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

// J has the entries of K, those of A twice, once with the slope of \f$ \varphi \f$, and a diagonal.
// It is not symmetric, because the slopes stand on one side only. Of a pair in contact the slopes
// are near (-1, 0), and its row says that the gap does not change; of an open pair they are near
// (0, -1), and its row says that the force does not.
// The lower left block has a minus, because the gap \f$ g - Au \f$ falls with u.
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

// The displacement is kept as a sum of two parts, so that small steps are not lost in it.
// A step in the units of the equations is turned back into displacements and forces.
Point moved(const QuadraticProgramme& programme, const Units& units, const Point& from,
            const VectorXd& step, double length) {
  const Index n = programme.load.size();
  Point to{from.solution, {}, {}};
  add_displacement(to.solution, length * units.row.cwiseProduct(step.head(n)));
  to.solution.force += length * step.tail(step.size() - n).cwiseQuotient(units.force);
  evaluate(programme, units, to);
  return to;
}

}  // namespace saddle_point
}  // namespace signorini
