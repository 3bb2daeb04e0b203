// Forces that a solution does not determine, and how far solvers differ.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "addons/files/json.hpp"
#include "addons/programme/dense_programme.hpp"
#include "command_line/outcome.hpp"

namespace command_line {

/// \param form      of a quadratic programme
/// \param solution  Solved
/// \return multipliers that could be others, with the rows of the two-sided programme
std::vector<signorini::ForceRange> undetermined_multipliers(
    const signorini::OneSided& form, const signorini::DenseSolution& solution);

/// \param groups  from undetermined_forces()
/// \return their ranges, one after another
std::vector<signorini::ForceRange> ranges_of(const std::vector<signorini::SharedForces>& groups);

/// Prints how far forces go that are not determined; nothing if all are.
/// \param out      where to
/// \param outcome  accepted
/// \param pairs    n_c: rows from there on are friction forces
/// \param what     names a row before that: "force of pair" or "multiplier of row"
void print_undetermined(std::ostream& out, const Outcome& outcome, Eigen::Index pairs,
                        const std::string& what);

/// Writes the same as a key of an object, an array; null where nothing bounds a force. \param json  the document
/// \param outcome  accepted \param pairs  as above
void write_undetermined(signorini::Json& json, const Outcome& outcome, Eigen::Index pairs);

/// Prints by how much accepted outcomes differ, and what that means; nothing of a single one.
/// \param out       where to
/// \param outcomes  of one problem
/// \param length    that gaps, slips or unknowns are measured by; 0: their largest
void print_agreement(std::ostream& out, const std::vector<Outcome>& outcomes, double length);

/// Writes the same as a key of an object; nothing if there are not two. \param json  the document
/// \param outcomes, length  as above
void write_agreement(signorini::Json& json, const std::vector<Outcome>& outcomes, double length);

}  // namespace command_line
