#include "addons/certified/sparse_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "addons/certified/central_path.hpp"
#include "addons/certified/pair_sweeps.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/sparse_lu.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Sets that Newton's method may look at: it needs five to ten, or runs in circles.
constexpr Index most_sets = 50;
/// Sets from where sweeps have come: those that are near need few.
constexpr Index few_sets = 12;
/// Where central paths begin, see CentralPath. One may be short and the other long: it is left where it has more steps than this.
constexpr std::array<double, 2> beginnings = {1, 10};
constexpr Index most_steps = 90;
/// How small products have to be for a first guess of the set, for a second and for the last: of what they begin with.
constexpr std::array<double, 3> small_products = {1e-9, 1e-11, 1e-13};
/// Sweeps over the pairs before the first exchange, and before the last one.
constexpr Index first_sweeps = 64;
constexpr Index last_sweeps = 32768;
/// A sweep leaves eps^(3/4) over an eigenvalue of what the one before left. Where six do not do, that is more than 1/400, the
/// condition is beyond 1e9, and forces are known to fewer than the six digits that are printed: others have to say so.
constexpr int most_sweeps = 6;
/// Of the largest force: what a force may be wrong by behind the last sweep. The certificate lets pass 22 times as much.
constexpr double force_rounding = 200 * epsilon;

/// The nearest powers of two: multiplying by them rounds nothing.
VectorXd powers_of_two(const VectorXd& scale) {
  return scale.unaryExpr([](double s) { return std::exp2(std::round(std::log2(s))); });
}

/// What columns are multiplied by, so that the diagonal of H, or else the longest entry of B, is about 1.
VectorXd column_scales(const SparseMatrix& H, const SparseMatrix& B) {
  VectorXd size = VectorXd(H.diagonal()).cwiseMax(0.0).cwiseSqrt();
  for (Index j = 0; j < B.cols(); ++j)
    if (size(j) == 0)
      for (SparseMatrix::InnerIterator it(B, j); it; ++it)
        size(j) = std::max(size(j), std::abs(it.value()));
  return powers_of_two((size.array() > 0).select(size.cwiseInverse(), 1.0));
}

/// The system of one set after the other, in units in which forces and movements are alike.
class SparseSets {
 public:
  explicit SparseSets(const SparseContact& problem)
      : row_scale_(powers_of_two(problem.scale)), B_(row_scale_.asDiagonal() * problem.rows) {
    column_scale_ = column_scales(problem.stiffness, B_);
    const auto columns = column_scale_.asDiagonal();
    B_ = SparseMatrix(B_ * columns);
    BT_ = B_.transpose();
    H_ = SparseMatrix(columns * problem.stiffness * columns);
    F_ = SparseMatrix(row_scale_.asDiagonal() * problem.compliance * row_scale_.asDiagonal());
    load_ = columns * problem.load;
    units_.free = row_scale_.cwiseProduct(problem.free);
    units_.law = problem.law;
    const Index pairs = units_.pairs();
    for (std::size_t k = 0; k < units_.law.pair.size(); ++k) {
      const Index slip = static_cast<Index>(k);
      const double own = row_scale_(pairs + slip);
      units_.law.coefficient(slip) *= row_scale_(units_.law.pair[k]) / own;
      units_.law.cohesion(slip) /= own;
    }
    x_.setZero(load_.size());
    low_.setZero(load_.size());
    now_.force.setZero(units_.free.size());
  }

  std::optional<SparseContactSolution> run(const std::vector<ContactStatus>& start);

 private:
  /// Exchanges wrong pairs from where forces and statuses are. \param most  sets \return whether a set is right and settled
  bool exchange(Index most, SparseContactSolution& found);
  /// Takes forces over. \return what they say of the pairs: a guess, which is not judged by rounding
  std::vector<ContactStatus> guessed(ActiveSetSolution numbers);
  /// The exchange, from what soft pairs do.
  bool from_soft_pairs(SparseContactSolution& found);
  /// The exchange, from the end of one central path after the other.
  bool from_central_paths(SparseContactSolution& found);
  /// The same of one. \param wide  where it begins
  bool from_central_path(double wide, SparseContactSolution& found);
  /// The exchange, from where sweeps over the pairs have come, after more and more of them.
  bool from_sweeps(SparseContactSolution& found);
  /// Solves a set. \param soft  what closed rows give way by [-] \return whether there are numbers, settled or not
  bool solve(const ActiveSet& set, double soft);
  /// \return whether closed rows have moved by no more than rounding
  bool closes(const ActiveSet& set);
  /// \return the matrix of a set
  [[nodiscard]] SparseMatrix matrix(const ActiveSet& set, double soft) const;
  /// Whether there is no x: rigid bodies, whose forces may be redundant.
  [[nodiscard]] bool alone() const { return x_.size() == 0; }
  /// What is added to the diagonal. What rounding leaves of a residual moves redundant forces by epsilon over it.
  [[nodiscard]] double regularity() const {
    return alone() ? std::sqrt(epsilon) : std::pow(epsilon, 0.75);
  }
  /// Puts friction forces at their bounds, and takes those away that the set excludes.
  void impose(const ActiveSet& set);
  /// \return p - H x - B^T f, rounded once
  [[nodiscard]] VectorXd imbalance() const;
  /// \return g - B x + F f, rounded once
  [[nodiscard]] VectorXd movement() const;
  /// Notes movements, and what rounding may have done to them and to forces.
  void settle(const ActiveSet& set);

