/// \file
/// Exercise 8.3 - reading residuals. Do not change this file.
#pragma once
#include <optional>
#include <vector>

namespace ex8_3 {

/// What becomes of a run.
enum class Fate {
  Round,   ///< it repeats itself
  Quick,   ///< each of its last two gains is at least 1.5 times the one before
  Steady,  ///< its last three gains are positive, and the largest is at most 1.1 times the smallest
  Unclear  ///< none of these
};

/// Digits that each step has gained.
/// \param residuals  of all iterates, the start first; four or more, positive, the last one may be 0
/// \return log10(r_k / r_{k+1}), one fewer than residuals; infinity for a last one of 0
/// \throws std::invalid_argument for fewer than four residuals, one that is negative or not finite, or a 0 before the last
[[nodiscard]] std::vector<double> digits_gained(const std::vector<double>& residuals);

/// After how many steps a run repeats itself.
/// \param residuals  as for digits_gained()
/// \return the smallest p such that the last p residuals are those of p steps before, to 1e-9 of each; 1 if it stands still, 0 if
///   it does not repeat itself in what is there
/// \throws std::invalid_argument as digits_gained()
[[nodiscard]] int period(const std::vector<double>& residuals);

/// What becomes of it; the first that holds, in the order of Fate. Quick asks for three positive gains, too.
/// \param residuals  as for digits_gained()
/// \return the fate
/// \throws std::invalid_argument as digits_gained()
[[nodiscard]] Fate fate(const std::vector<double>& residuals);

/// How many more steps a run needs, if it goes on as it does.
///
/// A steady run goes on with its last gain. The gains of a quick one go on to grow by the ratio of the last two, but no more than
/// twice with each step. The others are not forecast.
/// \param residuals  as for digits_gained()
/// \param target     > 0, in the unit of the residuals
/// \return steps until the residual is at most the target, 0 if it is already; nothing if there is no forecast
/// \throws std::invalid_argument as digits_gained(), or if the target is not positive
[[nodiscard]] std::optional<int> steps_left(const std::vector<double>& residuals, double target);

}  // namespace ex8_3
