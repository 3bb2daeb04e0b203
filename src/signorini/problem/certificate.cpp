#include "signorini/problem/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_sum.hpp"
#include "signorini/problem/imbalance.hpp"
#include "signorini/problem/systems.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Whether u carries a second, smaller part.
bool has_low(const PrimalDual& solution) { return solution.displacement_low.size() > 0; }

void check_sizes(const QuadraticProgramme& programme, const PrimalDual& solution) {
  const Index n = programme.load.size();
  const Index pairs = programme.initial_gap.size();
  require_argument(programme.stiffness.rows() == n && programme.stiffness.cols() == n &&
                       programme.A.rows() == pairs && programme.A.cols() == n,
                   "certify: K must be ", n, " x ", n, " and A ", pairs, " x ", n, ", got ",
                   programme.stiffness.rows(), " x ", programme.stiffness.cols(), " and ",
                   programme.A.rows(), " x ", programme.A.cols());
  require_argument(solution.displacement.size() == n && solution.force.size() == pairs &&
                       (!has_low(solution) || solution.displacement_low.size() == n) &&
                       (solution.rigid.size() == 0 || solution.rigid.size() == n),
                   "certify: need ", n, " displacements and ", pairs, " forces, got ",
                   solution.displacement.size(), " and ", solution.force.size());
}

/// u without its rigid part, as the sum of two vectors: those of the solution where they serve.
class Strained {
 public:
  explicit Strained(const PrimalDual& solution)
      : high_(solution.displacement.data()), low_(solution.displacement_low.data()) {
    const Index n = solution.displacement.size();
    const bool rigid = solution.rigid.size() > 0;
    if (rigid || !has_low(solution)) {
      own_low_ = has_low(solution) ? solution.displacement_low : Eigen::VectorXd::Zero(n);
      low_ = own_low_.data();
    }
    if (!rigid) return;
    own_high_.resize(n);
    high_ = own_high_.data();
    for (Index i = 0; i < n; ++i) {
      ExactSum difference(solution.displacement(i));
      difference.add(-solution.rigid(i));
      own_high_(i) = difference.high();
      own_low_(i) += difference.low();
    }
  }
  ~Strained() = default;
  Strained(const Strained&) = delete;
  Strained& operator=(const Strained&) = delete;
  Strained(Strained&&) = delete;
  Strained& operator=(Strained&&) = delete;

  [[nodiscard]] double high(Index unknown) const { return high_[unknown]; }
  [[nodiscard]] double low(Index unknown) const { return low_[unknown]; }

 private:
  Eigen::VectorXd own_high_;
  Eigen::VectorXd own_low_;
  const double* high_;
  const double* low_;
};

/// Whether this and the next column of K have entries in the same rows, as the unknowns of a node mostly have.
bool twins(const Eigen::SparseMatrix<double>& K, Index column) {
  if (column + 1 >= K.cols() || !K.isCompressed()) return false;
  const int* const outer = K.outerIndexPtr() + column;
  const int* const inner = K.innerIndexPtr();
  return outer[1] - outer[0] == outer[2] - outer[1] &&
         std::equal(inner + outer[0], inner + outer[1], inner + outer[1]);
}

/// p - K u of one row, or of two that are twins side by side. K has both triangles, so columns serve as rows.
template <int rows>
void subtract_stiffness(const QuadraticProgramme& programme, const Strained& u, Index row,
                        std::vector<ExactSum>& sums) {
  using Numbers = Eigen::Array<double, rows, 1>;
  const Eigen::SparseMatrix<double>& K = programme.stiffness;
  const double* const values = K.valuePtr() + K.outerIndexPtr()[row];
  const int* const inner = K.innerIndexPtr() + K.outerIndexPtr()[row];
  const Index count = K.col(row).nonZeros();
  ExactSumOf<Numbers> sum(programme.load.segment<rows>(row), Numbers::Zero());
  Numbers small = Numbers::Zero();
  for (Index k = 0; k < count; ++k) {
    Numbers entry;
    for (int r = 0; r < rows; ++r) entry(r) = values[r * count + k];
    sum.add_product(-entry, Numbers::Constant(u.high(inner[k])));
    small += entry * u.low(inner[k]);
  }
  sum.add(-small);
  for (int r = 0; r < rows; ++r) sums.emplace_back(sum.high()(r), sum.low()(r));
}

