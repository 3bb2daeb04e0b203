/// \file
/// Exercise 10.4 - how many pressures, and how high. Do not change this file.
#pragma once
#include <vector>

namespace ex10_4 {

/// Nodes of both sides of a straight interface. Places count as one if they differ by at most 1e-9 of its length.
struct Interface {
  std::vector<double> source;  ///< rising, two or more [length]
  std::vector<double> target;  ///< rising, two or more, with the same ends [length]
};

/// How many pressures the nodes can tell apart, however many points there are.
/// \param nodes  of the interface
/// \return the rank at which more points an edge add nothing
/// \throws std::invalid_argument if a side has fewer than two nodes or its nodes do not rise, or if the ends differ
[[nodiscard]] int most_felt(const Interface& nodes);

/// How many of the pressures of some points the nodes can tell apart.
/// \param nodes   of the interface
/// \param points  on it, not falling [length]; all are closed
/// \return rank of the forces that pressures of these points put on the nodes of both sides
/// \throws std::invalid_argument as most_felt(), or if a point lies beyond the ends
[[nodiscard]] int felt(const Interface& nodes, const std::vector<double>& points);

/// A point of a rule on [-1, 1].
struct Point {
  double xi;      ///< its place [-]
  double weight;  ///< > 0 [-]; those of a rule have the sum 2
};

/// The largest pressure that one point of an inner edge may have, over the uniform one that is right, where nodes meet nodes and edges are
/// of one length: alone it carries what one of its nodes needs, and the other node does not get more than it needs.
/// \param rule  of an edge, two points or more
/// \return the largest of these ratios [-]
/// \throws std::invalid_argument for fewer than two points, a place outside of [-1, 1] or a weight that is not positive
[[nodiscard]] double highest_alone(const std::vector<Point>& rule);

}  // namespace ex10_4
