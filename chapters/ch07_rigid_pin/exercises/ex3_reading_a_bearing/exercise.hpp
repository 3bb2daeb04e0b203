/// \file
/// Exercise 7.3 - reading a bearing. Do not change this file.
#pragma once
#include <cstddef>
#include <vector>

namespace ex7_3 {

/// A node of the half hole.
struct Row {
  double angle;  ///< from the pole, which is the first node [deg]
  double
      force;  ///< of the pin on the plate along the radius, of this half [kN], pushing > 0; at the pole that of its support
  double
      pressure;  ///< the same over the piece of the edge that the node stands for [kN/cm^2]; the plate is 1 cm thick
};

/// Where a contact ends.
struct End {
  double pressed;  ///< angle of the last node with a force [deg]
  double free;     ///< angle of the node behind it [deg]; 180 if there is none
};

/// Load that the forces of both halves carry along the pole.
/// \param rows  from the pole on, angles rising from 0 to 180 at most, two or more
/// \return load [kN]
/// \throws std::invalid_argument if the rows are not such rows
[[nodiscard]] double load_carried(const std::vector<Row>& rows);

/// Whether a contact could do what the support of the pole does.
/// \param rows  as for load_carried()
/// \return true if the support does not pull
/// \throws std::invalid_argument as load_carried()
[[nodiscard]] bool rightly_held(const std::vector<Row>& rows);

/// The two nodes between which the contact ends.
/// \param rows  as for load_carried(), at least one with a force
/// \return the last node with a force above 0, and its neighbour
/// \throws std::invalid_argument as load_carried(), or if no node has a force
[[nodiscard]] End end_of_contact(const std::vector<Row>& rows);

/// The piece of the edge that a node stands for.
/// \param rows  as for load_carried()
/// \param k     number of a row
/// \return length [cm]; 0 if the node has no pressure, which then tells nothing
/// \throws std::invalid_argument as load_carried(), or if there is no such row
[[nodiscard]] double piece_of(const std::vector<Row>& rows, std::size_t k);

/// Within which angle half of the load is carried.
/// \param rows  as for load_carried()
/// \return angle of the first node up to which, itself included, the forces carry at least half of load_carried() [deg]
/// \throws std::invalid_argument as load_carried(), or if the load is not positive
[[nodiscard]] double half_within(const std::vector<Row>& rows);

}  // namespace ex7_3