  VectorXd row_scale_, column_scale_;
  SparseMatrix B_, BT_, H_, F_;
  VectorXd load_;
  ScaledProblem units_;  // free movements and law only
  VectorXd x_, low_;
  ActiveSetSolution now_;
  bool settled_ = false;  // whether the last corrections of the last set were rounding
};

SparseMatrix SparseSets::matrix(const ActiveSet& set, double soft) const {
  const Index n = x_.size();
  const Index m = static_cast<Index>(set.closed.size());
  const double regular = regularity();
  std::vector<Index> place(at(units_.free.size()), -1);
  for (Index i = 0; i < m; ++i) place[at(set.closed[at(i)])] = n + i;
  Triplets entries;
  for (Index j = 0; j < n; ++j) {
    entries.emplace_back(j, j, regular);
    for (SparseMatrix::InnerIterator it(H_, j); it; ++it)
      entries.emplace_back(it.row(), j, it.value());
  }
  // What a force in column `column` does, slope times that of row `row`.
  const auto acts = [&](Index row, Index column, double slope) {
    for (SparseMatrix::InnerIterator it(BT_, row); it; ++it)
      entries.emplace_back(it.row(), column, slope * it.value());
    for (SparseMatrix::InnerIterator it(F_, row); it; ++it)
      if (const Index there = place[at(it.row())]; there >= 0)
        entries.emplace_back(there, column, -slope * it.value());
  };
  for (Index i = 0; i < m; ++i) {
    const Index row = set.closed[at(i)];
    acts(row, n + i, 1);
    for (SparseMatrix::InnerIterator it(BT_, row); it; ++it)
      entries.emplace_back(n + i, it.row(), it.value());
    entries.emplace_back(n + i, n + i, -(soft + regular));
  }
  for (const SlidingPair& pair : set.sliding)
    if (pair.slope != 0) acts(pair.slip, place[at(pair.gap)], pair.slope);
  SparseMatrix M(n + m, n + m);
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

void SparseSets::impose(const ActiveSet& set) {
  VectorXd kept = VectorXd::Zero(now_.force.size());
  for (const Index row : set.closed) kept(row) = now_.force(row);
  for (const SlidingPair& pair : set.sliding)
    kept(pair.slip) = pair.friction(kept(pair.gap)).value();
  now_.force = std::move(kept);
}

VectorXd SparseSets::imbalance() const {
  ExactVector sum(load_);
  for (Index j = 0; j < x_.size(); ++j) {
    sum.add_product(H_, j, -x_(j));
    sum.add_product(H_, j, -low_(j));
  }
  for (Index i = 0; i < now_.force.size(); ++i)
    if (now_.force(i) != 0) sum.add_product(BT_, i, -now_.force(i));
  return sum.value();
}

VectorXd SparseSets::movement() const {
  ExactVector sum(units_.free);
  for (Index j = 0; j < x_.size(); ++j) {
    sum.add_product(B_, j, -x_(j));
    sum.add_product(B_, j, -low_(j));
  }
  for (Index i = 0; i < now_.force.size(); ++i)
    if (now_.force(i) != 0) sum.add_product(F_, i, now_.force(i));
  return sum.value();
}

bool SparseSets::closes(const ActiveSet& set) {
  settle(set);
  // Rows that depend on each other contradict each other by what rounding did to any of them.
  return largest(VectorXd(movement()(set.closed))) <= largest(now_.movement_rounding);
}

bool SparseSets::solve(const ActiveSet& set, double soft) {
  SparseLuFactor factor;
  if (!factor.factorise(matrix(set, soft))) return false;
  const Index n = x_.size();
  const Index m = static_cast<Index>(set.closed.size());
  impose(set);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    VectorXd right(n + m);
    right.head(n) = imbalance();
    right.tail(m) = movement()(set.closed) + soft * now_.force(set.closed);
    const VectorXd change = factor.solve(right);
    if (!change.allFinite()) return false;
    for (Index j = 0; j < n; ++j) add_to(x_(j), low_(j), change(j));
    for (Index i = 0; i < m; ++i) now_.force(set.closed[at(i)]) += change(n + i);
    impose(set);
    // The last digits of x are in its second part, so that one sweep more refines them as well.
    settled_ = alone() ? soft == 0 && closes(set)
                       : largest(VectorXd(change.head(n))) <= epsilon * largest(x_) &&
                             largest(VectorXd(change.tail(m))) <= epsilon * largest(now_.force);
    if (settled_) break;
  }
  return true;
}