/// Scales of one problem: a length and a force.
struct Scales {
  double length = 0;
  double force = 0;
};

/// Norms of the rows of A; 1 for an empty row.
Eigen::VectorXd row_norms(const RowMatrix& A) {
  Eigen::VectorXd norm(A.rows());
  for (Index pair = 0; pair < A.rows(); ++pair) {
    norm(pair) = A.row(pair).norm();
    if (norm(pair) == 0) norm(pair) = 1;
  }
  return norm;
}

/// The largest load or net contact force on an unknown, and the largest length: of a displacement towards the obstacle,
/// or of what the largest sum of both would move the stiffest unknown by; or the force, where those sums are rounding.
/// Neither counts what may be large without meaning anything: the gap of a far obstacle, contact forces that cancel, or
/// how far a load would move what contact holds.
Scales scales_of(const QuadraticProgramme& programme, const PrimalDual& solution,
                 const Eigen::VectorXd& norm) {
  const Eigen::VectorXd contact = programme.A.transpose() * solution.force;
  const Eigen::VectorXd diagonal = programme.stiffness.diagonal();
  Eigen::VectorXd u = solution.displacement;
  if (has_low(solution)) u += solution.displacement_low;
  Scales scale;
  scale.force = std::max(largest(programme.load), largest(contact));
  const Eigen::VectorXd sum = programme.load - contact;
  const double moving = largest(sum) <= static_cast<double>(sum.size()) * epsilon * scale.force
                            ? scale.force
                            : largest(sum);
  scale.length = ratio(moving, largest(diagonal));
  for (Index pair = 0; pair < programme.A.rows(); ++pair) {
    double length = 0;
    for (RowMatrix::InnerIterator entry(programme.A, pair); entry; ++entry)
      length += std::abs(entry.value() * u(entry.col()));
    scale.length = std::max(scale.length, length / norm(pair));
  }
  // Without a load, contact forces that u in two doubles cannot resolve are measured by those that the
  // displacements could make.
  if (largest(programme.load) == 0) {
    const double inside = largest(diagonal.cwiseProduct(u));
    const double half = 0.5 * epsilon;  // what rounding takes of a number
    if (scale.force <= half * half * inside) scale.force = inside;
  }
  return scale;
}

