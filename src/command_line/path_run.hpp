// Load steps of a scene file: what is said and written after each.
#pragma once
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "addons/files/json.hpp"
#include "addons/files/pvd.hpp"
#include "command_line/scene_run.hpp"
#include "command_line/step_table.hpp"

namespace command_line {

/// The files of a path: those of a step are there, complete, before the next one begins. A path that goes on keeps what
/// files of the same names say of the steps before; no other run writes them.
class PathFiles {
 public:
  /// \param run  that will be solved
  /// \throws signorini::ProblemError as Drafts
  explicit PathFiles(const SceneRun& run);
  /// Makes the run go on from a state that was saved.
  /// \param run   as before
  /// \param file  that --state wrote
  /// \throws signorini::ProblemError if it is none, the load steps end before it, or a table or a collection has other
  ///   steps before
  void go_on(SceneRun& run, const std::string& file);
  /// Writes fields, collection, the rows of the table and the state.
  /// \param model  as loaded in the step
  /// \param step   the next one
  /// \throws signorini::ProblemError if a file cannot be written, or the table has other columns before
  void add(const signorini::Model& model, const signorini::Step& step);
  /// Draws the picture of the last good step.
  /// \param run  after solve_scene(), with one good step or more
  /// \throws signorini::ProblemError if a file cannot be written or drawn
  void finish(const SceneRun& run);
  /// \return files of a path that goes on which are new, so that the steps before are missing
  [[nodiscard]] const std::vector<std::string>& late() const { return late_; }

 private:
  void keep_fields(const signorini::PathState& from, const std::string& all);

  std::string name_;  // of the scene
  signorini::Output wanted_;
  std::vector<signorini::Probe> probes_;
  Drafts drafts_;
  StepTable table_;
  StepTable probe_table_;
  std::vector<signorini::TimedFile> fields_;
  std::vector<std::string> late_;
};

/// Tells of a path: a line for each step as soon as it is solved, or one JSON document at the end.
class PathTeller {
 public:
  /// \param out   where to
  /// \param json  a document in the place of lines
  /// \param late  files in which the steps before are missing
  PathTeller(std::ostream& out, bool json, std::vector<std::string> late)
      : out_(out), late_files_(std::move(late)), as_json_(json) {}
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
  void print_notes();

  /// What was noted in some steps. Notes that differ in numbers only are one.
  struct TimedNote {
    std::string kind;      // the note without numbers
    std::string note;      // as it was last
    bool in_head = false;  // whether the first step has it
    double first = 0;      // time
    double last = 0;       // time
    Eigen::Index last_step = 0;
    Eigen::Index steps = 0;  // in how many
    bool gone = false;       // in a step between
  };

  std::ostream& out_;
  std::vector<std::string> late_files_;
  signorini::Json json_;
  bool as_json_;
  bool begun_ = false;
  bool noted_ = false;
  std::vector<TimedNote> notes_;
};

}  // namespace command_line
