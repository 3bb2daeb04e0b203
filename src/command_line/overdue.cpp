#include "command_line/overdue.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>

#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/table.hpp"
#include "signorini/solvers/solvers.hpp"

namespace command_line {
namespace {

using namespace signorini;

constexpr double times = 10;
constexpr double patience = 2;  // [s]

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
      if (figure.trust == Trust::Unknown)
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
    if (plan.solver != solver.name && too_many(solver, plan.gaps.pairs.weight.size()).empty())
      others.push_back(solver);
  return text(
      "Fewer pairs help, by a coarser side as source; ",
      plan.modes.empty() ? "" : "supports or soft springs for bodies that only contact holds; ",
      "or another method, --solver NAME with one of ", names_of(others));
}

/// What the handler writes: all that it may use are calls that are safe in a signal.
std::string& pending() {
  static std::string line;
  return line;
}

void write_pending(int /*signal*/) {
  const int before = errno;
  static_cast<void>(!write(STDERR_FILENO, pending().data(), pending().size()));
  errno = before;
}

void set_timer(double seconds) {
  itimerval timer{};
  const double whole = std::floor(seconds);
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>(999999 * (seconds - whole));
  setitimer(ITIMER_REAL, &timer, nullptr);
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
  return std::max(patience, times * forecast(stage, prediction).seconds);
}

std::string overdue_words(const Stage& stage, const Plan& plan, const Prediction& prediction) {
  const Forecast before = forecast(stage, prediction);
  const std::string seconds = number(before.seconds, "%.2g") + " s";
  return text("signorini: ", stage.name, " has taken ",
              number(overdue_after(stage, prediction), "%.2g"), " s, more than ", times, " times ",
              before.known ? "its forecast of " + seconds
                           : "the " + seconds +
                                 " that it takes with one iteration of contact; how many there "
                                 "are is not known before",
              ". ", &stage == &solving() ? faster_contact(plan) : faster_factor(prediction));
}

Overdue::Overdue(double seconds, const std::string& line) {
  pending() = line + '\n';
  struct sigaction action {};
  action.sa_handler = write_pending;
  action.sa_flags = SA_RESTART;  // reading and writing go on as if nothing had happened
  sigaction(SIGALRM, &action, nullptr);
  set_timer(std::clamp(seconds, 1e-5, 1e8));
}

Overdue::~Overdue() { set_timer(0); }

}  // namespace command_line
