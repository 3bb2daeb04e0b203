#include "command_line/accuracy_run.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <ostream>
#include <utility>

#include "addons/checks/point_supports.hpp"
#include "addons/estimate/goal_words.hpp"
#include "addons/steps/steps_limit.hpp"
#include "command_line/run_monitor.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"

namespace command_line {
namespace {

using namespace signorini;

/// A mesh that takes longer is solved only if --unknowns allows it.
constexpr double unasked_seconds = 10;

double target_of(const std::string& word) {
  const bool percent = !word.empty() && word.back() == '%';
  std::string digits = percent ? word.substr(0, word.size() - 1) : word;
  if (percent && !digits.empty() && digits.back() == ' ') digits.pop_back();
  const std::optional<double> value = positive(digits);
  require_input(value.has_value(),
                "--accuracy: expected a part above 0, such as 0.5% or 0.005, got ",
                in_quotes(word));
  const double part = percent ? *value / 100 : *value;
  require_input(part < 1, "--accuracy: expected less than 100%, got ", in_quotes(word),
                !percent && *value < 100 ? text("; did you mean '", word, "%'?") : "");
  return part;
}

double seconds(const std::vector<AccuracyRound>& rounds) {
  return std::accumulate(
      rounds.begin(), rounds.end(), 0.0,
      [](double sum, const AccuracyRound& round) { return sum + round.seconds; });
}

/// A part of an error by a value, with its sign; of a value of 0 in the unit of the goal.
std::string by_value(double part, double value, bool column = false) {
  if (value == 0) return number(part, column ? "%16.2g" : "%.2g");
  return number(100 * part / std::abs(value), column ? "%14.2g" : "%.2g") + " %";
}

}  // namespace

std::optional<double> positive(const std::string& word) {
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, failed] = std::from_chars(word.data(), end, value);
  if (failed != std::errc() || rest != end || !(value > 0) || !std::isfinite(value)) return {};
  return value;
}

AccuracyRun understood(const AccuracyWish& wish, const SceneRun& run) {
  AccuracyRun accuracy{{}, {}};
  accuracy.wanted.target = target_of(wish.target);
  accuracy.wanted.forecast = [](const Scene& scene) {
    return predict(plan(scene)).amount(all_phases, "seconds");
  };
  accuracy.wanted.solve = [](const Scene& scene, const Model& model, const Condensed& condensed,
                             Ledger ledger) {
    return solve_to_limit(scene, model, condensed, std::move(ledger));
  };
  accuracy.wanted.warnings = point_supports;
  if (!wish.unknowns.empty()) {
    const std::optional<double> most = positive(wish.unknowns);
    require_input(most.has_value(), "--unknowns: expected a number above 0, got ",
                  in_quotes(wish.unknowns));
    accuracy.wanted.most_unknowns = static_cast<Eigen::Index>(std::min(1e15, *most));
    const Eigen::Index first = count_unknowns(run.plan.bodies);
    require_input(first <= accuracy.wanted.most_unknowns, "--unknowns: the mesh of ", run.file.name,
                  " has ", first, " already, more than ", in_quotes(wish.unknowns),
                  "; allow more, or begin with a coarser mesh");
  } else {
    accuracy.wanted.most_seconds = unasked_seconds;
  }
  require_input(
      !run.file.scene.path, "--accuracy: ", run.file.name,
      " has load steps, and the error of a path is not estimated; leave the option or the steps "
      "out");
  if (!wish.goal.empty()) {
    accuracy.wanted.goal = goal_in_words(wish.goal, run.plan);
    return accuracy;
  }
  DefaultGoal goal = run.step([&] { return default_goal(run.file.scene, run.plan); });
  accuracy.wanted.goal = std::move(goal.goal);
  accuracy.why = std::move(goal.why);
  return accuracy;
}

void solve_to_accuracy(SceneRun& run, AccuracyRun& accuracy,
                       const std::function<void(const AccuracyRun&)>& observe) {
  const Progress progress("mesh 1");
  AccurateSolution result = run.step([&] {
    return signorini::solve_to_accuracy(
        run.file.scene, accuracy.wanted, [&](const AccuracyRound& round) {
          accuracy.rounds.push_back(round);
          progress.say("");
          observe(accuracy);
          progress.say(text("mesh ", accuracy.rounds.size() + 1, ", refined from one of ",
                            round.unknowns, " unknowns"));
        });
  });
  accuracy.met = result.met;
  accuracy.verdict = std::move(result.verdict);
  if (result.too_dear > 0) accuracy.verdict += text("; to go on, add --unknowns ", result.too_dear);
  if (result.estimate) accuracy.budget = error_budget(*result.estimate);
  run.file.scene = std::move(result.scene);
  run.plan = plan(run.file.scene);
  add_notes(run.file.notes, run.plan.notes);
  run.prediction = predict(run.plan);
  run.model = std::move(result.model);
  run.solution = std::move(result.solution);
  add_notes(run.file.notes, run.solution->notes);
  run.ledgers = {run.solution->ledger};
}

