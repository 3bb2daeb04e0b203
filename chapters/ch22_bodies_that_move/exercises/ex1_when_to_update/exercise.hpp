/// \file
/// Exercise 22.1 - how far a linear gap is good. Do not change this file.
#pragma once

namespace ex22_1 {

/// How much the gap has grown beyond what the linear one says, which is the gap at the start.
/// \param way     along the tangent at the start, of either sign [length]
/// \param radius  of the disc > 0 [length]
/// \return >= 0, right to a relative 1e-14 for any way [length]
[[nodiscard]] double error_of_linear_gap(double way, double radius);

/// How far a point may slide.
/// \param allowed  error > 0 [length]
/// \param radius   of the disc > 0 [length]
/// \return the way at which the error is that [length]
[[nodiscard]] double longest_way(double allowed, double radius);

/// Into how many equal stretches a way is cut, each with a gap of its own.
/// \param way      in total > 0, small beside the circumference [length]
/// \param allowed  error of each stretch > 0 [length]
/// \param radius   of the disc > 0 [length]
/// \return the fewest, at least 1
[[nodiscard]] int stretches(double way, double allowed, double radius);

}  // namespace ex22_1
