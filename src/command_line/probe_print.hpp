// What probes read in a solution, for people and for programs.
#pragma once
#include <iosfwd>
#include <string>

#include "addons/files/json.hpp"
#include "command_line/scene_run.hpp"

namespace command_line {

/// Keeps what the probes read in a load step, as long as it may be printed.
/// \param run    that gets it
/// \param model  as loaded in the step
/// \param step   that was solved
void keep_probes(SceneRun& run, const signorini::Model& model, const signorini::Step& step);

/// Prints a table for each probe; nothing without probes. A probe that reads one row has one for each load step, if they are few,
/// all others one of the last step.
/// \param out  where to
/// \param run  that has a solution
void print_probes(std::ostream& out, const SceneRun& run);

/// \param probes    of the scene, one or more
/// \param model     that was solved
/// \param solution  of it
/// \param state     after this step of a path; null: the solution is no step
/// \return what all of them read, as one comma separated table
std::string probes_csv(const std::vector<signorini::Probe>& probes, const signorini::Model& model,
                       const signorini::Solution& solution, const signorini::PathState* state);

/// Writes the key `probes`: name, body, columns and units of each; nothing without probes.
/// \param json      an object
/// \param probes    of the scene
/// \param model     that was solved
/// \param solution  of it
/// \param state     as above
void write_probes(signorini::Json& json, const std::vector<signorini::Probe>& probes,
                  const signorini::Model& model, const signorini::Solution& solution,
                  const signorini::PathState* state);

}  // namespace command_line
