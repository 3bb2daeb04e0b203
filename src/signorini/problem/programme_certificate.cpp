// What a solution of a programme leaves, and what that is measured by.
#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/imbalance.hpp"
#include "signorini/problem/systems.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Whether the part of u that is claimed to be rigid strains a body. Rows are measured by the largest motion of their own
/// neighbourhood: how far another body moves must hide nothing. By its own terms a row near a node that hardly moves would be
/// measured by the rounding of motions that are larger.
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

/// Whether a force is claimed for a row of A that is empty and so cannot carry any. A slip that supports give has an
/// empty row, too, and friction on the support that resists it.
bool pushes_on_nothing(const QuadraticProgramme& programme, const VectorXd& norm,
                       const VectorXd& force, Index pairs) {
  for (Index row = 0; row < force.size(); ++row)
    if (norm(row) == 0 && force(row) != 0 && (row < pairs || programme.initial_gap(row) == 0))
      return true;
  return false;
}

/// The force phi: the largest load or net contact force on an unknown, since contact forces that cancel may be large without
/// meaning anything. Where no load acts and u in two doubles cannot resolve the contact forces, it is the largest
/// \f$ K_{jj} |u_j| \f$, which the displacements could make.
double force_size(const QuadraticProgramme& programme, const VectorXd& contact, const VectorXd& u) {
  const double load = largest(programme.load);
  const double most = std::max(load, largest(contact));
  const double inside = largest(programme.stiffness.diagonal().cwiseProduct(u));
  const double half = 0.5 * epsilon;  // what rounding takes of a number
  return load == 0 && most <= half * half * inside ? inside : most;
}

/// The length l: how far a displacement goes towards the obstacle in the sum of its terms, since a far obstacle has nothing to do
/// with it; or how far p - A^T lambda, where that is more than rounding, would move the stiffest unknown, since contact may hold
/// all that moves.
double length_of(const QuadraticProgramme& programme, const VectorXd& contact, const VectorXd& u,
                 const VectorXd& unit) {
  const double most = std::max(largest(programme.load), largest(contact));
  const double sum = largest(programme.load - contact);
  const bool rounding = sum <= static_cast<double>(contact.size()) * epsilon * most;
  double length = ratio(rounding ? most : sum, largest(programme.stiffness.diagonal()));
  for (Index row = 0; row < programme.A.rows(); ++row) {
    double terms = 0;
    for (RowMatrix::InnerIterator entry(programme.A, row); entry; ++entry)
      terms += std::abs(entry.value() * u(entry.col()));
    length = std::max(length, terms / unit(row));
  }
  return length;
}

/// The certificate of one system: gaps, of which some are equations, and slips.
/// \param imbalance  p - K u - A^T lambda
/// \param movement   g - A u
Certificate certificate_of(const QuadraticProgramme& programme, const PrimalDual& solution,
                           const VectorXd& imbalance, const VectorXd& movement,
                           const FrictionLaw& law, Index equations) {
  const Index slips = static_cast<Index>(law.pair.size());
  VectorXd norm(programme.A.rows());
  for (Index row = 0; row < norm.size(); ++row) norm(row) = programme.A.row(row).norm();
  // An entry of K, p, A or g that is not finite leaves none of its sums finite, whatever it is multiplied by.
  if (!imbalance.allFinite() || !movement.allFinite() || !solution.displacement.allFinite() ||
      !solution.force.allFinite() || !solution.displacement_low.allFinite() ||
      strains(programme.stiffness, solution.rigid) ||
      pushes_on_nothing(programme, norm, solution.force, norm.size() - slips))
    return uncertified();
  const VectorXd contact = programme.A.transpose() * solution.force;
  VectorXd u = solution.displacement;
  if (solution.displacement_low.size() > 0) u += solution.displacement_low;
  ClaimResiduals left{solution.force, movement, (norm.array() == 0).select(1.0, norm)};
  left.force_size = force_size(programme, contact, u);
  left.length = length_of(programme, contact, u, left.unit);
  left.equilibrium = std::max(ratio(largest(imbalance), left.force_size),
                              own_imbalance(programme, solution, imbalance, equations));
  left.free = programme.initial_gap;
  left.load =
      programme.load - programme.A.bottomRows(slips).transpose() * solution.force.tail(slips);
  left.position = solution.displacement;
  left.imbalance = imbalance;
  return certify(left, law, equations);
}

/// p and what displacements of other systems add to it through entries of K that are weak.
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

/// v of these places, or nothing if it is empty.
VectorXd entries(const VectorXd& v, const std::vector<Index>& places) {
  return v.size() == 0 ? v : VectorXd(v(places));
}

/// The worst figures of all systems, each measured by its own length and force. An entry of K up to epsilon sqrt(K_ii K_jj)
/// connects none: it adds to no energy more than rounding does.
Certificate certificate_of(const QuadraticProgramme& programme, const PrimalDual& solution,
                           const FrictionLaw& law, Index equations) {
  const VectorXd imbalance = equilibrium_residual(programme, solution);
  const VectorXd movement = gaps(programme, solution);
  const std::vector<SystemParts> systems = unconnected_systems(programme, law, {}, epsilon);
  if (systems.empty())
    return certificate_of(programme, solution, imbalance, movement, law, equations);
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
    const auto own = std::lower_bound(rows.begin(), rows.end(), equations) - rows.begin();
    worst = worst_of(worst, certificate_of(alone, part, imbalance(unknowns), movement(rows),
                                           part_of(law, pairs, parts), own));
  }
  return worst;
}

}  // namespace

Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                    Index equations) {
  check_sizes(programme, solution);
  require_argument(equations >= 0 && equations <= programme.initial_gap.size(),
                   "certify: equations must be 0 to ", programme.initial_gap.size(), ", got ",
                   equations);
  return certificate_of(programme, solution, {}, equations);
}

Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                    const FrictionLaw& law) {
  check_sizes(programme, solution);
  const Index slips = static_cast<Index>(law.pair.size());
  check_law(law, programme.A.rows() - slips, slips);
  return certificate_of(programme, solution, law, 0);
}

}  // namespace signorini
