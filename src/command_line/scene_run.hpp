// A scene file from its text to a solution, and the files that were asked for.
#pragma once
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "addons/files/problem_file.hpp"
#include "addons/files/scene_file.hpp"
#include "addons/frontal/backend.hpp"
#include "addons/prediction/prediction.hpp"
#include "addons/steps/steps.hpp"
#include "addons/vtu/vtu.hpp"
#include "command_line/drafts.hpp"
#include "command_line/quoting.hpp"
#include "signorini/report/pair_columns.hpp"
#include "signorini/scene/notes.hpp"

namespace command_line {

/// What `-` is called in messages.
constexpr const char* standard_input = "standard input";

/// \param file  a name, or `-` for standard input
/// \param most  bytes that a file may have
/// \return all of it
/// \throws signorini::ProblemError if it cannot be read
std::string content_of(const std::string& file,
                       std::size_t most = std::max(signorini::largest_scene_file,
                                                   signorini::largest_problem_file));

/// \param file  a name, or `-` for standard input
/// \return where files that its text names are looked for
std::filesystem::path folder_of(const std::string& file);

/// Which command a text was written for, as far as its first words tell.
/// \param content  of a file
/// \return "solve", "mesh", "lcp", "friction" or "qp"; empty if there is nothing in it
const char* command_for(const std::string& content);

/// \param command  of the program
/// \return what it takes, in words
const char* taken_by(const std::string& command);

/// Runs a reader of a text.
/// \param file     where the text comes from
/// \param content  the text
/// \param command  that is running
/// \param read     the reader
/// \return what it returns
/// \throws signorini::ProblemError of the reader, with a hint if the text looks as if it was written for another
///   command
template <typename Read>
auto read_or_hint(const std::string& file, const std::string& content, const char* command,
                  const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const signorini::ProblemError& error) {
    const std::string wanted = command_for(content);
    const bool same = wanted.empty() || wanted == command ||
                      (wanted == "solve" && std::string(command) == "plan");
    if (same) throw;
    throw signorini::ProblemError(signorini::text(file, ": this looks like a ", taken_by(wanted),
                                                  "; run: signorini ", wanted, " ",
                                                  file == standard_input ? "-" : for_shell(file)));
  }
}

/// What probes read in a load step.
struct ProbedStep {
  double time;                                                ///< when it ended
  std::vector<std::vector<signorini::PairColumn>> of_probes;  ///< of each, see signorini::probed()
};

/// What was made of a scene file, as far as it came.
struct SceneRun {
  /// As it was read, with what the command line changes; the scene file is one of its `files`.
  signorini::SceneFile file;
  signorini::Plan
      plan;  ///< of its scene; after solve_scene() without bodies, which are in the model
  signorini::Prediction prediction;       ///< of the plan
  signorini::PathState from = {};         ///< where load steps go on
  std::optional<signorini::Model> model;  ///< after solve_scene()
  std::optional<signorini::Solution>
      solution;  ///< after solve_scene(); of load steps, of the last good one
  std::optional<signorini::PathEnd> end;        ///< of load steps, after solve_scene()
  std::vector<signorini::Ledger> ledgers = {};  ///< of the solution, or of all load steps
  /// Of load steps with probes: the first steps, one more than are printed.
  std::vector<ProbedStep> probed_steps = {};
  /// Of load steps: what every process did, empty if the back end works alone.
  signorini::Ledger processes = {};

  /// \return whether there is a solution, of load steps of all of them
  [[nodiscard]] bool solved() const;
  /// \return where the load steps ended; null without load steps
  [[nodiscard]] const signorini::PathState* state() const;
  /// \return the notes of the solution, else of the model, else of the plan
  [[nodiscard]] const std::vector<std::string>& notes() const;
  /// Does something with the scene. \param action  to be done \return what it returns
  /// \throws signorini::ProblemError as the action, with the line and the notes so far
  template <typename Action>
  auto step(const Action& action) const -> decltype(action()) {
    return signorini::at_file(file, [&] { return signorini::with_context(notes(), action); });
  }
};

/// How far the node moves that moves farthest.
struct Farthest {
  double length = 0;      ///< of its displacement [length]
  Eigen::Index node = 0;  ///< its number
};

/// \param displacements  `n_nodes x 2` [length], also such whose squares are no doubles
/// \return the farthest of them
Farthest farthest(const signorini::NodeArray& displacements);

/// What the command line says of how a scene is solved.
struct Means {
  std::string solver;               ///< in the place of that of the file, unless it is empty
  std::string backend = "frontal";  ///< who factors K
  const signorini::Team* team =
      {};  ///< of the back end, is told the text of the file; null if it works alone
};

/// \param some  notes \param notes  that get them too
void add_notes(const std::vector<std::string>& some, std::vector<std::string>& notes);

/// Reads a scene file and plans it.
/// \param file     a name, or `-`
/// \param means    to solve it with
/// \param command  that is running
/// \return scene, plan and prediction
/// \throws signorini::ProblemError for what is wrong with it, with its line
SceneRun plan_scene(const std::string& file, const Means& means, const char* command);

/// Builds, condenses and solves, step by step if the scene has load steps; says on a terminal what it is doing.
/// \param run      from plan_scene()
/// \param observe  called after every load step that was solved
/// \throws signorini::ProblemError as signorini::condense(), with the line, or as signorini::check_state()
void solve_scene(SceneRun& run, const signorini::StepObserver& observe = {});

/// \param output  what is asked for \return the names of its files
std::vector<std::string> files_of(const signorini::Output& output);

/// \param output  what is asked for \return how numbers of its VTU files are written
signorini::VtuNumbers numbers_of(const signorini::Output& output);

/// Writes what the scene file and the command line ask for.
/// \param run     that is solved
/// \param drafts  of its files
/// \throws signorini::ProblemError if a file cannot be written or drawn; then none of them appears
void write_outputs(const SceneRun& run, Drafts& drafts);

}  // namespace command_line
