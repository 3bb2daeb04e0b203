#include "command_line/path_run.hpp"

#include <algorithm>
#include <charconv>
#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>
#include <system_error>
#include <utility>

#include "command_line/picture.hpp"
#include "command_line/scene_print.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/pressure_table.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;
namespace fs = std::filesystem;

/// The collection of the files of all steps.
std::string collection(const std::string& vtu) {
  return fs::path(vtu).replace_extension(".pvd").string();
}

/// The file of one step.
std::string numbered(const std::string& vtu, Index step) {
  std::ostringstream name;
  name << fs::path(vtu).stem().string() << '_' << std::setw(4) << std::setfill('0') << step
       << ".vtu";
  return fs::path(vtu).replace_filename(name.str()).string();
}

/// The rows of a table with the time in front, and the names of its columns if they are not there yet.
void add_rows(const std::string& rows, double time, std::string& table) {
  const std::string at = shortest(time);
  bool named = false;
  std::istringstream lines(rows);
  for (std::string line; std::getline(lines, line);) {
    if (line.front() == '#') {
      table += text("# time ", at, ": ", line.substr(2), '\n');
    } else if (named) {
      table += text(at, ',', line, '\n');
    } else {
      named = true;
      if (table.find("\ntime,") == std::string::npos) table += "time," + line + '\n';
    }
  }
}

/// The rows of such a table up to a time.
std::string rows_until(double time, const std::string& table) {
  std::string rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    const std::string comment = "# time ";
    const std::size_t begin = line.rfind(comment, 0) == 0 ? comment.size() : 0;
    double at = 0;
    const auto read = std::from_chars(line.data() + begin, line.data() + line.size(), at);
    if (read.ec == std::errc() && at > time) break;
    rows += line + '\n';
  }
  return rows;
}

/// What a file holds, nothing if there is none.
std::string content_if_any(const std::string& file) {
  std::error_code unseen;
  return fs::is_regular_file(file, unseen) ? content_of(file) : "";
}

Index solves_of(const Ledger& ledger) {
  long long sum = 0;
  for (const LedgerEntry& entry : ledger.entries())
    if (const auto solves = entry.counts.find("solves"); solves != entry.counts.end())
      sum += solves->second;
  return static_cast<Index>(sum);
}

/// One column of print_step().
struct Column {
  const char* name;
  double value;
  const char* format;
};

/// The columns of a step; those of friction and of forces along x only if they mean something.
std::vector<Column> columns(const SceneRun& run, const Model* model, const Step* step) {
  std::vector<Column> all;
  const auto add = [&](const char* name, const char* format, auto value) {
    all.push_back({name, step == nullptr ? 0.0 : static_cast<double>(value()), format});
  };
  std::optional<Resultants> sum;
  if (step != nullptr) sum = resultants(model->pairs, step->solution, &step->state);
  const bool rubs = !run.plan.law.pair.empty();
  add("step", "%.0f", [&] { return step->state.steps; });
  add("time", "%.5g", [&] { return step->state.time; });
  add("iterations", "%.0f", [&] { return step->solution.contact.report.iterations; });
  add("solves", "%.0f", [&] { return solves_of(step->solution.ledger); });
  if (run.plan.gaps.A.rows() > 0) {
    add("closed", "%.0f", [&] { return sum->closed; });
    if (rubs) add("stick", "%.0f", [&] { return sum->stick; });
    if (rubs) add("slide", "%.0f", [&] { return sum->slide; });
    if (run.plan.bodies[0].material.bulk.state != PlaneState::Axial)
      add("force x", "%.5g", [&] { return sum->force.x(); });
    add("force y", "%.5g", [&] { return sum->force.y(); });
    if (rubs) add("dissipated", "%.5g", [&] { return sum->dissipated_total; });
  }
  add("certificate", "%.1e", [&] { return step->solution.certificate.worst(); });
  return all;
}

/// How the command goes on after a path that ended too early.
std::string way_on(const SceneRun& run) {
  const std::string& state = run.file.output.state;
  if (run.end->state.steps == 0) return "";
  return state.empty()
             ? ". With --state FILE the next run can go on from there, by --from FILE"
             : ". To go on from there: signorini solve " + run.file.name + " --from " + state;
}

}  // namespace

void go_on(SceneRun& run, const std::string& file) {
  run.from = read_state(content_of(file), file);
  const double end = run.file.scene.path->times.back();
  pose(run.from.time < end, file, ": this state is that of time ", run.from.time,
       ", but the load steps of ", run.file.name, " end at ", end,
       ": nothing is left to solve. Add [[steps]] to go on");
}

