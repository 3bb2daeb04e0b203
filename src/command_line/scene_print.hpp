// What a plan and a solved scene say, for people and for programs.
#pragma once
#include <iosfwd>

#include "addons/files/json.hpp"
#include "command_line/scene_run.hpp"

namespace command_line {

/// Prints what a scene calls for and what that will cost.
/// \param out  where to
/// \param run  that is planned
void print_plan(std::ostream& out, const SceneRun& run);

/// Prints what a scene calls for.
/// \param out  where to
/// \param run  that is planned
void print_head(std::ostream& out, const SceneRun& run);

/// Prints what became of bodies and contacts.
/// \param out  where to
/// \param run  that has a solution
void print_result(std::ostream& out, const SceneRun& run);

/// Prints the plan in short, the result with forces and pressures, notes, and what it cost.
/// \param out  where to
/// \param run  that solve_scene() has finished with, solved or not
void print_solution(std::ostream& out, const SceneRun& run);

/// Writes phases, as a key of an object that is open.
/// \param json    the document
/// \param key     of the array
/// \param ledger  with the phases
void write_ledger(signorini::Json& json, const char* key, const signorini::Ledger& ledger);

/// Writes what a file calls for, as keys of an object that is open: file, title and plan.
/// \param json  the document
/// \param run   that is planned
void write_head(signorini::Json& json, const SceneRun& run);

/// Writes a solution, as keys of an object that is open, from notes to ledger.
/// \param json      the document
/// \param model     that was solved or not
/// \param solution  of it
/// \param probes    of the scene
/// \param state     after this load step; null: the solution is no step
void write_result(signorini::Json& json, const signorini::Model& model,
                  const signorini::Solution& solution, const std::vector<signorini::Probe>& probes,
                  const signorini::PathState* state);

/// Writes a scene as keys of an object that is open: plan, and as far as it came, certificate, ledger, pairs and notes.
/// \param json  the document
/// \param run   planned, solved or not
void write_keys(signorini::Json& json, const SceneRun& run);

/// Writes a scene as one object: plan, and as far as it came, certificate, ledger, pairs and notes.
/// \param json  the document
/// \param run   planned, solved or not
void write(signorini::Json& json, const SceneRun& run);

}  // namespace command_line
