// The program `signorini`: solves problems from files with the solvers of the book.
// Run:  signorini lcp FILE | qp FILE [--solver NAME|all] [--tolerance T] [--json];  signorini --list | --keys
#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <string>

#include "command_line/outcome.hpp"
#include "command_line/print.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/scene_file/scene_file.hpp"

namespace {

using namespace signorini;

constexpr int solved = 0;
constexpr int not_solved = 1;
constexpr int bad_input = 2;

/// What the command line says.
struct Request {
  std::string file;
  std::string solver;
  double tolerance = 1e-12;
  bool json = false;
};

/// One document, with the problems that `problems` writes. \param kind  "lcp" or "qp"
template <typename Problems>
void write_document(const Request& request, const char* kind, Problems&& problems) {
  Json json;
  json.object().key("file").value(request.file).key("kind").value(kind);
  json.key("tolerance").value(request.tolerance).key("problems").array();
  problems(json);
  json.end().end();
  std::cout << json.text();
}

int solve_lcp(const Request& request) {
  const ProblemFile file = read_problem(request.file);
  const auto* const problems = std::get_if<std::vector<FiledProblem>>(&file);
  pose(problems != nullptr, request.file, ": this is a quadratic programme; run: signorini qp ",
       request.file);
  int code = solved;
  const auto each = [&](auto&& tell) {
    for (const FiledProblem& filed : *problems) {
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
    write_document(request, "lcp", [&](Json& json) {
      each([&](const auto& filed, auto kind, const auto& outcomes, bool good) {
        command_line::write(json, filed, kind, outcomes, good);
      });
    });
  } else {
    each([&](const auto& filed, auto kind, const auto& outcomes, bool /*good*/) {
      const bool first = &filed == problems->data();
      const std::string title =
          problems->size() == 1 ? request.file : text(request.file, ":", filed.line);
      std::cout << (first ? "" : "\n");
      command_line::print(std::cout, title, filed, kind, outcomes);
    });
  }
  return code;
}

int solve_qp(const Request& request) {
  const ProblemFile file = read_problem(request.file);
  const auto* const programme = std::get_if<TwoSidedProgramme>(&file);
  pose(programme != nullptr, request.file,
       ": this is a complementarity problem; run: signorini lcp ", request.file);
  std::vector<command_line::Outcome> outcomes;
  try {
    outcomes = command_line::solve_all(*programme, request.solver, request.tolerance);
  } catch (const ProblemError& error) {
    throw ProblemError(request.file + ": " + error.what());
  }
  const bool good = command_line::is_solved(outcomes, true);
  if (request.json)
    write_document(request, "qp",
                   [&](Json& json) { command_line::write(json, *programme, outcomes, good); });
  else
    command_line::print(std::cout, request.file, *programme, outcomes);
  return good ? solved : not_solved;
}

/// Refuses what is neither a solver nor `all` nor nothing.
void check_solver(const std::string& name) {
  if (name.empty() || name == "all") return;
  try {
    static_cast<void>(find_solver(name));
  } catch (const ProblemError& error) {
    throw ProblemError(text("--solver: ", error.what(), ", or all of them: all"));
  }
}

/// Declares FILE and the options of a command.
CLI::App* add_command(CLI::App& app, const char* name, const char* title, Request& request) {
  CLI::App* const command = app.add_subcommand(name, title);
  command->add_option("FILE", request.file, "the problem")->required();
  command->add_option("--solver", request.solver,
                      "a name of --list, or all; without it the first that takes the problem");
  command
      ->add_option("--tolerance", request.tolerance,
                   "largest figure of a certificate that is accepted")
      ->capture_default_str();
  command->add_flag("--json", request.json, "one JSON document instead of tables");
  return command;
}

int run(int argc, char** argv) {
  Request request;
  bool list = false;
  bool keys = false;
  CLI::App app("Solves complementarity problems and quadratic programmes, and certifies the result",
               "signorini");
  app.add_flag("--list", list, "the solvers, and on which problems each may fail");
  app.add_flag("--keys", keys, "the keys of scene files, in Markdown");
  app.require_subcommand(0, 1);
  CLI::App* const lcp = add_command(
      app, "lcp", "z >= 0, w = M z + q >= 0, z'w = 0; Siconos or block format", request);
  CLI::App* const qp =
      add_command(app, "qp", "least x'Px/2 + q'x + r with l <= Ax <= u; block format", request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& wanted) {
    if (wanted.get_exit_code() == 0) return app.exit(wanted);
    pose(lcp->parsed() || qp->parsed() || argv[1][0] == '-', "unknown command '", argv[1],
         "'; expected lcp FILE, qp FILE or --list. Try signorini --help");
    throw ProblemError(text(wanted.what(), ". Try signorini --help"));
  }
  if (list) {
    command_line::print_family(std::cout);
    return solved;
  }
  if (keys) {
    std::cout << key_reference();
    return solved;
  }
  pose(request.tolerance > 0 && std::isfinite(request.tolerance),
       "--tolerance: expected a number above 0, got ", request.tolerance);
  check_solver(request.solver);
  if (lcp->parsed()) return solve_lcp(request);
  if (qp->parsed()) return solve_qp(request);
  throw ProblemError("expected lcp FILE, qp FILE or --list. Try signorini --help");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int code = run(argc, argv);
    finish_printing();
    return code;
  } catch (const ProblemError& error) {
    std::cerr << "signorini: " << error.what() << '\n';
    return bad_input;
  } catch (const std::exception& error) {
    std::cerr << "signorini: stopped by an error of its own: " << error.what() << '\n';
    return not_solved;
  }
}