/// Whether the part of u that is claimed to be rigid strains a body. Rows are measured by the largest motion of
/// their own neighbourhood: how far another body moves must hide nothing.
bool strains(const QuadraticProgramme& programme, const Eigen::VectorXd& rigid) {
  if (rigid.size() == 0) return false;
  for (Index row = 0; row < rigid.size(); ++row) {
    double force = 0;
    double stiffness = 0;
    double motion = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator it(programme.stiffness, row); it; ++it) {
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
bool pushes_on_nothing(const QuadraticProgramme& programme, const Eigen::VectorXd& force,
                       Index pairs) {
  for (Index row = 0; row < force.size(); ++row)
    if (force(row) != 0 && programme.A.row(row).norm() == 0 &&
        (row < pairs || programme.initial_gap(row) == 0))
      return true;
  return false;
}

/// |u^T K u - p^T u + lambda^T g| over the sum of the energies, or `least` if that is larger; friction
/// forces count as loads.
double duality_gap(const QuadraticProgramme& programme, const PrimalDual& solution, Index pairs,
                   const Eigen::VectorXd& residual, const Eigen::VectorXd& movement, double least) {
  ExactSum energy;  // as lambda^T gap - u^T (p - K u - A^T lambda)
  double energies = 0;
  for (Index pair = 0; pair < pairs; ++pair) {
    energy.add_product(solution.force(pair), movement(pair));
    energies += std::abs(solution.force(pair) * programme.initial_gap(pair));
  }
  const Index slips = programme.A.rows() - pairs;
  const Eigen::VectorXd load =
      programme.load - programme.A.bottomRows(slips).transpose() * solution.force.tail(slips);
  for (Index i = 0; i < residual.size(); ++i) {
    energy.add_product(-residual(i), solution.displacement(i));
    energies += std::abs(load(i) * solution.displacement(i));
  }
  return ratio(std::abs(energy.value()), std::max(energies, least));
}

/// What a solution leaves of K, p, A and g.
struct Left {
  Eigen::VectorXd residual;  ///< of the equilibrium
  Eigen::VectorXd movement;  ///< gaps, then slips
};

/// The certificate of one system: gaps, of which some are equations, and slips.
Certificate figures_of_system(const QuadraticProgramme& programme, const PrimalDual& solution,
                              const Left& left, const FrictionLaw& law, Index equations) {
  const Eigen::VectorXd& residual = left.residual;
  const Eigen::VectorXd& movement = left.movement;
  // An entry of K, p, A or g that is not finite leaves none of its sums finite, whatever it is multiplied by.
  if (!residual.allFinite() || !movement.allFinite() || !solution.displacement.allFinite() ||
      !solution.force.allFinite() || !solution.displacement_low.allFinite() ||
      pushes_on_nothing(programme, solution.force,
                        programme.A.rows() - static_cast<Index>(law.pair.size())) ||
      strains(programme, solution.rigid))
    return uncertified();
  const Eigen::VectorXd norm = row_norms(programme.A);
  const Scales scale = scales_of(programme, solution, norm);
  const Index slips = static_cast<Index>(law.pair.size());
  Certificate certificate =
      pair_figures({solution.force, movement, norm, scale.force, scale.length}, law, equations);
  certificate.equilibrium = std::max(ratio(largest(residual), scale.force),
                                     own_imbalance(programme, solution, residual, equations));
  certificate.duality_gap = duality_gap(programme, solution, movement.size() - slips, residual,
                                        movement, scale.length * scale.force);
  return certificate;
}

/// v of these places, or nothing if it is empty.
Eigen::VectorXd entries(const Eigen::VectorXd& v, const std::vector<Index>& places) {
  return v.size() == 0 ? v : Eigen::VectorXd(v(places));
}

/// An entry of K up to this share of sqrt(K_ii K_jj) adds to no energy more than rounding does.
constexpr double weak_coupling = epsilon;

/// p and what displacements of other systems add to it through entries of K that are weak.
Eigen::VectorXd loads_of_systems(const QuadraticProgramme& programme, const PrimalDual& solution,
                                 const std::vector<SystemParts>& systems) {
  const Eigen::VectorXd u = strained(solution);
  std::vector<std::size_t> system(static_cast<std::size_t>(u.size()));
  for (std::size_t k = 0; k < systems.size(); ++k)
    for (const Index unknown : systems[k].unknowns) system[static_cast<std::size_t>(unknown)] = k;
  Eigen::VectorXd load = programme.load;
  for (Index j = 0; j < u.size(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(programme.stiffness, j); it; ++it)
      if (system[static_cast<std::size_t>(it.row())] != system[static_cast<std::size_t>(j)])
        load(it.row()) -= it.value() * u(j);
  return load;
}

/// The worst figures of all systems, each measured by its own lengths and forces.
Certificate all_figures(const QuadraticProgramme& programme, const PrimalDual& solution,
                        const FrictionLaw& law, Index equations) {
  const Left left{equilibrium_residual(programme, solution), gaps(programme, solution)};
  const std::vector<SystemParts> systems = unconnected_systems(programme, law, {}, weak_coupling);
  if (systems.empty()) return figures_of_system(programme, solution, left, law, equations);
  const Eigen::VectorXd load = loads_of_systems(programme, solution, systems);
  const Index pairs = programme.A.rows() - static_cast<Index>(law.pair.size());
  Certificate worst;
  for (const SystemParts& parts : systems) {
    const PrimalDual part{entries(solution.displacement, parts.unknowns),
                          entries(solution.displacement_low, parts.unknowns),
                          entries(solution.force, parts.rows),
                          entries(solution.rigid, parts.unknowns)};
    const auto own = std::lower_bound(parts.rows.begin(), parts.rows.end(), equations);
    QuadraticProgramme alone = part_of(programme, parts);
    alone.load = load(parts.unknowns);
    const Certificate now =
        figures_of_system(alone, part, {left.residual(parts.unknowns), left.movement(parts.rows)},
                          part_of(law, pairs, parts), static_cast<Index>(own - parts.rows.begin()));
    for (double Certificate::*figure :
         {&Certificate::penetration, &Certificate::tension, &Certificate::complementarity,
          &Certificate::equilibrium, &Certificate::duality_gap, &Certificate::cone,
          &Certificate::sliding})
      if (now.*figure > worst.*figure || std::isnan(now.*figure)) worst.*figure = now.*figure;
  }
  return worst;
}

}  // namespace

void add_displacement(PrimalDual& solution, const Eigen::VectorXd& change) {
  for (Index i = 0; i < change.size(); ++i)
    add_to(solution.displacement(i), solution.displacement_low(i), change(i));
}

Certificate uncertified() {
  const double infinity = std::numeric_limits<double>::infinity();
  return {infinity, infinity, infinity, infinity, infinity, infinity, infinity, infinity};
}

double Certificate::worst() const {
  double most = 0;
  for (const double figure :
       {penetration, tension, complementarity, equilibrium, duality_gap, cone, sliding, balance}) {
    if (std::isnan(figure)) return std::numeric_limits<double>::infinity();
    most = std::max(most, figure);
  }
  return most;
}

Eigen::VectorXd strained(const PrimalDual& solution) {
  Eigen::VectorXd u = solution.displacement;
  if (solution.rigid.size() > 0) u -= solution.rigid;
  if (has_low(solution)) u += solution.displacement_low;
  return u;
}

Eigen::VectorXd equilibrium_residual(const QuadraticProgramme& programme,
                                     const PrimalDual& solution) {
  check_sizes(programme, solution);
  const Strained u(solution);
  std::vector<ExactSum> sum;
  sum.reserve(static_cast<std::size_t>(programme.load.size()));
  for (Index i = 0; i < programme.load.size(); ++i)
    if (twins(programme.stiffness, i))
      subtract_stiffness<2>(programme, u, i++, sum);
    else
      subtract_stiffness<1>(programme, u, i, sum);
  for (Index pair = 0; pair < programme.A.rows(); ++pair)
    for (RowMatrix::InnerIterator entry(programme.A, pair); entry; ++entry)
      sum[static_cast<std::size_t>(entry.col())].add_product(-entry.value(), solution.force(pair));
  Eigen::VectorXd residual(programme.load.size());
  for (Index i = 0; i < residual.size(); ++i)
    residual(i) = sum[static_cast<std::size_t>(i)].value();
  return residual;
}

Eigen::VectorXd gaps(const QuadraticProgramme& programme, const PrimalDual& solution) {
  check_sizes(programme, solution);
  Eigen::VectorXd gap(programme.initial_gap.size());
  for (Index pair = 0; pair < gap.size(); ++pair) {
    ExactSum sum(programme.initial_gap(pair));
    for (RowMatrix::InnerIterator entry(programme.A, pair); entry; ++entry) {
      sum.add_product(-entry.value(), solution.displacement(entry.col()));
      if (has_low(solution)) sum.add(-entry.value() * solution.displacement_low(entry.col()));
    }
    gap(pair) = sum.value();
  }
  return gap;
}

Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                    Index equations) {
  check_sizes(programme, solution);
  require_argument(equations >= 0 && equations <= programme.initial_gap.size(),
                   "certify: equations must be 0 to ", programme.initial_gap.size(), ", got ",
                   equations);
  return all_figures(programme, solution, {}, equations);
}

Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                    const FrictionLaw& law) {
  check_sizes(programme, solution);
  const Index slips = static_cast<Index>(law.pair.size());
  check_law(law, programme.A.rows() - slips, slips);
  return all_figures(programme, solution, law, 0);
}

std::ostream& operator<<(std::ostream& out, const Certificate& certificate) {
  std::ostringstream line;
  line << std::scientific << std::setprecision(1) << "penetration " << certificate.penetration
       << ", tension " << certificate.tension << ", complementarity " << certificate.complementarity
       << ", equilibrium " << certificate.equilibrium << ", duality gap "
       << certificate.duality_gap;
  if (certificate.cone > 0 || certificate.sliding > 0)
    line << ", cone " << certificate.cone << ", sliding " << certificate.sliding;
  if (certificate.balance > 0) line << ", balance " << certificate.balance;
  return out << line.str();
}

}  // namespace signorini
