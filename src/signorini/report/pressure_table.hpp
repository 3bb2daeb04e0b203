/// \file
/// What contact did, pair by pair, and in sum.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "signorini/scene/readings.hpp"

namespace signorini {

/// Sums over pairs: all of a model, or those of one contact.
struct Resultants {
  Eigen::Vector2d force;  ///< of the targets on the sources [force]
  double moment;          ///< of these forces about the origin [force length], anticlockwise > 0
  double closed_weight;   ///< weights of the closed pairs [length^2], see Pairs
  double peak_pressure;   ///< largest of a pair [force/length^2], compression > 0
  double target_moment =
      0;  ///< of the opposite forces on the targets about the origin [force length]
  double normal_force = 0;      ///< sum of the contact forces of the pairs [force], compression > 0
  double shear_force = 0;       ///< sum of their friction forces, each along its tangent [force]
  double dissipated = 0;        ///< work that sliding lost in this step [force length], >= 0
  double dissipated_total = 0;  ///< and in all steps so far; without steps the same
  Eigen::Index pairs = 0;       ///< how many there are
  Eigen::Index closed = 0;      ///< of them
  Eigen::Index frictional_pairs = 0;  ///< pairs that have friction, open or closed
  Eigen::Index stick = 0;             ///< closed pairs that have friction and do not slide
  Eigen::Index slide = 0;             ///< closed pairs that slide
};

/// Sums the contact forces of a solution, friction included, as they act on the nodes before loading: with the loads and
/// the forces of supports they are in balance, on either side. In axial symmetry they are those of the whole circle, whose
/// radial forces and moments cancel.
/// \param model     that was solved
/// \param solution  of it
/// \param totals    after this step of a path, see totals(); nothing: the solution is no step
/// \return the sums, all 0 without contact
/// \throws std::invalid_argument if the problem is not solved, or the totals are of another number of slips
[[nodiscard]] Resultants resultants(const Model& model, const Solution& solution,
                                    const std::optional<PathTotals>& totals = {});

/// The same for each contact.
/// \param model     that was solved
/// \param solution  of it
/// \param totals    as above
/// \return one for each of Model::contacts, in their order
/// \throws std::invalid_argument as resultants()
[[nodiscard]] std::vector<Resultants> resultants_of_contacts(
    const Model& model, const Solution& solution, const std::optional<PathTotals>& totals = {});

/// The table as comma separated text: the columns of pair_columns(), one line per pair.
///
/// Lines come in the order of the boundary, with 10 digits; the first line names the columns. Comments in front of it
/// give the notes of the solution and the resultants, of each contact if there is friction or there are several.
/// \param model      that was solved
/// \param solution   of it
/// \param tolerance  if not empty, goes in front as the comment `# tolerance <tolerance>`
/// \param totals     after this step of a path, see totals(); nothing: the solution is no step
/// \return the text
/// \throws std::invalid_argument as pair_columns()
[[nodiscard]] std::string pressure_csv(const Model& model, const Solution& solution,
                                       const std::string& tolerance = "",
                                       const std::optional<PathTotals>& totals = {});

}  // namespace signorini
