#include "addons/many_bodies/sparse_contact.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "addons/many_bodies/central_path.hpp"
#include "addons/many_bodies/pair_sweeps.hpp"
#include "addons/many_bodies/sparse_set_system.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Sets that Newton's method may look at: it needs five to ten, or runs in circles.
constexpr Index most_sets = 50;
/// Sets from where sweeps have come: those that are near need few.
constexpr Index few_sets = 12;
/// Gaps at the beginning of two central paths, see CentralPath: one may be short where the other is long.
constexpr double narrow_gaps = 1;
constexpr double wide_gaps = 10;
/// Steps of a path, each with one factor. After half of them sweeps, which cost as much, come before the path that is farther off.
constexpr Index most_steps = 90;
/// How small products have to be for a first guess of the set, for a second and for the last: of what they begin with.
constexpr std::array<double, 3> small_products = {1e-9, 1e-11, 1e-13};
/// Sweeps over the pairs before the first exchange, and before the last one.
constexpr Index first_sweeps = 64;
constexpr Index last_sweeps = 32768;

/// From a first set to one that is right, and ways to a first set.
class SetSearch {
 public:
  explicit SetSearch(const SparseContact& problem) : system_(problem) {}
  std::optional<SparseContactSolution> run(const std::vector<ContactStatus>& start);

 private:
  /// Exchanges wrong pairs from where forces and statuses are. \param most  sets \return whether a set is right and settled
  bool exchange(Index most, SparseContactSolution& found);
  /// Takes forces over. \return what they say of the pairs: a guess, which is not judged by rounding
  std::vector<ContactStatus> guessed(ActiveSetSolution numbers);
  /// The exchange, from what soft pairs do.
  bool from_soft_pairs(SparseContactSolution& found);
  /// The exchange, from what central paths and sweeps lead to.
  bool from_paths_and_sweeps(SparseContactSolution& found);
  /// The exchange, from the end of one central path. \param most  of its steps
  bool from_central_path(CentralPath& path, Index most, SparseContactSolution& found);
  /// The exchange, from where sweeps over the pairs have come, after more and more of them.
  bool from_sweeps(SparseContactSolution& found);

  SparseSetSystem system_;
};

bool SetSearch::exchange(Index most, SparseContactSolution& found) {
  std::set<std::vector<ContactStatus>> seen;
  // Fewest changes so far. A set with more than twice as many leads away from where it began.
  Index least = system_.alone() ? system_.units().pairs() / 16 : system_.units().pairs();
  for (Index step = 0; step < most && seen.insert(found.statuses).second; ++step) {
    const ActiveSet set = active_set(found.statuses, system_.units().law);
    ++found.sets;
    if (!system_.solve(set, 0)) return false;
    system_.settle(set);
    const Index changes = predict(system_.units(), system_.now(), 1, found.statuses);
    if (changes == 0) return system_.settled();
    if (changes > 2 * least + 8) return false;
    least = std::min(least, changes);
  }
  return false;
}

std::vector<ContactStatus> SetSearch::guessed(ActiveSetSolution numbers) {
  system_.take(std::move(numbers));
  std::vector<ContactStatus> statuses(at(system_.units().pairs()), ContactStatus::Open);
  predict(system_.units(), system_.now(), 1, statuses);
  return statuses;
}

bool SetSearch::from_soft_pairs(SparseContactSolution& found) {
  found.statuses.assign(at(system_.units().pairs()), ContactStatus::Stick);
  ++found.sets;
  if (!system_.solve(active_set(found.statuses, system_.units().law), 1)) return false;
  found.statuses = guessed(system_.now());
  return exchange(most_sets, found);
}

bool SetSearch::from_central_path(CentralPath& path, Index most, SparseContactSolution& found) {
  for (const double part : small_products) {
    const Index before = path.steps();
    const bool reached = path.follow(part, most);
    found.steps += path.steps() - before;
    if (!reached) return false;
    ActiveSetSolution near;
    near.force = path.force();
    found.statuses = guessed(std::move(near));
    if (exchange(few_sets, found)) return true;
  }
  return false;
}

bool SetSearch::from_paths_and_sweeps(SparseContactSolution& found) {
  const FrictionLaw& law = system_.units().law;
  if (largest(system_.units().free) == 0 || !((law.coefficient + law.cohesion).array() > 0).all())
    return from_sweeps(found);
  CentralPath narrow(system_.compliance(), system_.units().free, law, narrow_gaps);
  CentralPath wide(system_.compliance(), system_.units().free, law, wide_gaps);
  if (from_central_path(narrow, most_steps / 2, found)) return true;
  if (from_central_path(wide, most_steps / 2, found)) return true;
  const bool in_order = narrow.level() <= wide.level();
  CentralPath& nearer = in_order ? narrow : wide;
  CentralPath& farther = in_order ? wide : narrow;
  return from_central_path(nearer, most_steps, found) || from_sweeps(found) ||
         from_central_path(farther, most_steps, found);
}

bool SetSearch::from_sweeps(SparseContactSolution& found) {
  const Eigen::SparseMatrix<double>& F = system_.compliance();
  const ScaledProblem& units = system_.units();
  if (!(F.diagonal().array() > 0).all()) return false;
  ActiveSetSolution swept;
  swept.force.setZero(units.free.size());
  for (Index sweeps = first_sweeps; sweeps <= last_sweeps; sweeps *= 2) {
    sweep_pairs(F, units.free, units.law, sweeps, swept.force);
    found.sweeps += sweeps;
    found.statuses = guessed(swept);
    if (exchange(few_sets, found)) return true;
    const VectorXd last = swept.force;
    sweep_pairs(F, units.free, units.law, 1, swept.force);
    if (largest(VectorXd(swept.force - last)) > 16 * epsilon * largest(last)) continue;
    found.statuses = guessed(swept);  // sweeps alone have ended
    return true;
  }
  return false;
}

std::optional<SparseContactSolution> SetSearch::run(const std::vector<ContactStatus>& start) {
  SparseContactSolution found;
  found.statuses = start;
  const bool solved = !start.empty() ? exchange(most_sets, found)
                      : system_.alone() ? from_paths_and_sweeps(found)
                                        : from_soft_pairs(found);
  if (!solved) return std::nullopt;
  system_.write(found);
  return found;
}

}  // namespace

std::optional<SparseContactSolution> solve_sparse_contact(const SparseContact& problem,
                                                          const std::vector<ContactStatus>& start) {
  return SetSearch(problem).run(start);
}

}  // namespace signorini
