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
                              const std::function<SolveStatus(const ProgramOptions&)>& body);

/// One of the programs of a chapter.
struct ChapterProgram {
  const char* name;          ///< of its file
  int (*main)(int, char**);  ///< ends with run_program()
  /// Of one that takes more than 5 s: the files that it writes, with blanks between, of which committed ones can serve.
  const char* committed = "";
};

/// Runs the programs of a chapter: `ch06 [PROGRAM] [--quick] [--out FOLDER] [--full] [--help]`, in any order of the words.
/// Without a name, all run one after the other. With `--quick`, a program with committed files is left out, and a line
/// says `CHAPTER: NAME takes longer than 5 s and is left out: FILE FILE`, which `tools/chapter.sh` reads.
/// \param chapter   such as "ch06", for messages
/// \param programs  the one that the chapter is called after, then the others by name
/// \param argc      of main()
/// \param argv      of main()
/// \return exit code: that of the first program that does not end with 0, else 0. A program that fails leaves no file, those
///   before it keep theirs, those after it do not run. 2 with a message if there is no program or no option of a name, or if
///   what was printed could not be written
[[nodiscard]] int run_programs(const std::string& chapter,
                               const std::vector<ChapterProgram>& programs, int argc,
                               const char* const* argv);

}  // namespace signorini
