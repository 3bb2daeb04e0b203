/// \file
/// The method of section 2.4 of the second paper without friction, with f_n as a pressure
/// ([one sign](../ch09_point_to_surface/README.md#box-9-1)):
/// displacements and the pressures of Gauss points together, by Newton's method. The library's own, saddle_point_newton(), has forces
/// as unknowns, all arguments in one unit, and shorter steps where whole ones fail.
#pragma once
#include <vector>

#include "hertz_scene.hpp"
#include "signorini/core/sparse_lu.hpp"
#include "signorini/problem/complementarity_functions.hpp"

namespace signorini {

/// What the paper prints below its table 2, after 16 steps [N, mm].
inline constexpr double printed_residual = 6.13e-9;

/// What the paper leaves open, and a change to J that makes it regular.
struct PrintedEquations {
  double unit = 1;      // a pressure counts as this much gap [mm/MPa]; as printed 1
  double yielding = 0;  // taken from phi's part of J, not from F [mm/MPa]; as printed 0
  int steps = 40;       // all are taken, every step whole
};

/// One run of the method.
struct PrintedRun {
  Model model;
  Eigen::VectorXd pressure;       ///< f_n of every pair [MPa]
  Eigen::VectorXd gap;            ///< of every pair [mm]
  std::vector<double> residuals;  ///< |F| before every step and after the last [N, mm]

  /// \return steps until the residual is at most that which the paper prints; -1 if none is
  [[nodiscard]] int steps() const {
    for (std::size_t k = 0; k < residuals.size(); ++k)
      if (residuals[k] <= printed_residual) return static_cast<int>(k);
    return -1;
  }
};

/// \PaperEq{LinEtAl, 31} with -a: K and the forces of unit pressures above, slopes of phi below.
/// \param run      model and gaps
/// \param forces   on the unknowns, of unit pressures
/// \param how      the method
/// \param springs  on the diagonal of K
/// \return J
inline Eigen::SparseMatrix<double> printed_jacobian(const PrintedRun& run,
                                                    const Eigen::SparseMatrix<double>& forces,
                                                    const PrintedEquations& how,
                                                    const Eigen::VectorXd& springs) {
  const QuadraticProgramme& system = run.model.programme;
  const Eigen::Index n = system.load.size(), pairs = system.initial_gap.size();
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator at(system.stiffness, j); at; ++at)
      entries.emplace_back(at.row(), j, at.value());
    entries.emplace_back(j, j, springs(j));
  }
  for (Eigen::Index i = 0; i < pairs; ++i) {
    const auto slope = fischer_burmeister_slope(run.gap(i), how.unit * run.pressure(i));
    for (Eigen::SparseMatrix<double>::InnerIterator at(forces, i); at; ++at)
      entries.emplace_back(at.row(), n + i, -at.value());
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator at(system.A, i); at; ++at)
      entries.emplace_back(n + i, at.col(), -slope.a * at.value());
    entries.emplace_back(n + i, n + i, slope.b * how.unit - how.yielding);
  }
  Eigen::SparseMatrix<double> J(n + pairs, n + pairs);
  J.setFromTriplets(entries.begin(), entries.end());
  return J;
}

/// \PaperEq{LinEtAl, 42} with +F^C and without friction, from u = 0 and f_n = 0.
///
/// J is singular at this start, as nothing holds the disc. In the first J, not in F, it stands on springs of E* per
/// thickness in all.
/// \param now  the case \param how  the method \return the run
// [printed]
inline PrintedRun run_as_printed(const HertzCase& now, const PrintedEquations& how) {
  Ledger ledger;
  PrintedRun run{build(hertz_scene(now), ledger), {}, {}, {}};
  const auto& [K, external, A, initial_gap, reached] = run.model.programme;
  const Eigen::Index n = external.size(), pairs = initial_gap.size();
  const Eigen::SparseMatrix<double> forces = -(run.model.pairs.weight.asDiagonal() * A).transpose();
  Eigen::VectorXd springs = run.model.modes[0].shape.cwiseAbs2();
  springs *= now.theory().modulus / springs.sum();
  Eigen::VectorXd U = Eigen::VectorXd::Zero(n), F(n + pairs);
  run.pressure = Eigen::VectorXd::Zero(pairs);
  SparseLuFactor factor;
  for (int k = 0;; ++k) {
    run.gap = initial_gap - A * U;
    F.head(n) = K * U - external - forces * run.pressure;  // (42) and (33)-(36)
    for (Eigen::Index i = 0; i < pairs; ++i)               // (37)
      F(n + i) = fischer_burmeister(run.gap(i), how.unit * run.pressure(i));
    run.residuals.push_back(F.norm());
    if (k == how.steps) return run;
    const Eigen::SparseMatrix<double> J =
        printed_jacobian(run, forces, how, (k == 0 ? 1 : 0) * springs);
    if (!factor.factorise(J)) continue;  // no step
    const Eigen::VectorXd step = -factor.solve(F);
    if (!step.allFinite()) continue;
    U += step.head(n);
    run.pressure += step.tail(pairs);
  }
}
// [printed]

/// \param points  Gauss points on an edge, 0 for nodes that carry the pressures \param match  whether the meshes do
/// \return the example with that operator
inline HertzCase example_with(int points, bool match) {
  HertzCase now = match ? HertzCase{} : not_matching();
  now.gap_operator = points > 0 ? "gauss_points" : "mortar";
  now.points = points;
  return now;
}

/// \param now  the case \return a tenth of an edge over E*, to be taken from phi's part of J [mm/MPa]
inline double mending(const HertzCase& now) {
  return 0.1 * now.mesh.core / (static_cast<double>(now.mesh.disc_cells) * now.theory().modulus);
}

}  // namespace signorini
