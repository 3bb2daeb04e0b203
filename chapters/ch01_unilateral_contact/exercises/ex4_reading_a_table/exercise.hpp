/// \file
/// Exercise 1.4 - reading a table of candidates. Do not change this file.
#pragma once

namespace ex1_4 {

/// What the table of candidates says of the block on 8 x 4 cells, whose base is 40 mm long and whose thickness is 1 mm.
struct Answers {
  int overlapping = 0;  ///< candidates of the whole base that overlap without contact
  int closed = 0;       ///< candidates of the whole base that are closed in the end
  int sets = 0;         ///< sets of closed pairs among the candidates that overlap without contact
  double total_force = 0;  ///< sum of the contact forces of the whole base [N], to 0.01
  double lift = 0;      ///< by how much contact elsewhere lifts the node at x = 10 [mm], to 0.002
  double pressure = 0;  ///< of the middle node: force over its share of the base [N/mm^2], to 0.002
  double closed_at = 0;  ///< outermost place where the table has contact [mm]
  double open_at = 0;    ///< innermost place where it has none [mm], x > 0
};

/// \return your answers
[[nodiscard]] Answers answers();

}  // namespace ex1_4
