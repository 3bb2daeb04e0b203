// The program `signorini`: solves problems from files with the solvers of the book.
// Run:  signorini plan|solve|mesh|lcp|friction|qp FILE [options];  signorini --list | --man | --version
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "addons/files/scene_file.hpp"
#include "command_line/accuracy_run.hpp"
#include "command_line/backends.hpp"
#include "command_line/man.hpp"
#include "command_line/mesh_run.hpp"
#include "command_line/options.hpp"
#include "command_line/outcome.hpp"
#include "command_line/path_run.hpp"
#include "command_line/picture.hpp"
#include "command_line/print.hpp"
#include "command_line/run_monitor.hpp"
#include "command_line/scene_print.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/parts.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using command_line::Request;

constexpr int solved = 0;
constexpr int not_solved = 1;
constexpr int bad_input = 2;

/// The command that takes what a file holds.
const char* command_of(const ProblemFile& file) {
  const auto* const problems = std::get_if<std::vector<FiledProblem>>(&file);
  return problems == nullptr ? "qp" : problems->front().has_friction() ? "friction" : "lcp";
}

/// The problem of the file, for one of the commands that take such files.
ProblemFile read(const Request& request, const std::string& command) {
  const command_line::Progress progress(text("reading ", request.name()));
  const std::string content = command_line::content_of(request.file);
  ProblemFile file = command_line::read_or_hint(request.name(), content, command.c_str(), [&] {
    return parse_problem(content, request.name());
  });
  const char* const wanted = command_of(file);
  require_input(command == wanted, request.name(), ": this is a ", command_line::taken_by(wanted),
                "; run: signorini ", wanted, " ", command_line::for_shell(request.file));
  return file;
}

/// One document, with the problems that `problems` writes. \param kind  "lcp", "friction" or "qp"
template <typename Problems>
void write_document(const Request& request, const char* kind, Problems&& problems) {
  Json json;
  command_line::begin_document(json, kind);
  json.key("file").value(request.name()).key("tolerance").value(request.tolerance);
  json.key("problems").array();
  problems(json);
  json.end().end();
  std::cout << json.text();
}

/// \param command  "lcp" or "friction"
int solve_pairs(const Request& request, const char* command) {
  const ProblemFile file = read(request, command);
  const auto& problems = std::get<std::vector<FiledProblem>>(file);
  int code = solved;
  const auto each = [&](auto&& tell) {
    for (const FiledProblem& filed : problems) {
      const command_line::Matrix kind = command_line::kind_of(filed.problem);
      const auto outcomes =
          command_line::solve_all(filed.problem, kind, request.solver, request.tolerance);
      const bool convex = kind == command_line::Matrix::PositiveDefinite ||
                          kind == command_line::Matrix::PositiveSemidefinite;
      const bool good = command_line::is_solved(outcomes, convex);
      if (!good) code = not_solved;
      tell(filed, kind, outcomes, good);
    }
  };
  if (request.json) {
    write_document(request, command, [&](Json& json) {
      each([&](const auto& filed, auto kind, const auto& outcomes, bool good) {
        command_line::write(json, filed, kind, outcomes, good);
      });
    });
  } else {
    each([&](const auto& filed, auto kind, const auto& outcomes, bool /*good*/) {
      const bool first = &filed == problems.data();
      const std::string title =
          problems.size() == 1 ? request.name() : text(request.name(), ":", filed.line);
      std::cout << (first ? "" : "\n");
      command_line::print(std::cout, title, filed, kind, outcomes);
    });
  }
  return code;
}

int solve_qp(const Request& request) {
  const ProblemFile file = read(request, "qp");
  const auto& programme = std::get<TwoSidedProgramme>(file);
  std::vector<command_line::Outcome> outcomes;
  try {
    outcomes = command_line::solve_all(programme, request.solver, request.tolerance);
  } catch (const ProblemError& error) {
    throw ProblemError(request.name() + ": " + error.what());
  }
  const bool good = command_line::is_solved(outcomes, true);
  if (request.json)
    write_document(request, "qp",
                   [&](Json& json) { command_line::write(json, programme, outcomes, good); });
  else
    command_line::print(std::cout, request.name(), programme, outcomes);
  return good ? solved : not_solved;
}

int tell(const Request& request, const command_line::SceneRun& run,
         void (*print)(std::ostream&, const command_line::SceneRun&)) {
  if (request.json) {
    Json json;
    command_line::write(json, run);
    std::cout << json.text();
  } else {
    print(std::cout, run);
  }
  return !run.solution || run.solved() ? solved : not_solved;
}

int plan_scene(const Request& request) {
  return tell(request, command_line::plan_scene(request.file, {request.solver}, "plan"),
              command_line::print_plan);
}

