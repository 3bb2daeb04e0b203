#include "command_line/path_run.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "addons/text/text_reader.hpp"
#include "addons/vtu/vtu.hpp"
#include "command_line/picture.hpp"
#include "command_line/print.hpp"
#include "command_line/probe_print.hpp"
#include "command_line/run_monitor.hpp"
#include "command_line/scene_print.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/results.hpp"

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

/// The files that all steps have in common.
std::vector<std::string> files_of_all_steps(Output output) {
  if (!output.vtu.empty()) output.vtu = collection(output.vtu);
  return files_of(output);
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
  if (step != nullptr) sum = resultants(*model, step->solution, totals(&step->state));
  const bool frictional = !run.plan.law.pair.empty();
  add("step", "%.0f", [&] { return step->state.steps; });
  add("time", "%.5g", [&] { return step->state.time; });
  add("iterations", "%.0f", [&] { return step->solution.contact.report.iterations; });
  add("solves", "%.0f", [&] { return solves_of(step->solution.ledger); });
  if (run.plan.gaps.A.rows() > 0) {
    add("closed", "%.0f", [&] { return sum->closed; });
    if (frictional) add("stick", "%.0f", [&] { return sum->stick; });
    if (frictional) add("slide", "%.0f", [&] { return sum->slide; });
    if (run.model->bodies[0].material.base.state != PlaneState::Axial)
      add("force x", "%.5g", [&] { return sum->force.x(); });
    add("force y", "%.5g", [&] { return sum->force.y(); });
    if (frictional)
      add("dissipated_total", "%.5g", [&] { return sum->dissipated_total; });
  }
  add("certificate", "%.1e", [&] { return step->solution.certificate.worst(); });
  return all;
}

/// How wide a column is. \param column  of print_step()
int width_of(const Column& column) {
  return static_cast<int>(std::max<std::size_t>(13, std::strlen(column.name) + 2));
}

/// A note without its numbers, but for those in names between quotes.
std::string without_numbers(const std::string& note) {
  const char* const end = note.data() + note.size();
  const auto at = [&](std::size_t k) {
    return k < note.size() ? static_cast<unsigned char>(note[k]) : 0;
  };
  std::string kind;
  bool quoted = false;
  for (std::size_t k = 0; k < note.size(); ++k) {
    // No quote is what stands behind a word, as in "Mises' stress", or within one.
    const std::size_t beside = quoted ? k + 1 : k - 1;
    if (at(k) == '\'' && std::isalnum(at(beside)) == 0) quoted = !quoted;
    double skipped = 0;
    if (!quoted && std::isdigit(at(k)) != 0)
      k = static_cast<std::size_t>(std::from_chars(note.data() + k, end, skipped).ptr -
                                   note.data()) -
          1;
    else if (quoted || at(k) != '-')
      kind += note[k];
  }
  return kind;
}

/// What goes on from the state that is asked for. \param file  that is solved
std::string command_on(const std::string& file, const Output& output) {
  std::string command = "signorini solve " + (file == standard_input ? "-" : for_shell(file));
  const auto add = [&](const char* option, const std::string& word) {
    if (!word.empty()) command += option + for_shell(word);
  };
  add(" --from ", output.state);
  add(" --state ", output.state);
  add(" --vtu ", output.vtu);
  if (output.ascii) command += " --ascii";
  add(" --csv ", output.csv);
  add(" --probes ", output.probes);
  add(" --plot ", output.plot);
  return command;
}

/// How the command goes on after a path that ended too early.
std::string way_on(const SceneRun& run) {
  const PathState& state = run.end->state;
  if (state.steps == 0) return "";
  const Output& output = run.file.output;
  if (output.state.empty())
    return ". With --state FILE the next run can go on from there, by --from FILE";
  std::string values;
  for (const History& history : run.file.scene.path->histories)
    values += text(values.empty() ? ", where " : ", ", history.name, " = ",
                   shortest(history.at(state.time)));
  return text(". To go on from there: change what comes after time ", shortest(state.time), values,
              run.end->limit ? "" : ", or halvings", "; then: ", command_on(run.file.name, output));
}

/// What is left of a path that is interrupted after a step.
std::string kept(const std::string& file, const Output& output, const Step& step) {
  const std::string time = shortest(step.state.time);
  if (!output.state.empty())
    return text("the steps up to time ", time, " are kept; to go on: ", command_on(file, output));
  const char* const files = output.vtu.empty() && output.csv.empty() && output.probes.empty()
                                ? "nothing is kept of the steps up to time "
                                : "the files have the steps up to time ";
  return text(files, time, "; with --state FILE a run can go on from there, by --from FILE");
}

}  // namespace

PathFiles::PathFiles(const SceneRun& run)
    : name_(run.file.name),
      wanted_(run.file.output),
      probes_(run.file.probes),
      drafts_(files_of_all_steps(wanted_), run.file.files),
      table_(wanted_.csv),
      probe_table_(wanted_.probes) {}

void PathFiles::go_on(SceneRun& run, const std::string& file) {
  run.from = read_state(content_of(file), file);
  const double end = run.file.scene.path->times.back();
  require_input(run.from.time < end, file, ": this state is that of time ", run.from.time,
                ", but the load steps of ", run.file.name, " end at ", end,
                ": nothing is left to solve. Add [[steps]] to go on");
  const Index pairs = run.from.steps * static_cast<Index>(run.from.contact_status.size());
  std::optional<Index> rows;
  if (!run.file.scene.moves) rows = pairs;  // else they come and go
  if (table_.wanted() && !table_.keep(run.from, rows)) late_.push_back(wanted_.csv);
  if (probe_table_.wanted() && !probe_table_.keep(run.from, {})) late_.push_back(wanted_.probes);
  if (!wanted_.vtu.empty()) keep_fields(run.from, collection(wanted_.vtu));
}

