/// \file
/// Exercise 20.2 - reading the exchanges of a run. Do not change this file.
#pragma once
#include <vector>

namespace ex20_2 {

/// One exchange. Of n pairs the variable i < n is the gap of pair i, n + i its force and 2 n + i its overlap.
struct Exchange {
  int joins;   ///< the basis
  int leaves;  ///< it
};

/// What a list of exchanges says.
struct Reading {
  std::vector<int> closed;  ///< pairs whose force is in the basis at the end, rising
  int ended = 0;            ///< overlaps that have left
  int in_vain = 0;          ///< how often a force has left
  bool solved = false;      ///< whether no overlap is left in the basis
};

/// \param overlapping  for each pair whether it overlaps at the start \param exchanges  one after the other
/// \return what they say
/// \throws std::invalid_argument if there is no such variable, an overlap joins, what joins is in the basis or what leaves is not,
///   or force and gap of a pair are both in the basis after an exchange
[[nodiscard]] Reading read(const std::vector<bool>& overlapping, const std::vector<Exchange>& exchanges);

}  // namespace ex20_2
