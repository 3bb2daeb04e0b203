/// \file
/// Exercise 19.3 - reading a sweep. Do not change this file.
#pragma once
#include <vector>

namespace ex19_3 {

/// What one run says.
struct Row {
  double parameter = 0;  ///< positive, larger from row to row
  double error = 0;      ///< of the answer, positive
  double condition = 0;  ///< of the matrix, positive
};

/// What all runs say together.
struct Reading {
  double floor = 0;  ///< the smallest error
  double enough =
      0;  ///< the least parameter of a row from which on no error is above 1.1 times the floor
  double order = 0;  ///< with which the condition number grows, by the last two rows
};

/// Reads a sweep.
/// \param rows  at least two
/// \return what they say; `enough` is infinite if the last row is above 1.1 times the floor
/// \throws std::invalid_argument if there are fewer than two rows, parameters do not increase, or a number is not positive
[[nodiscard]] Reading read_sweep(const std::vector<Row>& rows);

}  // namespace ex19_3
