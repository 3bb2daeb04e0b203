#include "addons/programme/proximal_programme.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "addons/programme/programme_rows.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Rows = std::vector<Index>;

/// A programme in units of its own: u = unknown * u', and a row of A u = g is multiplied by `row`.
struct Equilibrated {
  VectorXd unknown;  // `n` powers of two
  VectorXd row;      // `m` powers of two
  DenseProgramme programme;

  [[nodiscard]] VectorXd lengths(const VectorXd& u) const {
    return u.size() > 0 ? u.cwiseProduct(unknown) : u;
  }
  [[nodiscard]] VectorXd forces(const VectorXd& force) const {
    return force.size() > 0 ? force.cwiseProduct(row) : force;
  }
  [[nodiscard]] PrimalDual as_posed(const PrimalDual& own) const {
    return {lengths(own.displacement), lengths(own.displacement_low), forces(own.force)};
  }
};

/// Ruiz' rule: each row and column is divided by the root of its largest entry, which halves the exponents of these: as often as an
/// exponent has bits, and once more.
Equilibrated equilibrated(const DenseProgramme& posed) {
  Equilibrated own{VectorXd::Ones(posed.load.size()), VectorXd::Ones(posed.initial_gap.size()), {}};
  const auto root = [](double entry) { return entry > 0 ? 1 / std::sqrt(entry) : 1; };
  for (int bit = 0; bit < 12; ++bit) {
    const MatrixXd A = (own.row.asDiagonal() * posed.A * own.unknown.asDiagonal()).cwiseAbs();
    const MatrixXd K =
        (own.unknown.asDiagonal() * posed.stiffness * own.unknown.asDiagonal()).cwiseAbs();
    VectorXd unknown = K.colwise().maxCoeff();
    VectorXd row = VectorXd::Ones(A.rows());
    if (A.rows() > 0) {
      unknown = unknown.cwiseMax(A.colwise().maxCoeff().transpose());
      row = A.rowwise().maxCoeff();
    }
    own.unknown = own.unknown.cwiseProduct(unknown.unaryExpr(root));
    own.row = own.row.cwiseProduct(row.unaryExpr(root));
  }
  own.unknown = powers_of_two(own.unknown);
  own.row = powers_of_two(own.row);
  own.programme = {own.unknown.asDiagonal() * posed.stiffness * own.unknown.asDiagonal(),
                   own.lengths(posed.load),
                   own.row.asDiagonal() * posed.A * own.unknown.asDiagonal(),
                   own.forces(posed.initial_gap), posed.equations};
  return own;
}

/// A way from a place on a face, and how far it may be gone.
struct Way {
  VectorXd along;
  double share = 0;      ///< of it, to the least energy or to the next row that closes
  bool endless = false;  ///< whether energy falls for ever, as far as numbers can tell
};

/// How far along a way energy falls and no other row closes. What moves a row by no more than the rounding of the factor, which has
/// the condition 1 / spring, closes none; and a place so far away that the present one is out of its digits is no place.
Way limited(const DenseProgramme& programme, const Rows& closed, const VectorXd& u, Way way,
            double spring) {
  const VectorXd bent = programme.stiffness * way.along;
  const double curvature = way.along.dot(bent);
  const double slope = programme.load.dot(way.along) - u.dot(bent);
  if (curvature > 0) way.share = std::min(way.share, slope / curvature);
  const double rounding = static_cast<double>(u.size()) * epsilon;
  const double size = largest(u);
  const VectorXd gap = programme.initial_gap - programme.A * u;
  const VectorXd closing = programme.A * way.along;
  const double noise = rounding / std::sqrt(spring) * largest(way.along);
  double any = way.share;  // noise included
  for (Index i = programme.equations; i < gap.size(); ++i) {
    if (closing(i) <= 0 || std::find(closed.begin(), closed.end(), i) != closed.end()) continue;
    const double room =
        std::max(0.0, gap(i)) + rounding * (std::abs(programme.initial_gap(i)) + size);
    any = std::min(any, room / closing(i));
    if (closing(i) > noise) way.share = std::min(way.share, room / closing(i));
  }
  const double far = std::max(size, largest(way.along)) / std::sqrt(epsilon);
  way.endless = slope > 0 && any * largest(way.along) >= far;
  if (std::isinf(way.share)) way.share = std::isinf(any) ? 1 : any;
  return way;
}

/// The same with 0 where forces may be rounding of what the springs have carried, and displacements rounding of others: what is 0 in the
/// solution has no size of its own.
PrimalDual without_rounding(const ProgrammeRows::Refined& refined, double spring, Index size) {
  PrimalDual less = refined.solution;
  const double longest = largest(less.displacement);
  const double most = std::max(largest(less.force), spring * longest);
  less.force = (less.force.array().abs() <= static_cast<double>(size + 1) * epsilon * most)
                   .select(0.0, less.force);
  for (Index j = 0; j < less.displacement.size(); ++j)
    if (std::abs(less.displacement(j)) <= epsilon * longest) {
      less.displacement(j) = 0;
      if (less.displacement_low.size() > 0) less.displacement_low(j) = 0;
    }
  return less;
}

