// Load steps of a scene file: what is said and written after each.
#pragma once
#include <string>
#include <vector>

#include "command_line/scene_run.hpp"
#include "signorini/report/json.hpp"
#include "signorini/report/vtu.hpp"

namespace command_line {

/// Makes a run go on from a state that was saved.
/// \param run   from plan_scene(), of a scene with load steps
/// \param file  that --state wrote
/// \throws signorini::ProblemError if it is none, or the load steps end before it
void go_on(SceneRun& run, const std::string& file);

/// The files of a path: those of a step are there, complete, before the next one begins.
class PathFiles {
 public:
  /// \param run   that will be solved
  /// \param read  what it was read from
  /// \throws signorini::ProblemError as Drafts
  PathFiles(const SceneRun& run, std::string read);
  /// Writes fields, collection and state, and keeps the rows of the table.
  /// \param model  as loaded in the step
  /// \param step   the next one
  /// \throws signorini::ProblemError if a file cannot be written
  void add(const signorini::Model& model, const signorini::Step& step);
  /// Writes the table of all steps, and the picture of the last good one.
  /// \param run  after solve_scene(), with one good step or more
  /// \throws signorini::ProblemError if a file cannot be written or drawn
  void finish(const SceneRun& run) const;

 private:
  signorini::Output wanted_;
  std::string read_;
  std::string table_;
  std::vector<signorini::TimedFile> fields_;
};

/// Prints the names of the columns of print_step().
/// \param out  where to
/// \param run  that is planned
void print_step_head(std::ostream& out, const SceneRun& run);

/// Prints one line.
/// \param out    where to
/// \param run    that is planned
/// \param model  as loaded in the step
/// \param step   that was solved
void print_step(std::ostream& out, const SceneRun& run, const signorini::Model& model,
                const signorini::Step& step);

/// Prints how the path ended, what the last good step found, and what all cost.
/// \param out  where to
/// \param run  after solve_scene()
void print_end(std::ostream& out, const SceneRun& run);

/// Writes a step as one object.
/// \param json   the document
/// \param run    that is planned
/// \param model  as loaded in the step
/// \param step   that was solved
void write_step(signorini::Json& json, const SceneRun& run, const signorini::Model& model,
                const signorini::Step& step);

/// Writes how the path ended, as keys of an object that is open.
/// \param json  the document
/// \param run   after solve_scene()
void write_end(signorini::Json& json, const SceneRun& run);

}  // namespace command_line