void print_wish(std::ostream& out, const AccuracyRun& accuracy) {
  out << "asked for: " << accuracy.wanted.goal.name << " within "
      << number(100 * accuracy.wanted.target, "%.3g") << " %"
      << (accuracy.why.empty() ? "" : "; " + accuracy.why) << "\n\n"
      << "  mesh   unknowns          value           error    seconds     price\n";
}

void print_round(std::ostream& out, const AccuracyRun& accuracy) {
  const AccuracyRound& round = accuracy.rounds.back();
  const auto columns = [&](double value, const char* format) { return number(value, format); };
  out << columns(static_cast<double>(accuracy.rounds.size()), "%6.0f")
      << columns(static_cast<double>(round.unknowns), "%11.0f");
  if (round.error)
    out << columns(round.value, "%15.6g") << by_value(*round.error, round.value, true);
  else
    out << "        too coarse for an estimate    ";
  out << columns(round.seconds, "%11.2g")
      << columns(seconds(accuracy.rounds) / accuracy.rounds.front().seconds, " %9.4g") << '\n'
      << std::flush;
}

void print_verdict(std::ostream& out, const AccuracyRun& accuracy) {
  out << '\n'
      << (accuracy.met ? "accuracy: " : "accuracy NOT met: ") << accuracy.verdict << " ("
      << number(seconds(accuracy.rounds), "%.2g") << " s in all)\n";
  const AccuracyRound& last = accuracy.rounds.back();
  if (last.error) {
    out << "  " << accuracy.wanted.goal.name << ": " << number(last.value, "%.8g");
    if (last.value == last.of_mesh)
      out << " of the last mesh"
          << (last.of_estimate > 0 ? "; what is missing has no known sign\n" : "\n");
    else
      out << " = " << number(last.of_mesh, "%.8g") << " of the last mesh and "
          << number(last.value - last.of_mesh, "%.2g") << " that the estimate says is missing\n";
  }
  if (last.error && *last.error == last.saturation && last.saturation > 0)
    out << "  change: " << by_value(last.saturation, last.value)
        << " (used); what the value changed by from mesh to mesh and no estimate foresaw\n";
  if (last.error && *last.error == last.to_come && last.to_come > 0)
    out << "  to come: " << by_value(last.to_come, last.value)
        << " (used); if answers go on from mesh to mesh as the last two did\n";
  if (last.model_error > 0)
    out << "  model error: " << by_value(last.model_error, last.value)
        << "; between ellipses fitted to different parts of the pressure\n";
  for (const BudgetLine& line : accuracy.budget)
    out << "  " << line.source << ": "
        << (line.amount ? by_value(*line.amount, last.value) : "not estimated") << "; "
        << line.meaning << '\n';
  out << '\n';
}

void write(Json& json, const AccuracyRun& accuracy) {
  json.key("accuracy").object().key("goal").value(accuracy.wanted.goal.name);
  json.key("why").value(accuracy.why).key("target").value(accuracy.wanted.target);
  json.key("met").value(accuracy.met).key("verdict").value(accuracy.verdict);
  json.key("rounds").array();
  for (const AccuracyRound& round : accuracy.rounds) {
    json.object().key("unknowns").value(round.unknowns);
    if (round.error) {
      json.key("value")
          .value(round.value)
          .key("of_mesh")
          .value(round.of_mesh)
          .key("error")
          .value(*round.error);
      json.key("interior").value(round.parts.interior).key("gap").value(round.parts.gap);
      json.key("reading").value(round.parts.quadrature_error);
      json.key("free_boundary").value(round.parts.free_boundary);
      json.key("outline").value(round.parts.outline);
      json.key("saturation").value(round.saturation).key("to_come").value(round.to_come);
      json.key("model_error").value(round.model_error);
      json.key("algebraic").value(round.algebraic);
    }
    json.key("seconds").value(round.seconds).key("estimating").value(round.estimating).end();
  }
  json.end().key("budget").array();
  for (const BudgetLine& line : accuracy.budget) {
    json.object().key("source").value(line.source);
    if (line.amount) json.key("amount").value(*line.amount);
    json.key("meaning").value(line.meaning).end();
  }
  json.end().end();
}

}  // namespace command_line
