#include "command_line/overdue.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <system_error>

#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/table.hpp"

namespace command_line {
namespace {

using namespace signorini;

constexpr double overdue_times = 10;
constexpr double patience = 2;   // [s]
constexpr double longest = 1e8;  // [s], three years; what a clock counts may not be much more

/// What the phases of a stage are said to take.
struct Forecast {
  double seconds = 0;
  bool known = true;  // or with one iteration of contact only
};

Forecast forecast(const Stage& stage, const Prediction& prediction) {
  Forecast all;
  for (const PredictedFigure& figure : prediction.figures)
    for (const char* phase : stage.phases) {
      if (figure.phase != phase || figure.what.find("seconds") != 0) continue;
      if (figure.certainty == Certainty::Unknown)
        all.known = false;
      else
        all.seconds += figure.amount;
    }
  return all;
}

std::string faster_factor(const Prediction& prediction) {
  double bytes = 0;
  for (const PredictedFigure& figure : prediction.figures)
    if (figure.what == "bytes" || figure.what == "stack bytes") bytes += figure.amount;
  return text("The machine may be busy, or short of memory, of which about ",
              number(bytes / 1e6, "%.3g"), " MB are needed; a coarser mesh helps");
}

std::string faster_contact(const Plan& plan) {
  std::vector<Solver> others;
  for (const Solver& solver : plan.law.pair.empty() ? solvers() : friction_solvers())
    if (plan.solver.solve != solver.solve &&
        too_many(solver, plan.gaps.pairs.weight.size()).empty())
      others.push_back(solver);
  return text(
      "Fewer pairs help, by a coarser side as source; ",
      plan.modes.empty() ? "" : "supports or soft springs for bodies that only contact holds; ",
      "or another method, --solver NAME with one of ", names_of(others));
}

}  // namespace

const Stage& assembling() {
  static const Stage stage{"assembly", {"assembly"}};
  return stage;
}

const Stage& condensing() {
  static const Stage stage{
      "factor and condensation",
      {"factor/ordering", "factor/symbolic", "factor/numeric", "condensation"}};
  return stage;
}

const Stage& solving() {
  static const Stage stage{"contact and refinement", {"contact", "refinement"}};
  return stage;
}

double overdue_after(const Stage& stage, const Prediction& prediction) {
  return std::max(patience, overdue_times * forecast(stage, prediction).seconds);
}

std::string overdue_words(const Stage& stage, const Plan& plan, const Prediction& prediction) {
  const Forecast before = forecast(stage, prediction);
  const std::string seconds = number(before.seconds, "%.2g") + " s";
  return text("signorini: ", stage.name, " has taken ",
              number(overdue_after(stage, prediction), "%.2g"), " s, more than ", overdue_times,
              " times ",
              before.known ? "its forecast of " + seconds
                           : "the " + seconds +
                                 " that it takes with one iteration of contact; how many there "
                                 "are is not known before",
              ". ", &stage == &solving() ? faster_contact(plan) : faster_factor(prediction));
}

Overdue::Overdue(double seconds, const std::string& line) {
  const std::chrono::duration<double> patient(std::min(seconds, longest));
  try {
    clock_ = std::thread([this, patient, whole = line + '\n'] {
      std::unique_lock<std::mutex> lock(guard_);
      if (!end_.wait_for(lock, patient, [this] { return ended_; }))
        std::cerr << whole << std::flush;
    });
  } catch (const std::system_error&) {
    // A machine without room for a thread: the work goes on unwatched.
  }
}

Overdue::~Overdue() {
  if (!clock_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(guard_);
    ended_ = true;
  }
  end_.notify_one();
  clock_.join();
}

}  // namespace command_line
