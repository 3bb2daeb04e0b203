/// \file
/// Exercise 9.3 - reading the rows of a contact. Do not change this file.
#pragma once
#include <vector>

namespace ex9_3 {

/// What the displacement of a node does to a gap.
struct Entry {
  int node;        ///< number of the node
  bool of_source;  ///< whether it is a node of the source, else of the target
  double x, y;     ///< how much the gap grows if the node moves by 1 along x and along y [-]
};

/// A gap, in the order in which somebody wrote it down: entries may come in any order.
using Row = std::vector<Entry>;

/// A node of the target and its part of the reaction.
struct Share {
  int node;  ///< of the target
  double N;  ///< shape function at the place that the source faces [-], > 0
};

/// What a row of a node over an edge says. \PaperEq{LinEtAl, 21} \PaperEq{LinEtAl, 22} \PaperEq{LinEtAl, 27}
struct Reading {
  int source;     ///< its node
  double nx, ny;  ///< normal out of the target [-]
  std::vector<Share>
      shares;  ///< by rising number of the node; who has less than 1e-12 is not named
};

/// Reads a row.
/// \param row  of one node of the source over an edge of the target
/// \return who presses on whom, where
/// \throws std::invalid_argument unless just one entry belongs to the source
[[nodiscard]] Reading reading_of(const Row& row);

/// What the nodes of the target get. \PaperEq{LinEtAl, 27}
/// \param rows   of a contact
/// \param force  f_n of each row [force], compression > 0
/// \param nodes  some nodes of the target
/// \return sum of the shares of all forces at each of these nodes, in their order [force]; magnitudes, whatever the normals
/// \throws std::invalid_argument as reading_of(), or if there are not as many forces as rows
[[nodiscard]] std::vector<double> reached(const std::vector<Row>& rows,
                                          const std::vector<double>& force,
                                          const std::vector<int>& nodes);

/// The nodes of the target that no force can reach.
/// \param rows   of a contact
/// \param nodes  all nodes of the target's boundary
/// \return those without a share in any row, in the order of `nodes`
/// \throws std::invalid_argument as reading_of()
[[nodiscard]] std::vector<int> untouched(const std::vector<Row>& rows,
                                         const std::vector<int>& nodes);

}  // namespace ex9_3