/// Of the multipliers of equations that depend on each other the shortest: all others differ by what does nothing to any unknown, and may be
/// so large that nothing is of a size beside them.
VectorXd shortest(const DenseProgramme& programme, const VectorXd& force) {
  const auto equations = programme.A.topRows(programme.equations);
  VectorXd less = force;
  less.head(programme.equations) = least_norm_solution(
      equations.transpose(), equations.transpose() * force.head(programme.equations));
  return less;
}

/// The rounds of proximal_solution(), in units of their own.
class Proximal {
 public:
  Proximal(const DenseProgramme& posed, const StrictMethod& method)
      : posed_(posed),
        own_(equilibrated(posed)),
        method_(method),
        data_(own_.programme, spring),
        rank_(Eigen::ColPivHouseholderQR<MatrixXd>(own_.programme.A.topRows(posed.equations)).rank()),
        rest_(VectorXd::Zero(posed.load.size())) {}

  DenseSolution run() {
    best_.certificate = uncertified();
    best_.report.status = SolveStatus::Breakdown;
    if (held_at_zero()) {
      best_.report.status = SolveStatus::Solved;
      return std::move(best_);
    }
    // Rounding alone brings rows back without less energy, or takes more rounds than there are rows.
    std::set<Rows> seen;
    for (Index rounds = data_.count() + 10; !round() && rounds > 0; --rounds) {
      const double energy =
          0.5 * rest_.dot(own_.programme.stiffness * rest_) - own_.programme.load.dot(rest_);
      const bool falls = energy < lowest_ - epsilon * std::abs(energy);
      if (!seen.insert(*closed_).second && !falls) break;
      if (!std::isfinite(energy)) break;
      lowest_ = std::min(lowest_, energy);
    }
    if (best_.report.status == SolveStatus::Breakdown && (allowed(rest_) || allowed(0 * rest_)))
      refuse_endless();
    return std::move(best_);
  }

 private:
  static inline const double spring = std::sqrt(epsilon);

  /// Keeps a claim if its certificate is better than those before. \return whether it is good enough
  bool keep(const VectorXd& gap, PrimalDual solution) {
    if (rank_ < own_.programme.equations) solution.force = shortest(own_.programme, solution.force);
    PrimalDual claim = own_.as_posed(solution);
    for (Index i = posed_.equations; i < claim.force.size(); ++i)
      claim.force(i) = std::max(0.0, claim.force(i));
    const Certificate certificate = certify(posed_, claim);
    if (certificate.worst() >= best_.certificate.worst()) return false;
    best_.certificate = certificate;
    best_.refined = claim;
    best_.gap = gap.cwiseQuotient(own_.row);
    best_.active = *closed_;
    return certificate.holds();
  }

  /// Keeps the solution where the equations alone hold all unknowns at 0. \return whether they do
  bool held_at_zero() {
    const DenseProgramme& own = own_.programme;
    const Index n = own.load.size();
    const MatrixXd equations = own.A.topRows(own.equations);
    if (rank_ < n || !own.initial_gap.head(own.equations).isZero(0)) return false;
    closed_ = Rows();
    VectorXd force = VectorXd::Zero(own.A.rows());
    force.head(own.equations) = least_norm_solution(equations.transpose(), own.load);
    return keep_zero(std::move(force));
  }

  /// Keeps no displacements at all: where rows hold all unknowns at 0, displacements would be rounding. Forces must balance the load
  /// as beside a load alone, since there is nothing else. \return whether this is the end
  bool keep_zero(VectorXd force) {
    const DenseProgramme& own = own_.programme;
    force.tail(force.size() - own.equations) = force.tail(force.size() - own.equations).cwiseMax(0.0);
    const VectorXd left = own.load - own.A.transpose() * force;
    return largest(left) <= certificate_tolerance * largest(own.load) &&
           keep(own.initial_gap, {VectorXd::Zero(own.load.size()), {}, std::move(force)});
  }

  /// Keeps a place without any force where there is neither K nor load: each that all rows allow is a solution. Of places so far away that
  /// right sides are out of their digits nothing is known. \return whether it is one
  bool keep_any_place(PrimalDual place) {
    const DenseProgramme& own = own_.programme;
    if (!own.stiffness.isZero(0) || !own.load.isZero(0)) return false;
    place.force.setZero();
    VectorXd gap = own.initial_gap - own.A * place.displacement;
    const double least = spring * largest(own.initial_gap);
    if ((gap.array() < -least).any() || largest(VectorXd(gap.head(own.equations))) > least) return false;
    if (!keep(gap, std::move(place))) return false;
    best_.report.status = SolveStatus::Solved;
    return true;
  }

  /// A breakdown is a claim like others: what its rows make of the face is looked at.
  static bool is_usable(const DenseSolution& near) {
    const SolveStatus status = near.report.status;
    return (status == SolveStatus::Solved || status == SolveStatus::Breakdown) &&
           near.refined.displacement.allFinite() && near.refined.force.allFinite();
  }

