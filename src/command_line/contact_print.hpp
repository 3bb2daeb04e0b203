// What contact did in a solution, for people and for programs.
#pragma once
#include <iosfwd>
#include <string>

#include "addons/files/json.hpp"
#include "addons/steps/steps.hpp"
#include "signorini/report/pair_columns.hpp"

namespace command_line {

/// \param force  any
/// \param axial  whether in axial symmetry
/// \return the force as text; what pushes along the radius all round the axis has no sum
std::string force_in_words(const Eigen::Vector2d& force, bool axial);

/// Prints a table with 6 digits.
/// \param out      where to
/// \param columns  of it
/// \param rows     that are printed
void print_rows(std::ostream& out, const std::vector<signorini::PairColumn>& columns,
                const std::vector<Eigen::Index>& rows);

/// Prints of each contact its sums, and its closed pairs if they are few.
/// \param out       where to
/// \param model     that was solved
/// \param solution  of it
/// \param state     after this step of a path; null: the solution is no step
void print_contacts(std::ostream& out, const signorini::Model& model,
                    const signorini::Solution& solution, const signorini::PathState* state);

/// Prints of each bond with sides what it carries.
/// \param out       where to
/// \param model     that was solved
/// \param solution  of it, Solved
void print_bonds(std::ostream& out, const signorini::Model& model,
                 const signorini::Solution& solution);

/// Writes the key `bonds`: what each with sides carries; nothing without equations.
/// \param json      an object
/// \param model     that was solved
/// \param solution  of it, Solved
void write_bonds(signorini::Json& json, const signorini::Model& model,
                 const signorini::Solution& solution);

/// Writes the keys `resultants`, `contacts` and `pairs`: sums, those of each contact, and the columns of all pairs.
/// \param json      an object
/// \param model     that was solved
/// \param solution  of it
/// \param state     as above
void write_contacts(signorini::Json& json, const signorini::Model& model,
                    const signorini::Solution& solution, const signorini::PathState* state);

}  // namespace command_line
