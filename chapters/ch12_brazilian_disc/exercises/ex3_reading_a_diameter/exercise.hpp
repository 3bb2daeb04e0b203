/// \file
/// Exercise 12.3 - reading a diameter. Do not change this file.
#pragma once
#include <optional>
#include <vector>

namespace ex12_3 {

/// A point of the loaded diameter.
struct Point {
  double depth;   ///< below a contact [length]
  double stress;  ///< across the load, tension > 0 [force/length^2]
};

/// Where tension begins for good: the deepest place where compression, or none, turns into tension.
/// \param line  two points or more, depths rising; straight between them
/// \return depth [length]; nothing if there is no such place
/// \throws std::invalid_argument for fewer points, depths that do not rise, or numbers that are not finite
[[nodiscard]] std::optional<double> tension_begins(const std::vector<Point>& line);

/// From where on the stress is a given one, at the points.
/// \param line   as for tension_begins()
/// \param level  the stress [force/length^2]
/// \param share  how far off it may be, as a part of |level| [-], not negative
/// \return depth of the first point of those that are within the share, up to the last of the line; nothing if the last is not
/// \throws std::invalid_argument as tension_begins(), or if the level is not finite or the share is negative
[[nodiscard]] std::optional<double> even_from(const std::vector<Point>& line, double level,
                                              double share);

/// Force by which the halves pull at each other, where they do.
/// \param line  as for tension_begins()
/// \return integral of the tension along the line, not negative [force/length]
/// \throws std::invalid_argument as tension_begins()
[[nodiscard]] double pull(const std::vector<Point>& line);

/// Force by which the halves push at each other, where they do.
/// \param line  as for tension_begins()
/// \return integral of the compression along the line, not negative [force/length]
/// \throws std::invalid_argument as tension_begins()
[[nodiscard]] double push(const std::vector<Point>& line);

}  // namespace ex12_3
