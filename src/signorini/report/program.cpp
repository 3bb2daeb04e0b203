#include "signorini/report/program.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"

namespace signorini {

int run_program(const std::string& name, const std::string& title,
                const std::filesystem::path& default_out, int argc, const char* const* argv,
                const std::function<Status(const ProgramOptions&)>& body) {
  constexpr int solved = 0;
  constexpr int not_solved = 1;
  constexpr int bad_input = 2;
  std::string folder = default_out.string();
  ProgramOptions options;
  CLI::App app(title, name);
  app.add_option("--out", folder, "folder for results, tables and figure data")
      ->capture_default_str();
  app.add_flag("--full", options.full, "also run the longer studies");
  try {
    app.parse(argc, argv);
    options.out = folder;
    prepare_output_folder(options.out);
    const Status status = body(options);
    if (status == Status::Solved) return solved;
    std::cerr << name << ": not solved: " << to_string(status) << '\n';
    return not_solved;
  } catch (const CLI::ParseError& wanted) {
    if (wanted.get_exit_code() == 0) {
      std::cout << app.help();
      return solved;
    }
    std::cerr << name << ": " << wanted.what() << " Known options: --out FOLDER, --full, --help\n";
  } catch (const NotSolved& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return not_solved;
  } catch (const ProblemError& error) {
    std::cerr << name << ": " << error.what() << '\n';
  } catch (const std::invalid_argument& error) {
    std::cerr << name << ": " << error.what() << '\n';
  }
  return bad_input;
}

}  // namespace signorini
