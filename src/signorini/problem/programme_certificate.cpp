// # The certificate with displacements
//
// A programme is given by K, p, A and g, and a claim by u and the forces.
// [residual.cpp](residual.cpp) computes what they leave, \f$ p - Ku - A^T\lambda \f$ and
// \f$ g - Au \f$. This file finds the force \f$ \varphi \f$ and the length \f$ \ell \f$ that these
// are measured by. If they are too large, they hide errors. If they are too small, rounding becomes
// an error.
//
// Three traps:
//
// - An obstacle at the distance 1e6 makes g large, and its pair has no part in the problem. So
//   displacements make the length, and g does not.
// - Two wedges may hold each other with forces of 1e9 that cancel on every node. So the net force
//   \f$ A^T\lambda \f$ counts, and single forces do not.
// - Two bodies that never meet may have loads of 1e12 and 1. Beside the first one, the second one
//   may be wrong by 100 per cent and has a figure of 1e-12. So each system is measured by itself.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/imbalance.hpp"
#include "signorini/problem/systems.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// The rigid part of u is not multiplied by K when the equilibrium is computed. A false claim could
// hide strains there. So \f$ Ku_r \f$ must be rounding, row by row, of the stiffness of the row times the
// largest motion of its neighbours: another body that moves far must hide nothing. The terms of the
// row alone are too little: near a node that hardly moves they are the rounding of larger motions.
bool strains(const SparseMatrix& K, const VectorXd& rigid) {
  for (Index row = 0; row < rigid.size(); ++row) {
    double force = 0;
    double stiffness = 0;
    double motion = 0;
    for (SparseMatrix::InnerIterator it(K, row); it; ++it) {
      force += it.value() * rigid(it.row());
      stiffness += std::abs(it.value());
      motion = std::max(motion, std::abs(rigid(it.row())));
    }
    if (!(std::abs(force) <= certificate_tolerance * stiffness * motion)) return true;
  }
  return false;
}

// A row of A without entries cannot carry a force, because the force would appear in no
// equilibrium. A slip that supports prescribe also has an empty row. There friction acts on the
// support, and it is allowed.
bool pushes_on_nothing(const QuadraticProgramme& programme, const VectorXd& norm,
                       const VectorXd& force, Index pairs) {
  for (Index row = 0; row < force.size(); ++row)
    if (norm(row) == 0 && force(row) != 0 && (row < pairs || programme.initial_gap(row) == 0))
      return true;
  return false;
}

// The largest load or net contact force. Without loads, contact forces can be so small beside K
// that even u in two doubles cannot resolve them. Then the largest force that a displacement makes
// takes their place.
double force_size(const QuadraticProgramme& programme, const VectorXd& diagonal,
                  const VectorXd& contact, const VectorXd& u) {
  const double load = largest(programme.load);
  const double most = std::max(load, largest(contact));
  const double inside = largest(diagonal.cwiseProduct(u));
  const double half = 0.5 * epsilon;  // what rounding takes of a number
  return load == 0 && most <= half * half * inside ? inside : most;
}

// How far the displacements go towards the obstacle, as the sum of the magnitudes of all terms,
// since each term is rounded; or the way of loads, if that is longer.
double length_of(const QuadraticProgramme& programme, const VectorXd& diagonal, const VectorXd& contact,
                 const VectorXd& u, const VectorXd& unit) {
  double length = 0, nearest = std::numeric_limits<double>::infinity();
  for (Index row = 0; row < programme.A.rows(); ++row) {
    double terms = 0;
    for (RowMatrix::InnerIterator entry(programme.A, row); entry; ++entry)
      terms += std::abs(entry.value() * u(entry.col()));
    length = std::max(length, terms / unit(row));
    const double gap = std::abs(programme.initial_gap(row)) / unit(row);
    if (gap > 0) nearest = std::min(nearest, gap);
  }
  return std::max(length, way_of_loads(programme.load, contact, diagonal, u, nearest));
}

// The figures of one system, some of whose gaps may be equations. Rows of A are measured as if
// scaled to length 1: a gap that is written in millimetres must get the figures of the same gap in
// metres.
//
// Friction forces do work on given slips, and in the duality gap they count as loads.
Certificate certificate_of(const QuadraticProgramme& programme, const PrimalDual& solution, const VectorXd& diagonal,
                           const VectorXd& imbalance, const VectorXd& movement, const FrictionLaw& law,
                           const EquationRows& equations) {
  const Index slips = static_cast<Index>(law.pair.size());
  VectorXd norm(programme.A.rows());
  for (Index row = 0; row < norm.size(); ++row) norm(row) = programme.A.row(row).norm();
  // An entry of K, p, A or g that is not finite leaves none of its sums finite, whatever it is
  // multiplied by.
  if (!imbalance.allFinite() || !movement.allFinite() || !solution.displacement.allFinite() ||
      !solution.force.allFinite() || !solution.displacement_low.allFinite() ||
      strains(programme.stiffness, solution.rigid) ||
      pushes_on_nothing(programme, norm, solution.force, norm.size() - slips))
    return uncertified();
  const VectorXd contact = programme.A.transpose() * solution.force;
  VectorXd u = solution.displacement;
  if (solution.displacement_low.size() > 0) u += solution.displacement_low;
  ClaimResiduals left{solution.force, movement, (norm.array() == 0).select(1.0, norm)};
  left.force_size = force_size(programme, diagonal, contact, u);
  const Reached& reached = programme.reached;
  if (reached.displacement.size() > 0) u = u.cwiseAbs() + reached.displacement.cwiseAbs();
  left.length = length_of(programme, diagonal, contact, u, left.unit);
  left.equilibrium =
      std::max(ratio(largest(imbalance), std::max(left.force_size, largest(reached.terms))),
               own_imbalance(programme, solution, imbalance, diagonal, equations));
  left.free = programme.initial_gap;
  left.load =
      programme.load - programme.A.bottomRows(slips).transpose() * solution.force.tail(slips);
  left.position = solution.displacement;
  left.imbalance = imbalance;
  return certify(left, law, equations.count);
}

