#include "command_line/scene_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <iterator>
#include <utility>

#include "addons/files/inp.hpp"
#include "addons/steps/steps_limit.hpp"
#include "addons/text/text_reader.hpp"
#include "addons/vtu/vtu.hpp"
#include "command_line/overdue.hpp"
#include "command_line/picture.hpp"
#include "command_line/probe_print.hpp"
#include "command_line/run_monitor.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/ways.hpp"

namespace command_line {
namespace {

using namespace signorini;

/// The plan for build(). Large members that are not read any more are moved out of the other plan.
Plan taken_out(Plan& plan) {
  std::vector<BodyModel> bodies = std::exchange(plan.bodies, {});
  Unknowns unknowns = std::exchange(plan.unknowns, {});
  Plan taken = plan;
  taken.bodies = std::move(bodies);
  taken.unknowns = std::move(unknowns);
  return taken;
}

std::string late_words(const Stage& stage, const SceneRun& run) {
  return erase_line() + overdue_words(stage, run.plan, run.prediction);
}

/// Says, while a stage lasts, that it lasts far longer than forecast.
Overdue watch(const Stage& stage, const SceneRun& run) {
  return Overdue(overdue_after(stage, run.prediction), late_words(stage, run));
}

/// Goes along the load steps of a scene.
void follow(SceneRun& run, Ledger ledger, const StepObserver& observe, const Progress& progress) {
  Model& model = *run.model;
  try {
    check_state(run.from, model);
  } catch (const ProblemError& error) {
    throw ProblemError(text("--from: ", error.what()));
  }
  CondensedPath path = [&] {
    const Overdue overdue = watch(condensing(), run);
    return run.step([&] { return condense_path(model, ledger); });
  }();
  model.order.reset();  // that of the forecast: a run that goes on from a state has none either
  const std::vector<double>& times = model.path.times;
  const auto left = [&](double time) {
    return std::count_if(times.begin(), times.end(), [&](double t) { return t > time; });
  };
  const auto begin = std::chrono::steady_clock::now();
  const auto each = [&](const Model& at, const Step& step) {
    run.solution = step.solution;
    run.ledgers.push_back(step.solution.ledger);
    keep_probes(run, at, step);
    progress.say("");
    observe(at, step);
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin;
    const double steps = static_cast<double>(run.ledgers.size());
    const auto rest = left(step.state.time);
    progress.say(text("step ", step.state.steps, " at time ", step.state.time, ", ", rest,
                      " to go, about ",
                      number(gone.count() / steps * static_cast<double>(rest), "%.2g"), " s left"));
  };
  progress.say(text("step ", run.from.steps + 1, ", ", left(run.from.time), " to go"));
  // How many iterations a step of bodies that move takes is not known before.
  std::optional<Overdue> overdue;
  if (!model.loop)
    overdue.emplace(overdue_after(solving(), run.prediction), late_words(solving(), run));
  run.end = solve_steps(model, path, std::move(ledger), each, run.from);
  stand(run.end->state, model);
}

}  // namespace

std::string content_of(const std::string& file, std::size_t most) {
  if (file == "-") {
    std::string content{std::istreambuf_iterator<char>(std::cin), {}};
    require_input(!std::cin.bad(), standard_input, ": cannot be read");
    return content;
  }
  return file_content(file, most);
}

std::filesystem::path folder_of(const std::string& file) {
  return file == "-" ? std::filesystem::path(".") : std::filesystem::path(file).parent_path();
}

const char* command_for(const std::string& content) {
  TextReader reader(content, "");
  if (!reader.next_line()) return "";
  const std::string first(reader.word());
  if (is_inp(content) || first.front() == '$') return "mesh";
  if (first.find_first_not_of("0123456789") == std::string::npos)
    return first == "2" && reader.word_anywhere() != "0" ? "friction" : "lcp";
  if (first != "n" || reader.word() == "=") return "solve";
  return reader.next_line() && reader.word() == "m" ? "qp" : "lcp";
}

const char* taken_by(const std::string& command) {
  return command == "qp"         ? "quadratic programme"
         : command == "lcp"      ? "complementarity problem"
         : command == "friction" ? "friction problem"
         : command == "mesh"     ? "mesh"
                                 : "scene";
}

// Of places that move alike the first one is named: which of them is farther by rounding says nothing.
Farthest farthest(const NodeArray& displacements) {
  Farthest found;
  for (Eigen::Index node = 0; node < displacements.rows(); ++node)
    if (const double length = std::hypot(displacements(node, 0), displacements(node, 1));
        length > found.length * (1 + 4 * epsilon))
      found = {length, node};
  return found;
}

void add_notes(const std::vector<std::string>& some, std::vector<std::string>& notes) {
  notes.insert(notes.end(), some.begin(), some.end());
}

bool SceneRun::solved() const {
  if (end) return end->status == SolveStatus::Solved;
  return solution && solution->contact.report.status == SolveStatus::Solved;
}

const PathState* SceneRun::state() const { return end ? &end->state : nullptr; }

const std::vector<std::string>& SceneRun::notes() const {
  return solution ? solution->notes : model ? model->notes : plan.notes;
}

SceneRun plan_scene(const std::string& file, const Means& means, const char* command) {
  const std::string name = file == "-" ? standard_input : file;
  const Progress progress(text("reading ", name));
  const std::string content = content_of(file);
  if (means.team != nullptr) means.team->tell(content);
  SceneRun run;
  run.file = read_or_hint(name, content, command,
                          [&] { return parse_scene(content, name, folder_of(file)); });
  run.file.files.emplace_back(file);
  if (!means.solver.empty()) run.file.scene.solver = find_solver(means.solver);
  run.file.scene.backend = find_backend(means.backend);
  progress.say("planning");
  run.plan = at_file(run.file, [&] { return plan(run.file.scene); });
  add_notes(run.file.notes, run.plan.notes);
  run.prediction = run.step([&] { return predict(run.plan); });
  run.plan.order = run.prediction.order;
  return run;
}

void solve_scene(SceneRun& run, const StepObserver& observe) {
  const Progress progress;
  const auto figure = [&](const char* phase, const char* what) {
    return run.prediction.amount(phase, what);
  };
  const auto total = std::find_if(run.prediction.figures.begin(), run.prediction.figures.end(),
                                  [](const auto& one) { return one.phase == all_phases; });
  const std::string all =
      text(", ", to_string(total->certainty), ' ', number(total->amount, "%.2g"), " s in all");
  Ledger ledger = run.prediction.taken;
  progress.say(text("assembling ", figure("assembly", "unknowns"), " unknowns", all));
  {
    const Overdue overdue = watch(assembling(), run);
    run.model = run.step([&] { return build(taken_out(run.plan), ledger); });
  }
  progress.say(text("factoring, ", figure("factor/numeric", "operations"), " operations, and ",
                    figure("assembly", "rows"), " contact rows", all));
  if (run.file.scene.path) return follow(run, std::move(ledger), observe, progress);
  const Condensed condensed = [&] {
    const Overdue overdue = watch(condensing(), run);
    return run.step([&] { return condense_as_needed(*run.model, ledger); });
  }();
  progress.say(text("solving", all));
  const Overdue overdue = watch(solving(), run);
  run.solution =
      run.step([&] { return solve_to_limit(run.file.scene, *run.model, condensed, ledger); });
  run.ledgers = {run.solution->ledger};
}

std::vector<std::string> files_of(const Output& output) {
  std::vector<std::string> files;
  for (const std::string& file : {output.vtu, output.csv, output.plot, output.state, output.probes})
    if (!file.empty()) files.push_back(file);
  return files;
}

VtuNumbers numbers_of(const Output& output) {
  return output.ascii ? VtuNumbers::Ascii : VtuNumbers::Binary;
}

void write_outputs(const SceneRun& run, Drafts& drafts) {
  const Output& wanted = run.file.output;
  const Progress progress("writing files");
  const Uninterrupted whole;
  drafts.publish([&] {
    if (!wanted.vtu.empty())
      write_vtu(drafts.begin(wanted.vtu), *run.model, *run.solution, {}, numbers_of(wanted));
    if (!wanted.csv.empty())
      write_file(drafts.begin(wanted.csv), pressure_csv(*run.model, *run.solution));
    if (!wanted.probes.empty())
      write_file(drafts.begin(wanted.probes),
                 probes_csv(run.file.probes, *run.model, *run.solution, nullptr));
    if (!wanted.plot.empty()) draw(drafts.begin(wanted.plot), picture_kind(wanted.plot), run);
  });
  set_kept("all files were written");
}

}  // namespace command_line
