/// \file
/// Exercise 16.1 - the price of an error. Do not change this file.
#pragma once
#include <vector>

namespace ex16_1 {

/// A mesh of a line.
struct Point {
  double cost = 0;   ///< seconds or operations, above 0
  double error = 0;  ///< above 0, in any unit
};

/// The power p of `error = C cost^-p`, by least squares in the logarithms.
/// \param line  at least two points of different cost, in any order
/// \return p [-]; below 0 if the error grows with the cost
/// \throws std::invalid_argument if there are fewer, or a number is not above 0
[[nodiscard]] double order(const std::vector<Point>& line);

/// How many times as much an error costs that is smaller by a factor.
/// \param line    as for order()
/// \param factor  above 1: 10 for a digit
/// \return times [-]; infinity if the error does not fall with the cost
/// \throws std::invalid_argument as order(), or unless the factor is above 1
[[nodiscard]] double price(const std::vector<Point>& line, double factor);

}  // namespace ex16_1
