#include "command_line/options.hpp"

#include "signorini/core/errors.hpp"

namespace command_line {
namespace {

/// Declares a command with FILE and --json.
CLI::App* add_command(CLI::App& app, const char* name, const char* title, const char* file,
                      Request& request) {
  CLI::App* const command = app.add_subcommand(name, title);
  command->add_option("FILE", request.file, file)->required();
  command->add_flag("--json", request.json, "one JSON document instead of tables");
  return command;
}

/// Declares a command that takes a scene.
CLI::App* add_scene(CLI::App& app, const char* name, const char* title, Request& request) {
  CLI::App* const command =
      add_command(app, name, title, "the scene in TOML, or - for standard input", request);
  command
      ->add_option("--solver", request.solver,
                   "a name of --list, in the place of that of the scene")
      ->type_name("NAME");
  return command;
}

/// Declares a command that takes a problem in numbers.
CLI::App* add_problem(CLI::App& app, const char* name, const char* title, Request& request) {
  CLI::App* const command =
      add_command(app, name, title, "the problem, or - for standard input", request);
  command
      ->add_option("--solver", request.solver,
                   "a name of --list, or all; without it the first that takes the problem")
      ->type_name("NAME");
  command
      ->add_option("--tolerance", request.tolerance_text,
                   "largest figure of a certificate that is accepted")
      ->type_name("NUMBER")
      ->capture_default_str();
  return command;
}

}  // namespace

void declare(CLI::App& app, Request& request) {
  app.footer(
      "0 if the problem is solved and everything is written; 1 if it is not solved, and then no "
      "file is written, but of load steps what was good before, or if --accuracy is not met, and "
      "then the files are those of the last mesh; 2 if the input is wrong, or what was found could "
      "not be printed or written.");
  app.add_flag("--list", "the solvers, on which problems each may fail, and the back ends");
  app.add_flag("--keys", "the keys of scene files, in Markdown");
  app.add_flag("--man", "this help as a manual page");
  app.add_flag("--version", "the version of the program");
  app.require_subcommand(0, 1);
  add_scene(app, "plan", "what a scene calls for and what it will cost, without solving it",
            request);
  CLI::App* const solve =
      add_scene(app, "solve", "solves a scene and certifies the result", request);
  solve
      ->add_option("--backend", request.backend,
                   "a name of --list: who factors the stiffness matrix; mpirun -np N gives mumps N "
                   "processes")
      ->type_name("NAME")
      ->capture_default_str();
  const auto add_file = [&](const char* option, std::string& file, const char* what) {
    solve->add_option(option, file, what)->type_name("FILE");
  };
  add_file("--vtu", request.output.vtu,
           "meshes and fields, for ParaView, with pressure, traction and status of contact; of "
           "load steps a "
           "file each, and a .pvd of all");
  add_file("--csv", request.output.csv,
           "a table of all pairs: place, gap, pressure, force, status; with friction shear, slip, "
           "motion and "
           "dissipated work; with several contacts their names; of load steps with a column time");
  add_file("--plot", request.output.plot,
           "deformed meshes and the pressure of each contact, with friction also its shear, as a "
           "picture .svg or "
           ".png, by gnuplot; of load steps the last");
  add_file("--state", request.output.state, "where load steps are, kept up to date");
  add_file("--from", request.from,
           "goes on from what --state wrote, to the same numbers; files keep the steps up to "
           "there, and are refused if they have others");
  solve
      ->add_option(
          "--accuracy", request.accuracy.target,
          "refines the meshes until the estimated error of --goal is at most that part of its "
          "value, such as 0.5%, and two meshes agree; if that cannot be, says what stands in the "
          "way; "
          "price is the seconds so far by those of the first mesh")
      ->type_name("PART");
  solve
      ->add_option(
          "--goal", request.accuracy.goal,
          "what --accuracy is about: force (how large the resultant is), normal_force (the "
          "integral of the pressure), peak or width (both as of Hertz's "
          "contact) of a contact, with :CONTACT if "
          "there are several, or displacement:BODY.boundary.y; without it normal_force, "
          "or, if "
          "equilibrium alone says what that is, the displacement of the loaded boundary")
      ->type_name("GOAL");
  solve
      ->add_option("--unknowns", request.accuracy.unknowns,
                   signorini::text("how many of them --accuracy may spend on one mesh; without it ",
                                   signorini::Accuracy{}.most_unknowns,
                                   ", and no mesh that takes more than 10 s by its forecast"))
      ->type_name("NUMBER");
  add_problem(app, "lcp", "z >= 0, w = M z + q >= 0, z'w = 0; Siconos or block format", request);
  add_problem(
      app, "friction",
      "w = W r + q with a normal and a tangential row for each pair, Coulomb's law; Siconos "
      "format",
      request);
  add_problem(app, "qp", "least x'Px/2 + q'x + r with l <= Ax <= u; block format", request);
}

}  // namespace command_line
