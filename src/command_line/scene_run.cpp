#include "command_line/scene_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <system_error>
#include <utility>

#include "command_line/picture.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/core/text_reader.hpp"
#include "signorini/problem_file/problem_file.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/vtu.hpp"
#include "signorini/scene/steps_limit.hpp"

namespace command_line {
namespace {

using namespace signorini;
namespace fs = std::filesystem;

/// One line on the error stream that says what is being done; none unless that is a terminal.
class Progress {
 public:
  Progress() = default;
  ~Progress() { say(""); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  void say(const std::string& what) const {
    if (shown_) std::cerr << "\r\033[K" << what << std::flush;
  }

 private:
  bool shown_ = isatty(STDERR_FILENO) == 1;
};

/// From the root, without detours.
fs::path whole(const fs::path& name) {
  std::error_code failed;
  const fs::path full = fs::absolute(name);
  fs::path found = fs::weakly_canonical(full, failed);
  return failed ? full.lexically_normal() : found;
}

void forget(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

/// Goes along the load steps of a scene.
void follow(SceneRun& run, Ledger ledger, const StepObserver& observe, const Progress& progress) {
  Model& model = *run.model;
  try {
    check_state(run.from, model);
  } catch (const ProblemError& error) {
    throw ProblemError(text("--from: ", error.what()));
  }
  CondensedPath path = run.step([&] { return condense_path(model, ledger); });
  const std::vector<double>& times = model.path.times;
  const auto left = [&](double time) {
    return std::count_if(times.begin(), times.end(), [&](double t) { return t > time; });
  };
  const auto begin = std::chrono::steady_clock::now();
  const auto each = [&](const Model& at, const Step& step) {
    run.solution = step.solution;
    run.ledgers.push_back(step.solution.ledger);
    progress.say("");
    observe(at, step);
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin;
    const double steps = static_cast<double>(run.ledgers.size());
    const auto rest = left(step.state.time);
    progress.say(text("step ", step.state.steps, " at time ", step.state.time, ", ",
                      step.solution.contact.report.iterations, " iterations, ", rest,
                      " to go, about ",
                      number(gone.count() / steps * static_cast<double>(rest), "%.2g"), " s left"));
  };
  progress.say(text("step ", run.from.steps + 1, ", ", left(run.from.time), " to go"));
  run.end = solve_steps(model, path, std::move(ledger), each, run.from);
  set_time(run.end->state.time, model);
}

}  // namespace

std::string content_of(const std::string& file) {
  if (file == "-") {
    std::string content{std::istreambuf_iterator<char>(std::cin), {}};
    pose(!std::cin.bad(), standard_input, ": cannot be read");
    return content;
  }
  return file_content(file, std::max(largest_scene_file, largest_problem_file));
}

const char* command_for(const std::string& content) {
  TextReader reader(content, "");
  if (!reader.next_line()) return "solve";
  const std::string first(reader.word());
  if (first.find_first_not_of("0123456789") == std::string::npos)
    return first == "2" && reader.word_anywhere() != "0" ? "friction" : "lcp";
  const std::string size(reader.word());
  if (first != "n" || size.empty() || size.find_first_not_of("0123456789") != std::string::npos)
    return "solve";
  return reader.next_line() && reader.word() == "m" ? "qp" : "lcp";
}

const char* taken_by(const std::string& command) {
  return command == "qp"         ? "quadratic programme"
         : command == "lcp"      ? "complementarity problem"
         : command == "friction" ? "friction problem"
                                 : "scene";
}

bool SceneRun::solved() const {
  if (end) return end->status == Status::Solved;
  return solution && solution->contact.report.status == Status::Solved;
}

const PathState* SceneRun::state() const { return end ? &end->state : nullptr; }

const std::vector<std::string>& SceneRun::notes() const {
  return solution ? solution->notes : model ? model->notes : plan.notes;
}

SceneRun plan_scene(const std::string& file, const std::string& solver, const char* command) {
  const bool piped = file == "-";
  const std::string name = piped ? standard_input : file;
  const std::string content = content_of(file);
  SceneRun run;
  run.file = read_or_hint(name, content, command, [&] {
    return parse_scene(
        content, name,
        piped ? std::filesystem::path(".") : std::filesystem::path(file).parent_path());
  });
  if (!solver.empty()) run.file.scene.solver = solver;
  run.plan = at_file(run.file, [&] { return plan(run.file.scene); });
  run.prediction = run.step([&] { return predict(run.plan); });
  return run;
}

void solve_scene(SceneRun& run, const StepObserver& observe) {
  const Progress progress;
  const auto figure = [&](const char* phase, const char* what) {
    return run.prediction.amount(phase, what);
  };
  const std::string all = text("about ", figure("all phases", "seconds"), " s: ");
  Ledger ledger;
  progress.say(text(all, "assembling ", figure("assembly", "unknowns"), " unknowns"));
  run.model = run.step([&] { return build(run.plan, ledger); });
  progress.say(text(all, "factoring, ", figure("factor/numeric", "operations"), " operations, and ",
                    figure("assembly", "rows"), " contact rows"));
  if (run.file.scene.path) return follow(run, std::move(ledger), observe, progress);
  const Condensed condensed = run.step([&] { return condense(*run.model, ledger); });
  progress.say(text(all, "solving"));
  run.solution = run.step([&] { return solve(*run.model, condensed, ledger); });
  follow_to_limit(run.file.scene, *run.solution);
  run.ledgers = {run.solution->ledger};
}

Drafts::Drafts(const std::vector<std::string>& files, const std::string& read) {
  for (const std::string& file : files) {
    std::error_code unseen;
    const fs::file_status status = fs::status(file, unseen);
    pose(!fs::exists(status) || fs::is_regular_file(status), "cannot write '", file,
         "': this is no plain file");
    const std::string ending = fs::path(file).extension().string();
    pose(ending != ".toml" && ending != ".msh" && ending != ".geo" && whole(file) != whole(read),
         "cannot write '", file, "': results do not replace scenes and meshes, take another name");
    for (const Entry& other : entries_)
      pose(whole(other.file) != whole(file), "cannot write '", file,
           "' twice: give every result a file of its own");
    entries_.push_back({file});
  }
}

Drafts::~Drafts() {
  for (const Entry& entry : entries_)
    if (!entry.draft.empty()) forget(entry.draft);
}

fs::path Drafts::unused(const fs::path& beside) const {
  const auto taken = [this](const fs::path& name) {
    std::error_code unseen;
    return fs::exists(fs::symlink_status(name, unseen)) ||
           std::any_of(entries_.begin(), entries_.end(),
                       [&](const Entry& entry) { return whole(entry.file) == whole(name); });
  };
  for (int number = 1;; ++number) {
    fs::path name = beside;
    name += text(".draft", number);
    if (!taken(name)) return name;
  }
}

fs::path Drafts::begin(const std::string& file) {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& one) { return one.file == file; });
  require(entry != entries_.end(), "Drafts: '", file, "' was not named before");
  return entry->draft = unused(entry->file);
}

std::string Drafts::in_words(std::string message) const {
  for (const Entry& entry : entries_)
    if (const std::size_t at = message.find(entry.draft.string());
        !entry.draft.empty() && at != std::string::npos)
      message.replace(at, entry.draft.string().size(), entry.file.string());
  return message;
}

void Drafts::take_back() {
  for (const Entry& entry : entries_) {
    std::error_code ignored;
    if (entry.published) fs::remove(entry.file, ignored);
    if (!entry.before.empty()) fs::rename(entry.before, entry.file, ignored);
  }
}

void Drafts::publish() {
  for (Entry& entry : entries_) {
    std::error_code unseen, failed;
    if (fs::is_regular_file(fs::status(entry.file, unseen))) {
      const fs::path before = unused(entry.file);
      fs::rename(entry.file, before, failed);
      if (!failed) entry.before = before;
    }
    if (!failed) fs::rename(entry.draft, entry.file, failed);
    entry.published = !failed;
    if (failed) take_back();
    pose(!failed, "cannot write '", entry.file.string(), "' (", failed.message(), ')');
  }
  for (const Entry& done : entries_)
    if (!done.before.empty()) forget(done.before);
}

std::vector<std::string> files_of(const Output& output) {
  std::vector<std::string> files;
  for (const std::string& file : {output.vtu, output.csv, output.plot, output.state})
    if (!file.empty()) files.push_back(file);
  return files;
}

void publish(Drafts& drafts, const std::function<void()>& write) {
  try {
    write();
  } catch (const ProblemError& error) {  // of a draft, which nobody has asked for by this name
    throw ProblemError(drafts.in_words(error.what()));
  }
  drafts.publish();
}

void write_outputs(const SceneRun& run, Drafts& drafts) {
  const Output& wanted = run.file.output;
  publish(drafts, [&] {
    if (!wanted.vtu.empty()) write_vtu(drafts.begin(wanted.vtu), *run.model, *run.solution);
    if (!wanted.csv.empty())
      write_file(drafts.begin(wanted.csv), pressure_csv(*run.model, *run.solution));
    if (!wanted.plot.empty()) draw(drafts.begin(wanted.plot), picture_kind(wanted.plot), run);
  });
}

}  // namespace command_line
