#include "signorini/report/program.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"

namespace signorini {
namespace {

/// A folder inside the output folder that takes what a program writes, until it is known to be complete.
class Staging {
 public:
  explicit Staging(std::filesystem::path out) : out_(std::move(out)), draft_(out_ / ".draft") {
    prepare_output_folder(out_);
    prepare_output_folder(draft_);
  }
  ~Staging() {
    std::error_code ignored;
    std::filesystem::remove_all(draft_, ignored);
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  Staging(Staging&&) = delete;
  Staging& operator=(Staging&&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return draft_; }
  void publish() const {
    for (const auto& entry : std::filesystem::directory_iterator(draft_)) {
      const std::filesystem::path file = out_ / entry.path().filename();
      std::error_code failed;
      std::filesystem::rename(entry.path(), file, failed);
      pose(!failed, "cannot write '", file.string(), "' (", failed.message(),
           "): remove what is there, or give another folder with --out FOLDER");
    }
  }

 private:
  std::filesystem::path out_;
  std::filesystem::path draft_;
};

/// Reads the command line. \return whether it asks for help
bool asks_for_help(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return false;
  } catch (const CLI::ParseError& wanted) {
    pose(wanted.get_exit_code() == 0, wanted.what(),
         ". Known options: --out FOLDER, --full, --help");
    return true;
  }
}

}  // namespace

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
    if (asks_for_help(app, argc, argv)) {
      std::cout << app.help();
      finish_printing();
      return solved;
    }
    const Staging staging(folder);
    options.out = staging.folder();
    const Status status = body(options);
    finish_printing();
    if (status == Status::Solved) {
      staging.publish();
      return solved;
    }
    std::cerr << name << ": not solved: " << to_string(status) << '\n';
    return not_solved;
  } catch (const NotSolved& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return not_solved;
  } catch (const ProblemError& error) {
    std::cerr << name << ": " << error.what() << '\n';
  } catch (const std::invalid_argument& error) {
    std::cerr << name << ": " << error.what() << '\n';
  } catch (const std::exception& error) {
    std::cerr << name << ": stopped by an error of its own: " << error.what() << '\n';
    return not_solved;
  }
  return bad_input;
}

}  // namespace signorini
