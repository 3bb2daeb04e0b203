/// \file
/// The frame of every chapter program: options, output folder, messages and exit codes.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// What the command line of a chapter program says.
struct ProgramOptions {
  std::filesystem::path out;  ///< for results, tables and figure data; exists and can be written to
  bool full = false;          ///< also run the longer studies
};

/// Reads `[--out FOLDER] [--full] [--help]`, prepares the folder and runs `body`.
///
/// \param name         of the program, for messages
/// \param title        of the chapter, for the help text
/// \param default_out  folder used without `--out`
/// \param argc         of main()
/// \param argv         of main()
/// \param body         the chapter
/// \return exit code: 0 if body reports Solved, or after `--help`; 1 if it reports anything else or
///   throws NotSolved or another exception; 2 if the command line, the folder or the problem is wrong
///   (ProblemError, std::invalid_argument), or if what was printed could not be written. Unless it is
///   0, one line on the error stream says why and the folder keeps the files that it had
[[nodiscard]] int run_program(const std::string& name, const std::string& title,
                              const std::filesystem::path& default_out, int argc,
                              const char* const* argv,
                              const std::function<Status(const ProgramOptions&)>& body);

/// One of the programs of a chapter.
struct ChapterProgram {
  const char* name;          ///< of its file
  int (*main)(int, char**);  ///< ends with run_program()
  bool takes_long = false;   ///< more than 5 s
};

/// Runs the programs of a chapter one after the other, `ch06`, or the one that is named first, `ch06 pressure`; with `--quick`
/// those that take long are left out.
/// \param chapter   such as "ch06", for messages
/// \param programs  in the order of the text
/// \param argc      of main()
/// \param argv      of main(): perhaps a name, then options as of run_program()
/// \return exit code of the first program that does not end with 0, else 0; 2 with a message if there is none of the name
[[nodiscard]] int run_programs(const std::string& chapter,
                               const std::vector<ChapterProgram>& programs, int argc, char** argv);

}  // namespace signorini
