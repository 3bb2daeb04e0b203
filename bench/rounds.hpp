/// \file
/// Contact, a plain solve and the yardsticks on one scene, in turn.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "bench/yardsticks.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini::bench {

/// Processor seconds by what was done, a number for each round: the phases of the ledger, `set-up` (plan and
/// assembly), `condense` (condense()), `whole` (condense() and solve()), `plain`, the names of the yardsticks, and
/// the name and ` compliance` of those that have their own.
using Times = std::map<std::string, std::vector<double>>;

/// What one scene took.
struct Cost {
  Eigen::Index unknowns = 0;  ///< n of K
  Times times;                ///< of every way
  Solution first;             ///< of all rounds
  double fill = 0;            ///< entries of L
  double operations = 0;      ///< of the factor
  double megabytes = 0;  ///< largest memory while it was solved; 0 where the system does not tell
  /// By what was done, as `times`: by how much the memory of this program rose in the first round [MB].
  std::map<std::string, double> rise;
  /// Certified after few steps and few solves, to the same bits each round, on the factor of the plain solve; and
  /// every plain solve is one to rounding, and every compliance ours.
  bool good = true;
};

/// \return whether a solution is one
[[nodiscard]] bool is_certified(const Solution& solution);

/// \return median ratio of two ways in the same rounds, "-" if one of them was left out
[[nodiscard]] std::string ratio(const Cost& cost, const std::string& way, const std::string& over);

/// Contact from the mesh to the certificate; then plain solves of the same K: ordering, factor and one solve, by our
/// factor and by others. All ways in turn, so that a change of the machine's speed meets each of them.
/// \param scene    any
/// \param rounds   how many; yardsticks that need more than 5 s have one only
/// \param smaller  what a smaller scene of the kind took, nullptr if there is none: a yardstick that would need more
///   than 45 s is left out
/// \param others   that are asked
/// \return what it took
[[nodiscard]] Cost measure(const Scene& scene, int rounds, const Cost* smaller,
                           const std::vector<Yardstick>& others);

}  // namespace signorini::bench
