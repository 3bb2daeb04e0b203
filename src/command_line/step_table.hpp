// A table that load steps add rows to, each with its time.
#pragma once
#include <optional>
#include <string>
#include <utility>

#include "addons/steps/steps.hpp"
#include "command_line/drafts.hpp"

namespace command_line {

/// A comma separated file whose first column is `time`. Its lines so far are there, complete, before the next step begins.
class StepTable {
 public:
  /// \param file  its name; empty: none is wanted, and nothing below does anything
  explicit StepTable(std::string file) : file_(std::move(file)) {}
  /// Takes over the lines until the time of a state.
  /// \param from  that a run goes on from
  /// \param rows  that it must have until then; nothing: any number
  /// \return whether the file is there; if not, what follows begins a new one
  /// \throws signorini::ProblemError if the file has other steps before
  bool keep(const signorini::PathState& from, std::optional<Eigen::Index> rows);
  /// Adds the lines of a step, and appends them if the file is begun.
  /// \param time   when it ended
  /// \param table  of the step: comments, names of columns and rows
  /// \throws signorini::ProblemError if the table has other columns before
  void add(double time, const std::string& table);
  /// Begins the file, unless it is. \param drafts  of the run
  void begin(Drafts& drafts);
  /// \return whether a file is wanted
  [[nodiscard]] bool wanted() const { return !file_.empty(); }

 private:
  std::string file_;
  signorini::PathState from_;
  std::string head_;   // names of the columns; empty until there are some
  std::string lines_;  // not yet written
  bool begun_ = false;
};

/// \param file  a name \return what it holds, nothing if there is none
std::string content_if_any(const std::string& file);

/// Refuses to go on in a file of other steps. \param right  whether it is that of the state
/// \param file  its name \param from  the state
/// \throws signorini::ProblemError unless it is right
void check_begun(bool right, const std::string& file, const signorini::PathState& from);

}  // namespace command_line
