// A scene solved to an accuracy: what is asked for, and what is said about it.
#pragma once
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "addons/estimate/accuracy.hpp"
#include "addons/files/json.hpp"
#include "command_line/scene_run.hpp"

namespace command_line {

/// \param word  of the command line \return the number above 0 that is all of it; nothing if it is none
[[nodiscard]] std::optional<double> positive(const std::string& word);

/// What the command line asks for, as it was written.
struct AccuracyWish {
  std::string target;    ///< such as `0.5%`; empty: nothing is asked for
  std::string goal;      ///< see signorini::goal_in_words(); empty: the usual one
  std::string unknowns;  ///< that a mesh may have; empty: what signorini::Accuracy allows
};

/// What became of it.
struct AccuracyRun {
  signorini::Accuracy wanted;                         ///< with the goal
  std::string why;                                    ///< that goal, if nobody asked for it
  std::vector<signorini::AccuracyRound> rounds = {};  ///< one or more
  std::vector<signorini::BudgetLine> budget = {};     ///< of the last solution, if it was estimated
  bool met = false;                                   ///< whether it is accurate enough
  std::string verdict = {};                           ///< in words
};

/// Reads what is asked for.
/// \param wish  with a target
/// \param run   from plan_scene()
/// \return with nothing solved yet
/// \throws signorini::ProblemError saying what was expected, or that the scene has load steps
AccuracyRun understood(const AccuracyWish& wish, const SceneRun& run);

/// Solves and refines.
/// \param[in,out] run       from plan_scene(); gets the last meshes, plan, prediction and solution
/// \param[in,out] accuracy  from understood()
/// \param observe  called after every round
/// \throws signorini::ProblemError as signorini::solve_to_accuracy(), with the line
void solve_to_accuracy(SceneRun& run, AccuracyRun& accuracy,
                       const std::function<void(const AccuracyRun&)>& observe);

/// Prints the head of the table of rounds, and what is asked for. \param out where to \param accuracy understood
void print_wish(std::ostream& out, const AccuracyRun& accuracy);
/// Prints the last round. \param out where to \param accuracy with one or more
void print_round(std::ostream& out, const AccuracyRun& accuracy);
/// Prints how it ended, and the error budget. \param out where to \param accuracy that has ended
void print_verdict(std::ostream& out, const AccuracyRun& accuracy);
/// Writes all of it, as a key of an object that is open. \param json the document \param accuracy that has ended
void write(signorini::Json& json, const AccuracyRun& accuracy);

}  // namespace command_line
