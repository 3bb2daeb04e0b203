/// \file
/// The frame of every chapter program: options, output folder, messages and exit codes.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

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

}  // namespace signorini
