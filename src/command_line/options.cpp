#include "command_line/options.hpp"

#include "signorini/core/errors.hpp"

namespace command_line {
namespace {

/// Declares a command with FILE, --json and --solver.
CLI::App* add_command(CLI::App& app, const char* name, const char* title, const char* file,
                      const char* solver, Request& request) {
  CLI::App* const command = app.add_subcommand(name, title);
  command->add_option("FILE", request.file, file)->required();
  command->add_flag("--json", request.json, "one JSON document instead of tables");
  command->add_option("--solver", request.solver, solver)->type_name("NAME");
  return command;
}

/// Declares a command that takes a scene.
CLI::App* add_scene(CLI::App& app, const char* name, const char* title, Request& request) {
  return add_command(app, name, title, "the scene in TOML, or - for standard input",
                     "a name of --list, in the place of that of the scene", request);
}

/// Declares a command that takes a problem in numbers.
void add_problem(CLI::App& app, const char* name, const char* title, Request& request) {
  add_command(app, name, title, "the problem, or - for standard input",
              "a name of --list, or all; without it the first that takes the problem", request)
      ->add_option("--tolerance", request.tolerance_text,
                   "largest figure of a certificate that is accepted")
      ->type_name("NUMBER")
      ->capture_default_str();
}

/// What is wrong with the name of a file that is written; a script may give an empty one.
std::string no_file(const std::string& name) {
  return name == "-" || name.empty() ? "expected the name of a file, got '" + name + "'" : "";
}

void declare_mesh(CLI::App& app, Request& request) {
  CLI::App* const mesh = app.add_subcommand(
      "mesh", "what is in a mesh: bodies, cells, quality, and boundaries that a scene can name");
  mesh->add_option("FILE", request.file,
                   "a file of Gmsh, an input file of CalculiX or Abaqus, or a scene; or - for "
                   "standard input")
      ->required();
  mesh->add_flag("--json", request.json, "one JSON document instead of tables");
  mesh->add_option("--plot", request.output.plot,
                   "cells and boundaries, as a picture .svg, .png or .pdf, by gnuplot")
      ->type_name("FILE")
      ->check(no_file);
}

/// The files that a run may write.
void declare_files(CLI::App& solve, signorini::Output& output) {
  const auto add = [&](const char* option, std::string& into, const char* type, const char* what) {
    solve.add_option(option, into, what)->type_name(type)->check(no_file);
  };
  add("--vtu", output.vtu, "FILE",
      "meshes and fields, for ParaView, with pressure, traction and status of contact; of load "
      "steps a file each, and a .pvd of all");
  solve.add_flag("--ascii", output.ascii,
                 "numbers of VTU files as text, with 17 digits, in the place of their bytes");
  add("--csv", output.csv, "FILE",
      "a table of all pairs: place, gap, pressure, force, status; with friction shear, slip, "
      "motion and dissipated work; with several contacts their names; of load steps with a column "
      "time");
  add("--plot", output.plot, "FILE",
      "deformed meshes and the pressure of each contact, with friction also its shear, as a "
      "picture .svg, .png or .pdf, by gnuplot; of load steps the last");
  add("--probes", output.probes, "FILE",
      "a table of what each [[probe]] of the scene reads; of load steps with a column time");
  add("--state", output.state, "FILE", "where load steps are, kept up to date");
}

void declare_solve(CLI::App& app, Request& request) {
  CLI::App* const solve =
      add_scene(app, "solve", "solves a scene and certifies the result", request);
  const auto add = [&](const char* option, std::string& into, const char* type,
                       const std::string& what) {
    return solve->add_option(option, into, what)->type_name(type);
  };
  add("--backend", request.backend, "NAME",
      "a name of --list: who factors the stiffness matrix; mpirun -np N gives mumps N processes")
      ->capture_default_str();
  add("--threads", request.threads, "NUMBER",
      "how many threads assemble, factor and refine: with any, numbers are the same to the last "
      "bit; "
      "without it one for each core, and one in each process of mpirun");
  declare_files(*solve, request.output);
  add("--from", request.from, "FILE",
      "goes on from what --state wrote, to the same numbers; files keep the steps up to there, and "
      "are refused if they have others")
      ->check([](const std::string& name) { return name.empty() ? no_file(name) : ""; });
  add("--accuracy", request.accuracy.target, "PART",
      "refines the meshes until the estimated error of --goal is at most that part of its value, "
      "such as 0.5%, and two meshes agree; if that cannot be, says what stands in the way; price "
      "is the seconds so far by those of the first mesh");
  add("--goal", request.accuracy.goal, "GOAL",
      "what --accuracy is about: force (how large the resultant is), normal_force (the integral of "
      "the pressure), peak or width (both as of Hertz's contact) of a contact, with :CONTACT if "
      "there are several, or displacement:BODY.boundary.y; without it normal_force, or, if "
      "equilibrium alone says what that is, the displacement of the loaded boundary");
  add("--unknowns", request.accuracy.unknowns, "NUMBER",
      "how many of them --accuracy may spend on one mesh; without it " +
          signorini::text(signorini::Accuracy{}.most_unknowns) +
          ", and no mesh that takes more than 10 s by its forecast");
}

}  // namespace

void declare(CLI::App& app, Request& request) {
  app.footer(
      "0 if the problem is solved and everything is written; 1 if it is not solved, and then no "
      "file is written, but of load steps what was good before, or if --accuracy is not met, and "
      "then the files are those of the last mesh; 2 if the input is wrong, or what was found could "
      "not be printed or written. An interrupted run says what it has kept and ends by the signal, "
      "which shells call 130 (Ctrl-C) or 143.");
  app.add_flag("--list", "the solvers, on which problems each may fail, and the back ends");
  app.add_flag("--keys", "the keys of scene files, in Markdown");
  app.add_flag("--man", "this help as a manual page");
  app.add_flag("--version", "the version of the program");
  app.require_subcommand(0, 1);
  add_scene(app, "plan", "what a scene calls for and what it will cost, without solving it",
            request);
  declare_solve(app, request);
  declare_mesh(app, request);
  add_problem(app, "lcp", "z >= 0, w = M z + q >= 0, z'w = 0; Siconos or block format", request);
  add_problem(
      app, "friction",
      "w = W r + q with a normal and a tangential row for each pair, Coulomb's law; Siconos "
      "format",
      request);
  add_problem(app, "qp", "least x'Px/2 + q'x + r with l <= Ax <= u; block format", request);
}

}  // namespace command_line