int tell_of_mesh(const Request& request) {
  const std::string& plot = request.output.plot;
  if (!plot.empty()) static_cast<void>(command_line::picture_kind(plot));
  const command_line::Progress progress("reading " + request.file);
  const command_line::MeshRun run = command_line::read_meshes(request.file);
  command_line::Drafts drafts(command_line::files_of(request.output), run.files);
  progress.say("");
  if (request.json) {
    Json json;
    command_line::write(json, run);
    std::cout << json.text();
  } else {
    command_line::print(std::cout, run);
  }
  if (!plot.empty()) {
    progress.say("drawing " + plot);
    drafts.publish(
        [&] { command_line::draw(drafts.begin(plot), command_line::picture_kind(plot), run); });
  }
  return command_line::usable(run) ? solved : not_solved;
}

/// Solves a scene with load steps; what is asked for is in run.
int solve_path(const Request& request, const Team* team, command_line::SceneRun& run) {
  command_line::PathFiles files(run);
  if (!request.from.empty()) files.go_on(run, request.from);
  command_line::PathTeller teller(std::cout, request.json, files.late());
  command_line::solve_scene(run, [&](const Model& model, const Step& step) {
    files.add(model, step);
    teller.tell(run, model, step);
  });
  if (run.solution) command_line::count_members(team, run.processes);
  teller.end(run);
  if (run.solution) files.finish(run);
  return run.solved() ? solved : not_solved;
}

/// Solves a scene to an accuracy, and says so before the rest.
int solve_accurately(const Request& request, const Team* team, command_line::SceneRun& run) {
  command_line::AccuracyRun accuracy = command_line::understood(request.accuracy, run);
  command_line::Drafts drafts(command_line::files_of(run.file.output), run.file.files);
  if (!request.json) command_line::print_wish(std::cout, accuracy);
  command_line::solve_to_accuracy(run, accuracy, [&](const command_line::AccuracyRun& so_far) {
    if (!request.json) command_line::print_round(std::cout, so_far);
  });
  command_line::count_members(team, run.solution->ledger);
  if (request.json) {
    Json json;
    command_line::begin_document(json, "accuracy");
    command_line::write(json, accuracy);
    command_line::write_keys(json, run);
    json.end();
    std::cout << json.text();
  } else {
    command_line::print_verdict(std::cout, accuracy);
    command_line::print_solution(std::cout, run);
  }
  if (run.solved()) command_line::write_outputs(run, drafts);
  return run.solved() && accuracy.met ? solved : not_solved;
}

/// \param team  of the back end; null if that works alone
int solve_scene(const Request& request, const Team* team) {
  command_line::SceneRun run =
      command_line::plan_scene(request.file, {request.solver, request.backend, team}, "solve");
  Output& output = run.file.output;
  if (!request.output.vtu.empty()) output.vtu = request.output.vtu;
  if (!request.output.csv.empty()) output.csv = request.output.csv;
  if (!request.output.plot.empty()) output.plot = request.output.plot;
  if (!request.output.state.empty()) output.state = request.output.state;
  output.ascii = output.ascii || request.output.ascii;
  if (!request.output.probes.empty()) output.probes = request.output.probes;
  require_input(output.probes.empty() || !run.file.probes.empty(), "--probes: ", run.file.name,
                " has no probe: leave it out, or give the scene a [[probe]]");
  if (!output.plot.empty()) static_cast<void>(command_line::picture_kind(output.plot));
  require_input(!request.accuracy.target.empty() || request.accuracy.goal.empty(),
                "--goal: say how accurate it is to be, as in --accuracy 0.5%");
  require_input(
      !request.accuracy.target.empty() || request.accuracy.unknowns.empty(),
      "--unknowns: says how far --accuracy may refine; give it one, as in --accuracy 0.5%");
  if (run.file.scene.path && request.accuracy.target.empty()) return solve_path(request, team, run);
  require_input(run.file.scene.path || (output.state.empty() && request.from.empty()),
                output.state.empty() ? "--from" : "--state", ": ", run.file.name,
                " has no load steps: leave it out, or give the scene [[steps]]");
  if (!request.accuracy.target.empty()) return solve_accurately(request, team, run);
  command_line::Drafts drafts(command_line::files_of(output), run.file.files);
  command_line::solve_scene(run);
  if (run.solution) command_line::count_members(team, run.solution->ledger);
  const int code = tell(request, run, command_line::print_solution);
  if (code == solved) command_line::write_outputs(run, drafts);
  return code;
}

/// Solves a scene on the processes that the back end works on. \param end  is set to what lets the others end
int solve_with_backend(const Request& request, std::function<void(int)>& end) {
  const Backend& backend = [&]() -> const Backend& {
    try {
      return find_backend(request.backend);
    } catch (const ProblemError& error) {
      throw ProblemError(text("--backend: ", error.what()));
    }
  }();
  if (backend.team == nullptr) {
    const int processes = command_line::launched().size;
    require_input(processes == 1, "--backend ", backend.name,
                  ": it works on one process, here are ", processes,
                  ", and each would solve the same and write the same files: start signorini ",
                  "without mpirun, or give --backend mumps");
    return solve_scene(request, nullptr);
  }
  const Team team = backend.team();
  if (team.rank > 0) return command_line::help(team, request.file);
  end = team.end;
  require_input(
      team.size == 1 || request.accuracy.target.empty(), "--accuracy: the ", team.size,
      " processes that --backend ", backend.name,
      " works on share the meshes of the scene file, and not finer ones: refine on one process, "
      "without mpirun, or leave the option out and solve a finer mesh");
  return solve_scene(request, &team);
}

