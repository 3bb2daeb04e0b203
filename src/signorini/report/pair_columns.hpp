// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What is known of every pair of a solution: the columns of every table and file that lists pairs.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "signorini/scene/readings.hpp"

namespace signorini {

/// One quantity of all pairs, a number each or a word each.
struct PairColumn {
  std::string name;        ///< over it in tables, and its key in JSON; one word
  std::string unit;        ///< dimension, such as `force/length^2`; `-` of words
  std::string field;       ///< its name among the point data of a VTU file; empty: it is not there
  Eigen::VectorXd values;  ///< `n_c`; of words their numbers; not a number where a pair has none
  std::vector<std::string> words = {};  ///< that the values number from 0; empty: they are numbers
  bool of_friction = false;             ///< whether it says nothing of pairs without friction

  /// \param pair  a pair \param format  of a number, as for number()
  /// \return its word or number as text; empty if it has none
  [[nodiscard]] std::string cell(Eigen::Index pair, const char* format = "%.10g") const;
};

/// Stops who asks for the pairs of a problem that is not solved.
/// \param solution  any
/// \param totals    of a path, if it is a step of one
/// \param function  what the message begins with
/// \throws std::invalid_argument if the problem is not solved, or the totals are of another number of slips
void check_solved(const Solution& solution, const std::optional<PathTotals>& totals,
                  const char* function);

/// \param model     that was solved
/// \param solution  of it
/// \return `n_c` friction force / weight [force/length^2], on the source along the tangent; 0 where a pair has no friction
[[nodiscard]] Eigen::VectorXd shear_tractions(const Model& model, const Solution& solution);

/// All columns of a solution. What a scene has not is no column.
///
/// Always, in this order: `x`, `y`, `gap`, `pressure`, `force`, `status` (open, closed). Then, except in load steps, `slip` of
/// the source along the tangent, which points to the right if one looks out of the target. In load steps there is `slip`
/// since the step before only with friction and only of frictional pairs, see increment(), and always `slip_total` from the
/// first step on, of all pairs.
///
/// With friction: `shear_traction` and `shear_force`, on the source along the tangent, before `slip`; `motion` (open,
/// stick, forward, backward) behind it, forward being slip > 0, against which the shear force is < 0; `dissipated`, the
/// work |shear force| |slip| >= 0 that sliding lost in the step. A pair without friction has shear force 0, dissipates
/// nothing, and has no motion.
///
/// With friction and totals of load steps: `slip_total` and `dissipated_total` at the end.
///
/// With several contacts: `contact`, its name as in Model::contacts.
/// \param model     that was solved
/// \param solution  of it
/// \param totals    after this step of a path, see totals(); nothing: the solution is no step
/// \return the columns, each with one value per pair
/// \throws std::invalid_argument if the problem is not solved, or the totals are of another number of slips
[[nodiscard]] std::vector<PairColumn> pair_columns(const Model& model, const Solution& solution,
                                                   const std::optional<PathTotals>& totals = {});

/// \param columns  from pair_columns()
/// \return their names, comma separated, with a line end
[[nodiscard]] std::string csv_head(const std::vector<PairColumn>& columns);

/// \param columns  from pair_columns()
/// \return a comma separated line for each pair, with 10 digits
[[nodiscard]] std::string csv_lines(const std::vector<PairColumn>& columns);

}  // namespace signorini
