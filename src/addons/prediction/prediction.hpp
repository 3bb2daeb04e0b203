/// \file
/// What a plan will cost, said before there is a number, and what it did cost.
#pragma once
#include <any>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// What figures are about that are no phase of the ledger: the whole run.
inline constexpr const char* all_phases = "all phases";
/// The same: a load step after the first.
inline constexpr const char* later_step = "a later step";
/// The count of a phase whose number of iterations is not known beforehand.
inline constexpr const char* one_iteration = "seconds of one iteration";

/// How a figure of a prediction is meant.
enum class Certainty {
  Exact,  ///< it will be so
  Estimate,  ///< of what depends on the numbers of the problem, or on the machine and who else works on it
  AtLeast,  ///< an estimate without that part of it which is not known
  Unknown   ///< the amount is not known beforehand, and not a number
};

/// How often something is made.
enum class Frequency {
  Once,         ///< for all loads
  PerStep,      ///< for every set of loads
  PerIteration  ///< of contact or of refinement
};

/// One line of a prediction.
struct PredictedFigure {
  Frequency frequency = Frequency::Once;  ///< how often what it is about is made
  std::string phase;                      ///< of the ledger, or what is not in the ledger
  std::string what;                       ///< `seconds`, `bytes`, or the name of a count
  double amount = 0;  ///< how much, over the whole run; NaN if that is not known
  Certainty certainty = Certainty::Exact;  ///< how it is meant
};

/// What acts on a body, and whether it is one.
struct BodySummary {
  std::string name;           ///< of its mesh
  Eigen::Index unknowns = 0;  ///< of this body
  Eigen::Index pieces = 0;    ///< that share no node with each other
  Eigen::Vector2d force;      ///< sum of all loads, on held nodes too [force]
  double moment = 0;          ///< of the loads about the origin, anticlockwise > 0 [force length]
};

/// What a plan will cost.
struct Prediction {
  std::vector<BodySummary> bodies;       ///< as in the plan
  std::string method;                    ///< which, and why
  std::string unknown;                   ///< why some figures are not known; empty if all are
  std::vector<PredictedFigure> figures;  ///< in the order in which a run meets them
  /// Of elimination, which had to be found: a run that has it as Plan::order need not find it again. Empty for other back ends
  std::any order;
  Ledger taken;  ///< what a run that begins with it has done already

  /// One figure.
  /// \param phase  of it \param what  of it
  /// \return its amount, 0 if there is none
  [[nodiscard]] double amount(const std::string& phase, const std::string& what) const;
};

/// Predicts what build(), condense() and solve() will cost; these do not ask for it.
///
/// The pattern of K, the tree of separators and the fronts are made as condense() makes them, without numbers:
/// entries, bytes and operations of K, of the factor, of the rows of A and of the compliance are exact; of another back end
/// than ours those of the factor are estimates. Where a working set is tried, see working_set_pays(), the figures of the compliance
/// are those of all pairs, which it will not exceed if it arrives. How often
/// contact and refinement go round depends on the numbers, so what hangs on that is an estimate: five contact
/// iterations if there are gaps, with half of the rows closed, and one refinement of the set that they end with, all
/// that for every load step and every system that nothing connects with others. If pairs have friction, if rigid motions are
/// unknowns, or if another solver than the default one is asked for, there is no such number: the iterations are not
/// known, only what one of them takes.
/// Seconds come from the speed of this machine on fronts of these sizes, on a walk through the memory and on the
/// first cells of every body, measured now in some milliseconds.
/// \param plan  from plan()
/// \return the prediction
/// \throws ProblemError as assemble() of some cells
[[nodiscard]] Prediction predict(const Plan& plan);

/// A figure and what became of it.
struct ComparedFigure {
  PredictedFigure predicted;       ///< before the run
  std::optional<double> measured;  ///< after it; none if the ledger does not have it
};

/// Sets a prediction against the ledger of the run.
/// \param prediction  of the plan
/// \param ledgers     of build(), condense() and solve(), or of all load steps: what they have in common adds up; the seconds of
///   a later step are those of all but the first, on average
/// \return all its figures
[[nodiscard]] std::vector<ComparedFigure> compare(const Prediction& prediction,
                                                  const std::vector<Ledger>& ledgers);

/// Prints bodies, method, and what is made how often. \param out where to \param prediction what \return `out`
std::ostream& operator<<(std::ostream& out, const Prediction& prediction);

/// Prints a table of predicted and measured figures. \param out where to \param figures what \return `out`
std::ostream& operator<<(std::ostream& out, const std::vector<ComparedFigure>& figures);

/// \param certainty  any \return "exact", "about", "at least" or "not known"
[[nodiscard]] const char* to_string(Certainty certainty);
/// \param frequency  any \return "once", "per load step" or "per iteration"
[[nodiscard]] const char* to_string(Frequency frequency);

}  // namespace signorini
