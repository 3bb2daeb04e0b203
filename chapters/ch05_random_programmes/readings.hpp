// Ratios of energies as in table 1: that of each reading of the method over the least, and how they compare with one that is printed.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "judge.hpp"
#include "papers/method_readings.hpp"

namespace ch05 {

using Draw = KnownProgramme (*)(Eigen::Index n, Eigen::Index m, std::uint64_t seed);

/// f_P / f_L - 1 of every reading; 0 where it is rounding. Forces that balance the load have the energy
/// pi(u0) + 1/2 lambda.G lambda.
// [deviations]
inline std::vector<double> deviations(const KnownProgramme& known) {
  const DenseCondensed condensed = condense(known.programme);
  const double without = -0.5 * known.programme.load.dot(condensed.free_displacement);  // pi(u0)
  std::vector<double> found;
  for (const MethodReading& reading : method_readings(condensed.problem)) {
    const VectorXd& force = reading.force;
    const double energy = without + 0.5 * force.dot(condensed.problem.compliance * force);
    const double ratio = energy / known.energy - 1;
    found.push_back(std::abs(ratio) > 1e-10 ? ratio : 0);
  }
  return found;
}
// [deviations]

/// Runs with a ratio above one, at it to rounding, below it; and those with the sign of the printed ratio, with
/// its size (from a tenth to ten times of its deviation), with both.
struct Counts {
  double above = 0, none = 0, below = 0, sign = 0, size = 0, both = 0, runs = 0;
  void add(double printed, double own) {
    const bool same_sign = own * printed > 0;
    const double times = std::abs(own / printed);
    const bool same_size = times >= 0.1 && times <= 10;
    ++runs;
    ++(own > 0 ? above : own < 0 ? below : none);
    sign += same_sign ? 1 : 0;
    size += same_size ? 1 : 0;
    both += same_sign && same_size ? 1 : 0;
  }
  [[nodiscard]] double percent(double count) const { return 100 * count / runs; }
};

/// The value below which a share of all lie, such as the median.
inline double at_share(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

}  // namespace ch05
