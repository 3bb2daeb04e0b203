/// \file
/// Exercise 15.1 - readings of a stick map. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace ex15_1 {

/// What all pairs of a contact do along a path.
struct Map {
  Eigen::VectorXd x;  ///< `n_c` places of the pairs [length], in any order
  std::vector<std::vector<signorini::ContactStatus>> rows;  ///< `n_c` statuses of every step
};

/// How far the part that sticks reaches.
/// \param map  any
/// \param row  number of a step
/// \return half of the distance between the outermost pairs that stick [length]; 0 if one or none sticks
/// \throws std::out_of_range if there is no such row
[[nodiscard]] double stuck_half_width(const Map& map, std::size_t row);

/// In which steps a push has turned: a pair slid in the row before, and sticks or slides the other way now.
/// \param map  any
/// \return numbers of the rows, increasing
[[nodiscard]] std::vector<std::size_t> turns(const Map& map);

/// Pairs that stick in all rows.
/// \param map  with at least one row
/// \return their numbers, increasing
[[nodiscard]] std::vector<Eigen::Index> always_stuck(const Map& map);

}  // namespace ex15_1
