// Tables for people and JSON for programs.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "addons/files/json.hpp"
#include "command_line/outcome.hpp"

namespace command_line {

/// Solutions of more unknowns than this are not printed, only written as JSON.
constexpr Eigen::Index largest_printed = 30;

/// Begins a document: what it is, so that who reads it can tell. docs/signorini.schema.json describes all of it.
/// \param json  new
/// \param kind  "plan", "solution", "steps" or "accuracy" of a scene; "lcp", "friction" or "qp"
void begin_document(signorini::Json& json, const char* kind);

/// Prints the family of solvers with the traits on which each may fail, and that of back ends.
/// \param out  where to
void print_family(std::ostream& out);

/// Prints what a problem without or with friction is, what the solvers made of it, and the solution.
/// \param out       where to
/// \param filed     the problem
/// \param title     of the problem
/// \param kind      of its matrix
/// \param outcomes  one for each solver
void print(std::ostream& out, const std::string& title, const signorini::FiledProblem& filed,
           Matrix kind, const std::vector<Outcome>& outcomes);

/// The same for a quadratic programme.
/// \param out        where to
/// \param title      of the problem
/// \param programme  the problem
/// \param outcomes   one for each solver
void print(std::ostream& out, const std::string& title,
           const signorini::TwoSidedProgramme& programme, const std::vector<Outcome>& outcomes);

/// Writes the figures of a certificate.
/// \param json         the document
/// \param certificate  any; what is not finite becomes null
void write(signorini::Json& json, const signorini::Certificate& certificate);

/// Writes one problem and its outcomes as an object.
/// \param json      the document
/// \param filed     the problem
/// \param kind      of its matrix
/// \param outcomes  one for each solver
/// \param solved    the verdict
void write(signorini::Json& json, const signorini::FiledProblem& filed, Matrix kind,
           const std::vector<Outcome>& outcomes, bool solved);

/// The same for a quadratic programme.
/// \param json       the document
/// \param programme  the problem
/// \param outcomes   one for each solver
/// \param solved     the verdict
void write(signorini::Json& json, const signorini::TwoSidedProgramme& programme,
           const std::vector<Outcome>& outcomes, bool solved);

}  // namespace command_line
