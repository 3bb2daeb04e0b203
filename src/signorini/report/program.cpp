#include "signorini/report/program.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/report/results.hpp"

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

/// What the command line says.
struct Command {
  ProgramOptions options;
  bool help = false;
};

Command read(const std::filesystem::path& default_out, int argc, const char* const* argv) {
  Command command{{default_out, false}};
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--help" || word == "-h") {
      command.help = true;
    } else if (word == "--full") {
      command.options.full = true;
    } else if (word == "--out") {
      pose(++k < argc, "--out needs a folder: --out FOLDER");
      command.options.out = argv[k];
    } else {
      pose(false, "unknown option ", in_quotes(word),
           ". Known options: --out FOLDER, --full, --help");
    }
  }
  return command;
}

void print_help(const std::string& name, const std::string& title,
                const std::filesystem::path& default_out) {
  std::string usage = name;  // ch06_pressure is asked for as ch06 pressure
  std::replace(usage.begin(), usage.end(), '_', ' ');
  std::cout << title << "\nUsage: " << usage << " [--out FOLDER] [--full] [--help]\n\n"
            << "  --out FOLDER  for results, tables and figure data [" << default_out.string()
            << "]\n"
            << "  --full        also run the longer studies\n"
            << "  --help        this text\n";
}

}  // namespace

int run_program(const std::string& name, const std::string& title,
                const std::filesystem::path& default_out, int argc, const char* const* argv,
                const std::function<Status(const ProgramOptions&)>& body) {
  constexpr int solved = 0;
  constexpr int not_solved = 1;
  constexpr int bad_input = 2;
  try {
    const Command command = read(default_out, argc, argv);
    if (command.help) {
      print_help(name, title, default_out);
      finish_printing();
      return solved;
    }
    ProgramOptions options = command.options;
    const Staging staging(options.out);
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

int run_programs(const std::string& chapter, const std::vector<ChapterProgram>& programs, int argc,
                 char** argv) {
  std::vector<std::string> names;
  for (const ChapterProgram& program : programs) names.emplace_back(program.name);
  if (argc > 1 && argv[1][0] != '-') {
    const auto wanted = std::find(names.begin(), names.end(), argv[1]);
    if (wanted != names.end()) {
      argv[1] = argv[0];
      return programs[static_cast<std::size_t>(wanted - names.begin())].main(argc - 1, argv + 1);
    }
    std::cerr << chapter << ": no program " << in_quotes(argv[1]) << suggestion(argv[1], names)
              << '\n';
    return 2;
  }
  std::vector<char*> arguments(argv, argv + argc);
  const auto said = [&](const char* option) {
    const auto found = std::find(arguments.begin(), arguments.end(), std::string(option));
    return found == arguments.end() ? nullptr : &*found;
  };
  char** const quick = said("--quick");
  if (quick != nullptr) arguments.erase(arguments.begin() + (quick - arguments.data()));
  const bool help = said("--help") != nullptr;
  for (const ChapterProgram& program : programs) {
    if (quick != nullptr && program.takes_long) {
      std::cout << chapter << ' ' << program.name << " takes longer than 5 s and is left out\n";
      continue;
    }
    const int status = program.main(static_cast<int>(arguments.size()), arguments.data());
    if (status != 0 || help) {
      if (help && names.size() > 1)
        std::cout << "\nPrograms, one after the other or one alone, " << chapter
                  << " NAME: " << listed(names)
                  << "\n  --quick       without those that take longer than 5 s\n";
      return status;
    }
  }
  return 0;
}

}  // namespace signorini
