// # The frame of a chapter program
//
// A program of a chapter computes something and writes files. What all of them share stands here:
// the options, the folder, the message if something goes wrong, and the exit code.
//
// | code | meaning |
// |---:|:---|
// | 0 | solved, and all files are there |
// | 1 | a method did not arrive, or the program has an error of its own |
// | 2 | the command line, the folder or the problem is wrong |
//
// A program that fails half-way must not leave a new table beside an old figure. So the files of a
// run appear at its end.

#include "signorini/report/program.hpp"

#include <algorithm>
#include <exception>
#include <iostream>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/report/results.hpp"

namespace signorini {
namespace {

// A folder inside the output folder that takes what a program writes, until it is known to be complete.
//
// At the end the files are moved out. A move within one file system is a new name and copies
// nothing. If a file cannot be moved, because a folder of its name is in the way, the message says
// which.
//
// Whatever ends the run, the destructor removes the folder. So a run that fails, or is stopped by
// an exception, leaves the files of the run before it as they were.
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

  [[nodiscard]] const std::filesystem::path& folder() const { return draft_; }
  // Called only after everything was computed and printed.
  void publish() const {
    for (const auto& entry : std::filesystem::directory_iterator(draft_)) {
      const std::filesystem::path file = out_ / entry.path().filename();
      std::error_code failed;
      std::filesystem::rename(entry.path(), file, failed);
      require_input(!failed, "cannot write '", file.string(), "' (", failed.message(),
                    "): remove what is there, or give another folder with --out FOLDER");
    }
  }

 private:
  std::filesystem::path out_;
  std::filesystem::path draft_;
};

// What a command line says.
//
// The frame is used by two kinds of command lines. A single program has only options. A chapter of
// several programs also takes the name of one of them:
//
//     ch06 --out somewhere --full
//     ch06 pressure
//
// What is not understood ends the program before it computes anything:
//
//     ch06: unknown option '--fast'. Known options: --out FOLDER, --full, --help
struct Command {
  std::set<std::string> flags;
  std::string program;        ///< of a chapter, empty if none is named
  std::filesystem::path out;  ///< empty if it is not said
};

// \param flags     known options besides `--out FOLDER`
// \param programs  of a chapter, of which one may be named
// Words of a command line come in any order. A word that is unknown is answered with those that are
// known.
Command read(int argc, const char* const* argv, const std::vector<std::string>& flags,
             const std::vector<std::string>& programs) {
  const auto among = [](const std::string& word, const std::vector<std::string>& known) {
    return std::find(known.begin(), known.end(), word) != known.end();
  };
  Command command;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k] == std::string("-h") ? "--help" : argv[k];
    if (word == "--out") {
      ++k;
      require_input(k < argc && argv[k][0] != '-', "--out needs a folder: --out FOLDER");
      command.out = argv[k];
    } else if (word.rfind('-', 0) == 0 || programs.empty()) {
      require_input(among(word, flags), "unknown option ", in_quotes(word),
                    ". Known options: --out FOLDER, ", joined(flags, ", "));
      command.flags.insert(word);
    } else {
      require_input(among(word, programs), "no program ", in_quotes(word),
                    suggestion(word, programs));
      require_input(command.program.empty(),
                    "runs one program, or without a name all of them, got ",
                    in_quotes(command.program), " and ", in_quotes(word));
      command.program = word;
    }
  }
  return command;
}

// The help of a program says how it is called by a person: a program is compiled as ch06_pressure
// and asked for as `ch06 pressure`.
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

// The three codes have names, so that nobody has to remember them.
constexpr int well = 0;
constexpr int not_solved = 1;
constexpr int bad_input = 2;

// The exit code that `body` returns, or that belongs to what it throws, with one line on the error stream.
// Every error becomes one line and a number. The order of the handlers matters: NotSolved and
// ProblemError are exceptions of the standard library too, and would be caught by the last one.
// What the library throws is meant for a person: the message says what to change. What it does not
// know is an error of the program, and the line says so.
int exit_code(const std::string& name, const std::function<int()>& body) {
  try {
    return body();
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

// Calls a program of a chapter with what its own command line may say.
// A chapter with several programs calls the `main` of each as the shell would, with a command line
// made from its own.
int call(const ChapterProgram& program, const std::string& chapter, const Command& command) {
  std::vector<std::string> words = {chapter};
  if (!command.out.empty()) words.insert(words.end(), {"--out", command.out.string()});
  for (const char* flag : {"--full", "--help"})
    if (command.flags.count(flag) > 0) words.emplace_back(flag);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  return program.main(static_cast<int>(words.size()), argv.data());
}

}  // namespace

// The body runs with the hidden folder as its output folder. Its files become visible if it reports
// `Solved` and everything it printed has arrived.
// The body is the chapter. It knows nothing of options, folders and exit codes except what
// ProgramOptions tells it, so it can be called from a test as well.
int run_program(const std::string& name, const std::string& title,
                const std::filesystem::path& default_out, int argc, const char* const* argv,
                const std::function<SolveStatus(const ProgramOptions&)>& body) {
  return exit_code(name, [&] {
    const Command command = read(argc, argv, {"--full", "--help"}, {});
    if (command.flags.count("--help") > 0) {
      print_help(name, title, default_out);
      finish_printing();
      return well;
    }
    const Staging staging(command.out.empty() ? default_out : command.out);
    const SolveStatus status = body({staging.folder(), command.flags.count("--full") > 0});
    finish_printing();
    if (status != SolveStatus::Solved) {
      std::cerr << name << ": not solved: " << to_string(status) << '\n';
      return not_solved;
    }
    staging.publish();
    return well;
  });
}

// Programs run one after the other, and the first that fails ends the chapter. With `--quick` those
// that take long are left out, with a line that names the committed files which can serve in their
// place.
int run_programs(const std::string& chapter, const std::vector<ChapterProgram>& programs, int argc,
                 const char* const* argv) {
  return exit_code(chapter, [&] {
    std::vector<std::string> names;
    for (const ChapterProgram& program : programs) names.emplace_back(program.name);
    const Command command = read(argc, argv, {"--quick", "--full", "--help"}, names);
    const bool help = command.flags.count("--help") > 0;
    const bool quick = command.flags.count("--quick") > 0;
    for (const ChapterProgram& program : programs) {
      if (!command.program.empty() && command.program != program.name) continue;
      if (quick && !help && *program.committed != '\0') {
        std::cout << chapter << ": " << program.name
                  << " takes longer than 5 s and is left out: " << program.committed << '\n';
        continue;
      }
      const int status = call(program, chapter, command);
      if (status != well) return status;
      if (help) break;  // the options are the same for all
    }
    if (help && command.program.empty())
      std::cout << "\n"
                << chapter << " [PROGRAM] [--quick] and these options: runs " << listed(names)
                << " one after the other, or one of them\n"
                << "  --quick       without those that take longer than 5 s\n";
    finish_printing();
    return well;
  });
}

}  // namespace signorini
