#include "command_line/scene_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <system_error>

#include "command_line/picture.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/text_reader.hpp"
#include "signorini/problem_file/problem_file.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/vtu.hpp"

namespace command_line {
namespace {

using namespace signorini;

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

const std::string draft_mark = ".draft";

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
  return solution && solution->contact.report.status == Status::Solved;
}

const std::vector<std::string>& SceneRun::notes() const {
  return solution ? solution->notes : plan.notes;
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
  run.prediction = at_file(run.file, [&] { return predict(run.plan); });
  return run;
}

void solve_scene(SceneRun& run) {
  const Progress progress;
  const auto figure = [&](const char* phase, const char* what) {
    return run.prediction.amount(phase, what);
  };
  const std::string all = text("about ", figure("all phases", "seconds"), " s: ");
  Ledger ledger;
  progress.say(text(all, "assembling ", figure("assembly", "unknowns"), " unknowns"));
  run.model = at_file(run.file, [&] { return build(run.plan, ledger); });
  progress.say(text(all, "factoring, ", figure("factor/numeric", "operations"), " operations, and ",
                    figure("assembly", "rows"), " contact rows"));
  const Condensed condensed = at_file(run.file, [&] { return condense(*run.model, ledger); });
  progress.say(text(all, "solving"));
  run.solution = at_file(run.file, [&] { return solve(*run.model, condensed, ledger); });
}

Drafts::~Drafts() {
  std::error_code ignored;
  for (const auto& [draft, file] : files_) std::filesystem::remove(draft, ignored);
}

std::filesystem::path Drafts::add(const std::string& file) {
  pose(!std::filesystem::exists(file) || std::filesystem::is_regular_file(file), "cannot write '",
       file, "': this is no plain file");
  files_.emplace_back(file + draft_mark, file);
  return files_.back().first;
}

void Drafts::publish() {
  for (const auto& [draft, file] : files_) {
    std::error_code failed;
    std::filesystem::rename(draft, file, failed);
    pose(!failed, "cannot write '", file.string(), "' (", failed.message(), ')');
  }
}

void write_outputs(const SceneRun& run) {
  const Output& wanted = run.file.output;
  Drafts drafts;
  try {
    if (!wanted.vtu.empty()) write_vtu(drafts.add(wanted.vtu), *run.model, *run.solution);
    if (!wanted.csv.empty())
      write_file(drafts.add(wanted.csv), pressure_csv(run.model->pairs, *run.solution));
    if (!wanted.plot.empty()) draw(drafts.add(wanted.plot), picture_kind(wanted.plot), run);
  } catch (const ProblemError& error) {  // of a draft, which nobody has asked for by this name
    std::string message = error.what();
    const std::size_t at = message.find(draft_mark);
    throw ProblemError(at == std::string::npos ? message : message.erase(at, draft_mark.size()));
  }
  drafts.publish();
}

}  // namespace command_line
