/// \file
/// Exercise 13.4 - which columns of a table have a limit. Do not change this file.
#pragma once
#include <vector>

namespace ex13_4 {

/// What a number does when cells are halved again and again.
enum class Fate {
  Converges,  ///< its steps become smaller
  Grows,      ///< it goes away from zero by steps that do not become smaller
  Unclear     ///< neither of both
};

/// What a column of a table says, by its last three rows v_1, v_2, v_3 with the steps v_2 - v_1 and v_3 - v_2.
struct Trend {
  Fate fate = Fate::Unclear;  ///< by the last two steps
  double order = 0;  ///< if it converges: each step is 2^order times smaller; infinity if it is 0
  double limit = 0;  ///< if it converges: where steps that go on like this lead to
  double power = 0;  ///< if it grows: v_3 = 2^power v_2, the number of cells to this power
};

/// Reads a column.
///
/// It converges if the last step is smaller than the one before, or both are 0. It grows if it goes away from zero, by steps that
/// do not become smaller: v_1 is 0 or has the sign of both steps.
/// \param column  numbers of at least three rows, cells halved from each row to the next
/// \return the trend; what does not belong to its fate is 0
/// \throws std::invalid_argument if there are fewer than three rows, or a number is not finite
[[nodiscard]] Trend trend_of(const std::vector<double>& column);

}  // namespace ex13_4
