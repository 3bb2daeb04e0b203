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
    for (const auto& entry : std::filesystem::directory_iterator(draft_))
      std::filesystem::rename(entry.path(), out_ / entry.path().filename());
  }

 private:
  std::filesystem::path out_;
  std::filesystem::path draft_;
};

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
    app.parse(argc, argv);
    const Staging staging(folder);
    options.out = staging.folder();
    const Status status = body(options);
    if (status == Status::Solved) {
      staging.publish();
      return solved;
    }
    std::cerr << name << ": not solved: " << to_string(status) << '\n';
    return not_solved;
  } catch (const CLI::ParseError& wanted) {
    if (wanted.get_exit_code() == 0) {
      std::cout << app.help();
      return solved;
    }
    std::cerr << name << ": " << wanted.what() << ". Known options: --out FOLDER, --full, --help\n";
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
