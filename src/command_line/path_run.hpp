// Load steps of a scene file: what is said and written after each.
#pragma once
#include <iosfwd>
#include <set>
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

/// The files of a path: those of a step are there, complete, before the next one begins. A path that goes on keeps what
/// files of the same names say of the steps before.
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

/// Tells of a path: a line for each step as soon as it is solved, or one JSON document at the end.
class PathTeller {
 public:
  /// \param out   where to
  /// \param json  a document in the place of lines
  PathTeller(std::ostream& out, bool json) : out_(out), as_json_(json) {}
  /// \param run    what is being solved
  /// \param model  as loaded in the step
  /// \param step   that was solved
  void tell(const SceneRun& run, const signorini::Model& model, const signorini::Step& step);
  /// Tells how the path ended, what the last good step found, and what all cost.
  /// \param run  after solve_scene()
  void end(const SceneRun& run);

 private:
  void begin(const SceneRun& run);
  void keep_notes(const signorini::Step& step);

  std::ostream& out_;
  signorini::Json json_;
  bool as_json_;
  bool begun_ = false;
  bool noted_ = false;
  std::set<std::string> told_;  // notes up to their first number
  std::string late_notes_;      // that no earlier step had
};

}  // namespace command_line