  /// One proximal point, the least energy of its face, and where the springs are at rest next. \return whether this is the end
  bool round() {
    DenseSolution near = method_(around_rest(), options());
    append(best_.report, near.report);
    if (closed_ && !is_usable(near)) {  // once more, with all rows open
      near = method_(around_rest(), {});
      append(best_.report, near.report);
    }
    const VectorXd u = rest_ + near.refined.displacement;
    if (!is_usable(near) || !u.allFinite()) {
      if (closed_) return true;
      best_.report.status = near.report.status;
      best_.farkas_certificate = own_.forces(near.farkas_certificate);
      best_.refined = own_.as_posed({u, {}, near.refined.force});
      best_.gap = posed_.initial_gap - posed_.A * best_.refined.displacement;
      return true;
    }
    closed_ = near.active;
    if (keep_any_place(near.refined)) return true;
    ActiveSetFactor face = data_.basis_at(*closed_, {u, {}, near.refined.force});
    const ProgrammeRows::Refined refined = data_.refine(face);
    if (keep(refined.gap, refined.solution) ||
        keep(refined.gap, without_rounding(refined, spring, face.size())) || keep_zero(refined.solution.force)) {
      best_.report.status = SolveStatus::Solved;
      return true;
    }
    if (refined.settled && refined.confirmed()) return true;
    Way way{refined.change, std::numeric_limits<double>::infinity()};
    if (refined.settled) way = {refined.solution.displacement - u, 1};
    way = limited(own_.programme, *closed_, u, std::move(way), spring);
    if (way.endless) refuse(way.along);
    rest_ = u + way.share * way.along;
    return !rest_.allFinite();
  }

  /// The programme with springs, of the way from where they are at rest.
  [[nodiscard]] DenseProgramme around_rest() const {
    const DenseProgramme& own = own_.programme;
    DenseProgramme near = own;
    near.stiffness.diagonal().array() += spring;
    ExactVector load(own.load);
    ExactVector gap(own.initial_gap);
    for (Index j = 0; j < rest_.size(); ++j) {
      load.add_product(own.stiffness.col(j), -rest_(j));
      gap.add_product(own.A.col(j), -rest_(j));
    }
    near.load = load.value();
    near.initial_gap = gap.value();
    return near;
  }

  /// A start from the rows that were closed last.
  [[nodiscard]] SolverOptions options() const {
    SolverOptions from;
    if (!closed_) return from;
    const Index equations = own_.programme.equations;
    from.start.assign(at(own_.row.size() - equations), ContactStatus::Open);
    for (const Index row : *closed_) from.start[at(row - equations)] = ContactStatus::Stick;
    return from;
  }

  /// Whether a place satisfies all rows, as far as half of the digits tell.
  [[nodiscard]] bool allowed(const VectorXd& u) const {
    const DenseProgramme& own = own_.programme;
    const VectorXd gap = own.initial_gap - own.A * u;
    const VectorXd size = own.initial_gap.cwiseAbs() + own.A.cwiseAbs() * u.cwiseAbs();
    const Index e = own.equations;
    return u.allFinite() && (gap.head(e).array().abs() <= spring * size.head(e).array()).all() &&
           (gap.array() >= -spring * size.array()).all();
  }

  /// Of all directions that K and the equations do not feel and no row ends the one nearest to the load: the projection onto their cone. If it is
  /// not 0, energy falls for ever along it.
  void refuse_endless() {
    const DenseProgramme& own = own_.programme;
    const Index n = own.load.size();
    MatrixXd felt(n + own.equations, n);
    felt << own.stiffness, own.A.topRows(own.equations);
    const MatrixXd free = null_space(felt);
    if (free.cols() == 0) return;
    const Index rows = own.A.rows() - own.equations;
    const DenseSolution nearest =
        method_({MatrixXd::Identity(free.cols(), free.cols()), free.transpose() * own.load,
                 own.A.bottomRows(rows) * free, VectorXd::Zero(rows), 0},
                {});
    const VectorXd along = free * nearest.refined.displacement;
    if (nearest.report.status == SolveStatus::Solved && largest(along) > std::sqrt(spring) * largest(own.load))
      refuse(along);
  }

  [[noreturn]] void refuse(const VectorXd& along) const {
    Index most = 0;
    own_.lengths(along).cwiseAbs().maxCoeff(&most);
    throw NotDefinite(text(
        "quadratic programme: the energy has no least value: it falls for ever along a direction "
        "that the quadratic part does not feel and no row ends, in which unknown ",
        most + 1, along(most) > 0 ? " grows" : " falls",
        " most; bound it, or correct the sign of its linear part"));
  }

  const DenseProgramme& posed_;
  Equilibrated own_;
  const StrictMethod& method_;
  ProgrammeRows data_;
  Index rank_;                  // of the equations
  VectorXd rest_;               // where the springs are at rest
  std::optional<Rows> closed_;  // by the last proximal point
  double lowest_ = std::numeric_limits<double>::max();
  DenseSolution best_;
};

}  // namespace

DenseSolution proximal_solution(const DenseProgramme& programme, const StrictMethod& method) {
  return Proximal(programme, method).run();
}

}  // namespace signorini