void PathFiles::keep_fields(const PathState& from, const std::string& all) {
  const std::string content = content_if_any(all);
  if (content.empty()) return late_.push_back(all);
  fields_ = read_pvd(content);
  const auto later = [&](const TimedFile& file) { return file.time > from.time; };
  fields_.erase(std::remove_if(fields_.begin(), fields_.end(), later), fields_.end());
  bool right = static_cast<Index>(fields_.size()) == from.steps && fields_.back().time == from.time;
  for (std::size_t k = 0; right && k < fields_.size(); ++k)
    right = fields_[k].file ==
            fs::path(numbered(wanted_.vtu, static_cast<Index>(k) + 1)).filename().string();
  check_begun(right, all, from);
}

void PathFiles::add(const Model& model, const Step& step) {
  const Uninterrupted whole;
  // The rows come before the state: if all ends between the two, they are of a step that will be done again.
  if (table_.wanted())
    table_.add(step.state.time, pressure_csv(model, step.solution, "", totals(&step.state)));
  if (probe_table_.wanted())
    probe_table_.add(step.state.time, probes_csv(probes_, model, step.solution, &step.state));
  drafts_.publish([&] {
    if (!wanted_.vtu.empty()) {
      const std::string fields = numbered(wanted_.vtu, step.state.steps);
      fields_.push_back({step.state.time, fs::path(fields).filename().string()});
      write_vtu(drafts_.begin(fields), model, step.solution, totals(&step.state),
                numbers_of(wanted_));
      write_pvd(drafts_.begin(collection(wanted_.vtu)), fields_);
    }
    table_.begin(drafts_);
    probe_table_.begin(drafts_);
    if (wanted_.state.empty()) return;
    std::ostringstream state;
    write_state(step.state, state);
    write_file(drafts_.begin(wanted_.state), state.str());
  });
  set_kept(kept(name_, wanted_, step));
}

void PathFiles::finish(const SceneRun& run) {
  if (wanted_.plot.empty()) return;
  const Progress progress("drawing");
  const Uninterrupted whole;
  drafts_.publish([&] { draw(drafts_.begin(wanted_.plot), picture_kind(wanted_.plot), run); });
}

void PathTeller::begin(const SceneRun& run) {
  if (std::exchange(begun_, true)) return;
  if (as_json_) {
    begin_document(json_, "steps");
    write_head(json_, run);
    json_.key("steps").array();
    return;
  }
  print_head(out_, run);
  if (run.from.steps > 0)
    out_ << "\ngoes on from time " << shortest(run.from.time) << ", after " << run.from.steps
         << " steps\n";
  for (const std::string& file : late_files_)
    out_ << file << " is new: it begins with step " << run.from.steps + 1 << '\n';
  out_ << '\n';
  for (const Column& column : columns(run, nullptr, nullptr))
    out_ << std::setw(width_of(column)) << column.name;
  out_ << '\n';
}

void PathTeller::keep_notes(const Step& step) {
  const bool first = !std::exchange(noted_, true);
  const double now = step.state.time;
  for (const std::string& note : step.solution.notes) {
    const std::string kind = without_numbers(note);
    const auto known = std::find_if(notes_.begin(), notes_.end(),
                                    [&](const TimedNote& one) { return one.kind == kind; });
    if (known == notes_.end()) {
      notes_.push_back({kind, note, first, now, now, step.state.steps, 1});
    } else {
      known->note = note;
      known->last = now;
      ++known->steps;
      known->gone = known->gone || step.state.steps != known->last_step + 1;
      known->last_step = step.state.steps;
    }
  }
}

void PathTeller::print_notes() {
  bool any = false;
  for (const TimedNote& note : notes_) {
    if (note.in_head) continue;
    out_ << (std::exchange(any, true) ? "" : "\n") << "  note  "
         << (note.steps > 1 && !note.gone ? "from" : "at") << " time " << shortest(note.first);
    if (note.steps > 1)
      out_ << (note.gone ? text(" and in ", note.steps - 1, " of the steps until ") : " to ")
           << shortest(note.last);
    out_ << ": " << note.note << '\n';
  }
}

void PathTeller::tell(const SceneRun& run, const Model& model, const Step& step) {
  begin(run);
  if (as_json_) {
    json_.object().key("step").value(step.state.steps).key("time").value(step.state.time);
    if (!run.plan.law.pair.empty())
      json_.key("dissipated_total")
          .value(step.state.dissipation.sum() + step.state.dissipated_elsewhere.sum());
    write_result(json_, model, step.solution, run.file.probes, &step.state);
    json_.end();
    return;
  }
  keep_notes(step);
  for (const Column& column : columns(run, &model, &step))
    out_ << std::setw(width_of(column)) << number(column.value, column.format);
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
    if (!run.processes.entries().empty()) write_ledger(json_, "processes", run.processes);
    out_ << json_.end().text();
    return;
  }
  if (run.solved())
    out_ << "\nsolved: " << end.state.steps << " steps up to time " << end.state.time;
  else
    out_ << "\nnot solved: " << reason;
  if (end.halvings > 0) out_ << "\nsteps that failed and were halved: " << end.halvings;
  out_ << '\n';
  print_notes();
  if (!run.solution) return;
  out_ << "\nat time " << end.state.time << "\ncertificate: " << run.solution->certificate << '\n';
  print_result(out_, run);
  if (!run.processes.entries().empty()) out_ << '\n' << run.processes;
  out_ << '\n' << compare(run.prediction, run.ledgers);
}

}  // namespace command_line