PathFiles::PathFiles(const SceneRun& run, std::string read)
    : wanted_(run.file.output), read_(std::move(read)) {
  Output all = wanted_;
  if (!all.vtu.empty()) all.vtu = collection(all.vtu);
  static_cast<void>(Drafts(files_of(all), read_));
  if (run.from.steps == 0) return;
  if (!all.csv.empty()) table_ = rows_until(run.from.time, content_if_any(all.csv));
  if (!all.vtu.empty()) fields_ = read_pvd(content_if_any(all.vtu));
  const auto later = [&](const TimedFile& file) { return file.time > run.from.time; };
  fields_.erase(std::remove_if(fields_.begin(), fields_.end(), later), fields_.end());
}

void PathFiles::add(const Model& model, const Step& step) {
  if (!wanted_.csv.empty())
    add_rows(pressure_csv(model, step.solution, "", &step.state), step.state.time, table_);
  std::vector<std::string> files;
  std::string fields, all;
  if (!wanted_.vtu.empty()) {
    fields = numbered(wanted_.vtu, step.state.steps);
    all = collection(wanted_.vtu);
    files = {fields, all};
    fields_.push_back({step.state.time, fs::path(fields).filename().string()});
  }
  if (!wanted_.state.empty()) files.push_back(wanted_.state);
  Drafts drafts(files, read_);
  publish(drafts, [&] {
    if (!wanted_.vtu.empty()) {
      write_vtu(drafts.begin(fields), model, step.solution, &step.state);
      write_pvd(drafts.begin(all), fields_);
    }
    if (wanted_.state.empty()) return;
    std::ostringstream state;
    write_state(step.state, state);
    write_file(drafts.begin(wanted_.state), state.str());
  });
}

void PathFiles::finish(const SceneRun& run) const {
  Drafts drafts(files_of({{}, wanted_.csv, wanted_.plot, {}}), read_);
  publish(drafts, [&] {
    if (!wanted_.csv.empty()) write_file(drafts.begin(wanted_.csv), table_);
    if (!wanted_.plot.empty()) draw(drafts.begin(wanted_.plot), picture_kind(wanted_.plot), run);
  });
}

void PathTeller::begin(const SceneRun& run) {
  if (std::exchange(begun_, true)) return;
  if (as_json_) {
    write_head(json_.object(), run);
    json_.key("steps").array();
    return;
  }
  print_head(out_, run);
  if (run.from.steps > 0)
    out_ << "\ngoes on from time " << run.from.time << ", after " << run.from.steps << " steps\n";
  out_ << '\n';
  for (const Column& column : columns(run, nullptr, nullptr)) out_ << std::setw(13) << column.name;
  out_ << '\n';
}

void PathTeller::keep_notes(const Step& step) {
  const bool first = !std::exchange(noted_, true);
  for (const std::string& note : step.solution.notes) {
    // Notes that differ in a number only are one.
    const std::string kind = note.substr(0, note.find_first_of("0123456789"));
    if (!told_.insert(kind).second || first) continue;  // the head has those of the first step
    late_notes_ += text("  note  from time ", step.state.time, " on: ", note, '\n');
  }
}

void PathTeller::tell(const SceneRun& run, const Model& model, const Step& step) {
  begin(run);
  if (as_json_) {
    json_.object().key("step").value(step.state.steps).key("time").value(step.state.time);
    if (!run.plan.law.pair.empty()) json_.key("dissipated").value(step.state.dissipation.sum());
    write_result(json_, run.plan.solver, model, step.solution, &step.state);
    json_.end();
    return;
  }
  keep_notes(step);
  for (const Column& column : columns(run, &model, &step))
    out_ << std::setw(13) << number(column.value, column.format);
  out_ << std::endl;  // now: the next step may take long
}

void PathTeller::end(const SceneRun& run) {
  begin(run);
  const PathEnd& end = *run.end;
  const std::string reason = run.solved() ? "" : end.reason + way_on(run);
  if (as_json_) {
    json_.end().key("solved").value(run.solved()).key("status").value(to_string(end.status));
    json_.key("reason").value(reason).key("time").value(end.state.time);
    json_.key("halvings").value(end.halvings);
    if (end.limit) json_.key("limit").value(*end.limit);
    out_ << json_.end().text();
    return;
  }
  if (run.solved())
    out_ << "\nsolved: " << end.state.steps << " steps up to time " << end.state.time;
  else
    out_ << "\nnot solved: " << reason;
  if (end.halvings > 0) out_ << "\nsteps that failed and were halved: " << end.halvings;
  out_ << '\n' << (late_notes_.empty() ? "" : "\n") << late_notes_;
  if (!run.solution) return;
  out_ << "\nat time " << end.state.time << "\ncertificate: " << run.solution->certificate << '\n';
  print_result(out_, run);
  out_ << '\n' << confront(run.prediction, run.ledgers);
}

}  // namespace command_line