/// Refuses what is neither a solver nor nothing, or `all` where that is asked of a whole family.
void check_solver(const std::string& name, bool family) {
  if (name.empty() || (family && name == "all")) return;
  try {
    static_cast<void>(find_solver(name));
  } catch (const ProblemError& error) {
    throw ProblemError(text("--solver: ", error.what(), family ? ", or all of them: all" : ""));
  }
}

double tolerance_of(const std::string& word) {
  const std::optional<double> value = command_line::positive(word);
  require_input(value.has_value(), "--tolerance: expected a number above 0, got '", word, '\'');
  return *value;
}

/// Threads of a process, as asked for. \param word  of the option, or empty
int threads_of(const std::string& word) {
  if (word.empty())
    return command_line::launched().size > 1
               ? 1
               : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  constexpr double most = 1024;
  const std::optional<double> value = command_line::positive(word);
  require_input(value && *value == std::floor(*value) && *value <= most,
                "--threads: expected a whole number from 1 to ", most, ", got '", word, '\'');
  return static_cast<int>(*value);
}

/// The options that ask for no command. \return whether one of them was given
bool answered(const CLI::App& app) {
  if (app.count("--list") > 0)
    command_line::print_family(std::cout);
  else if (app.count("--keys") > 0)
    std::cout << key_reference();
  else if (app.count("--man") > 0)
    std::cout << command_line::man_page(app, SIGNORINI_VERSION);
  else if (app.count("--version") > 0)
    std::cout << "signorini " << SIGNORINI_VERSION << '\n';
  else
    return false;
  return true;
}

/// \param end  is set if other processes wait for the exit code
int run(int argc, char** argv, std::function<void(int)>& end) {
  const char* const expected =
      "expected plan FILE, solve FILE, mesh FILE, lcp FILE, friction FILE, qp FILE, --list, "
      "--keys, --man or "
      "--version. Try signorini --help";
  Request request;
  CLI::App app(
      "Solves contact scenes, complementarity problems and quadratic programmes, and certifies "
      "the result",
      "signorini");
  command_line::declare(app, request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& wanted) {
    if (wanted.get_exit_code() == 0) return app.exit(wanted);
    if (app.get_subcommands().empty() && argv[1][0] != '-') {
      std::vector<std::string> known;
      for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        known.push_back(command->get_name());
      throw ProblemError(text("unknown command ", in_quotes(argv[1]), suggestion(argv[1], known),
                              ". Try signorini --help"));
    }
    throw ProblemError(command_line::message_of(app, wanted));
  }
  if (app.count("--list") > 0 || !command_line::has_backend(request.backend))
    command_line::become_whole(argv);
  if (answered(app)) return solved;
  require_input(!app.get_subcommands().empty(), expected);
  const std::string command = app.get_subcommands().front()->get_name();
  const bool scene = command == "plan" || command == "solve" || command == "mesh";
  request.tolerance = tolerance_of(request.tolerance_text);
  check_solver(request.solver, !scene);
  if (command == "plan") return plan_scene(request);
  if (command == "mesh") return tell_of_mesh(request);
  if (command == "solve") {
    set_threads(threads_of(request.threads));
    return solve_with_backend(request, end);
  }
  return command == "qp" ? solve_qp(request) : solve_pairs(request, command.c_str());
}

/// run() with what it throws said, as exit code.
int guarded_run(int argc, char** argv, std::function<void(int)>& end) {
  try {
    const int code = run(argc, argv, end);
    finish_printing();
    return code;
  } catch (const ProblemError& error) {
    // What is wrong with the input all processes find, and one says it.
    if (command_line::launched().rank == 0) std::cerr << "signorini: " << error.what() << '\n';
    return bad_input;
  } catch (const std::exception& error) {
    std::cerr << "signorini: stopped by an error of its own: " << error.what() << '\n';
    return not_solved;
  }
}

}  // namespace

int main(int argc, char** argv) {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 20);  // so that what a phase frees goes back to the system
#endif
  std::signal(SIGXFSZ, SIG_IGN);  // so that what is too long for the system fails like a full disk
  std::optional<command_line::RunMonitor> monitor;
  if (command_line::launched().rank == 0) monitor.emplace();  // of several processes one speaks
  std::function<void(int)> end;
  const int code = guarded_run(argc, argv, end);
  if (end) end(code);
  return code;
}