void SparseSets::settle(const ActiveSet& set) {
  now_.movement = movement();
  const VectorXd terms = units_.free.cwiseAbs() + B_.cwiseAbs() * x_.cwiseAbs() +
                         F_.cwiseAbs() * now_.force.cwiseAbs();
  now_.movement_rounding = 8 * epsilon * terms;
  now_.force_rounding = force_rounding * largest(now_.force);
  now_.movement(set.closed).setZero();
}

bool SparseSets::exchange(Index most, SparseContactSolution& found) {
  std::set<std::vector<ContactStatus>> seen;
  // Fewest changes so far. Of rigid bodies a set with more than twice as many leads away from where it began.
  Index least = alone() ? units_.pairs() / 16 : units_.pairs();
  for (Index step = 0; step < most && seen.insert(found.statuses).second; ++step) {
    const ActiveSet set = active_set(found.statuses, units_.law);
    ++found.sets;
    if (!solve(set, 0)) return false;
    settle(set);
    const Index changes = predict(units_, now_, 1, found.statuses);
    if (changes == 0) return settled_;
    if (alone() && changes > 2 * least + 8) return false;
    least = std::min(least, changes);
  }
  return false;
}

std::vector<ContactStatus> SparseSets::guessed(ActiveSetSolution numbers) {
  now_ = std::move(numbers);
  now_.movement = movement();
  now_.movement_rounding.resize(0);
  std::vector<ContactStatus> statuses(at(units_.pairs()), ContactStatus::Open);
  predict(units_, now_, 1, statuses);
  return statuses;
}

bool SparseSets::from_soft_pairs(SparseContactSolution& found) {
  found.statuses.assign(at(units_.pairs()), ContactStatus::Stick);
  ++found.sets;
  if (!solve(active_set(found.statuses, units_.law), 1)) return false;
  found.statuses = guessed(now_);
  return exchange(most_sets, found);
}

bool SparseSets::from_central_path(double wide, SparseContactSolution& found) {
  CentralPath path(F_, units_.free, units_.law, wide);
  Index steps = 0;
  for (const double part : small_products) {
    const bool reached = path.follow(part, most_steps);
    found.steps += path.steps() - std::exchange(steps, path.steps());
    if (!reached) return false;
    ActiveSetSolution near;
    near.force = path.force();
    found.statuses = guessed(std::move(near));
    if (exchange(few_sets, found)) return true;
  }
  return false;
}

bool SparseSets::from_central_paths(SparseContactSolution& found) {
  const FrictionLaw& law = units_.law;
  if (largest(units_.free) == 0 || !((law.coefficient + law.cohesion).array() > 0).all()) return false;
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](double wide) { return from_central_path(wide, found); });
}

bool SparseSets::from_sweeps(SparseContactSolution& found) {
  if (!(F_.diagonal().array() > 0).all()) return false;
  ActiveSetSolution swept;
  swept.force.setZero(units_.free.size());
  for (Index sweeps = first_sweeps; sweeps <= last_sweeps; sweeps *= 2) {
    sweep_pairs(F_, units_.free, units_.law, sweeps, swept.force);
    found.sweeps += sweeps;
    found.statuses = guessed(swept);
    if (exchange(few_sets, found)) return true;
    const VectorXd last = swept.force;
    sweep_pairs(F_, units_.free, units_.law, 1, swept.force);
    if (largest(VectorXd(swept.force - last)) > 16 * epsilon * largest(last)) continue;
    found.statuses = guessed(swept);  // sweeps alone have ended
    return true;
  }
  return false;
}

std::optional<SparseContactSolution> SparseSets::run(const std::vector<ContactStatus>& start) {
  SparseContactSolution found;
  found.statuses = start;
  const bool solved = !start.empty() ? exchange(most_sets, found)
                      : alone()      ? from_central_paths(found) || from_sweeps(found)
                                     : from_soft_pairs(found);
  if (!solved) return std::nullopt;
  found.position = column_scale_.cwiseProduct(x_);
  found.position_low = column_scale_.cwiseProduct(low_);
  found.force = row_scale_.cwiseProduct(now_.force);
  found.movement = now_.movement.cwiseQuotient(row_scale_);
  return found;
}

}  // namespace

std::optional<SparseContactSolution> solve_sparse_contact(const SparseContact& problem,
                                                          const std::vector<ContactStatus>& start) {
  return SparseSets(problem).run(start);
}

}  // namespace signorini