// An entry of K that is no more than rounding of its diagonal connects no systems. What it
// transmits still acts, as a load on the other system.
VectorXd loads_of_systems(const QuadraticProgramme& programme, const PrimalDual& solution,
                          const std::vector<SystemParts>& systems) {
  const VectorXd u = strained(solution);
  Eigen::VectorXi system(u.size());
  for (std::size_t k = 0; k < systems.size(); ++k)
    system(systems[k].unknowns).setConstant(static_cast<int>(k));
  VectorXd load = programme.load;
  for (Index j = 0; j < u.size(); ++j)
    for (SparseMatrix::InnerIterator it(programme.stiffness, j); it; ++it)
      if (system(it.row()) != system(j)) load(it.row()) -= it.value() * u(j);
  return load;
}

// Picks the entries of one system out of a vector of the whole. The second part and the rigid part of u may be
// empty, which means zero, and stay empty.
VectorXd entries(const VectorXd& v, const std::vector<Index>& places) {
  return v.size() == 0 ? v : VectorXd(v(places));
}

// The residuals are computed once, of the whole. Each system then takes its entries of them, with
// its own length and force, and the worst figures count. An entry of K up to
// \f$ \varepsilon\sqrt{K_{ii}K_{jj}} \f$ connects nothing: it adds no more to any energy than
// rounding does. Whether anything is unconnected, and the diagonal, may be known from the load before:
// of a hundred loads on one scene the first asks, and for the others it is as true.
Certificate certificate_of(const QuadraticProgramme& programme, const PrimalDual& solution, const FrictionLaw& law,
                           const EquationRows& equations, const KnownMatrices* known) {
  const VectorXd imbalance = equilibrium_residual(programme, solution);
  const VectorXd movement = gaps(programme, solution);
  std::vector<SystemParts> systems;
  if (known == nullptr || !known->connected)
    systems = unconnected_systems(programme, law, {}, epsilon);
  const bool kept = known != nullptr && known->diagonal.size() > 0;
  if (systems.empty())
    return certificate_of(programme, solution, kept ? known->diagonal : VectorXd(programme.stiffness.diagonal()),
                          imbalance, movement, law, equations);
  const VectorXd load = loads_of_systems(programme, solution, systems);
  const Index pairs = programme.A.rows() - static_cast<Index>(law.pair.size());
  Certificate worst;
  for (const SystemParts& parts : systems) {
    const std::vector<Index>& unknowns = parts.unknowns;
    const std::vector<Index>& rows = parts.rows;
    QuadraticProgramme alone = part_of(programme, parts);
    alone.load = load(unknowns);
    const PrimalDual part{entries(solution.displacement, unknowns),
                          entries(solution.displacement_low, unknowns),
                          entries(solution.force, rows), entries(solution.rigid, unknowns)};
    const Index own = std::lower_bound(rows.begin(), rows.end(), equations.count) - rows.begin();
    worst = worst_of(worst, certificate_of(alone, part, alone.stiffness.diagonal(),
                                           imbalance(unknowns), movement(rows),
                                           part_of(law, pairs, parts), {own, equations.imbalance}));
  }
  return worst;
}

}  // namespace

// Contact may hold all that moves. Then u is 0, and the length is how
// far the forces that the body has to bear would move its stiffest unknown. If these forces are
// rounding too, the largest force takes their place. Where K is weak they would move it
// much further than anything goes, so that way counts up to the largest u. Without this bound a weight of 1 on a spring
// of 1e-20 would forgive every overlap: its way is 1e20, and a claim of u = 0 is rounding of that. If all of u is rounding
// of it, the nearest gap that is not 0 is a length of the problem too: a claim of u = 0 must not measure that gap by a
// way that nothing goes.
double way_of_loads(const VectorXd& load, const VectorXd& contact, const VectorXd& diagonal, const VectorXd& u,
                    double nearest) {
  const double most = std::max(largest(load), largest(contact)), sum = largest(load - contact);
  const double rounding = static_cast<double>(contact.size()) * epsilon * most;
  const double way = ratio(sum <= rounding ? most : sum, largest(diagonal)), far = largest(u);
  const bool at_rest = std::isfinite(way) && far <= epsilon * way;
  return std::min(way, at_rest ? std::max(far, nearest) : far);
}

// Without friction the first rows may be equations: their forces may have any sign. Contact has none; who
// solves programmes with equations brings along how their forces are measured.
Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                    const EquationRows& equations) {
  check_sizes(programme, solution);
  require_argument(equations.count >= 0 && equations.count <= programme.initial_gap.size(),
                   "certify: equations must be 0 to ", programme.initial_gap.size(), ", got ",
                   equations.count);
  return certificate_of(programme, solution, {}, equations, nullptr);
}

// With friction the last rows of A are slips, as many as the law has pairs.
Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                    const FrictionLaw& law, const KnownMatrices* known) {
  check_sizes(programme, solution);
  const Index slips = static_cast<Index>(law.pair.size());
  check_law(law, programme.A.rows() - slips, slips);
  return certificate_of(programme, solution, law, {}, known);
}

}  // namespace signorini
