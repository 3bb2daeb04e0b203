/// \file
/// Another program, run as a user would, and what it took.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace signorini::bench {

/// What a program took from its start to its end.
struct ChildRun {
  double seconds = 0;  ///< processor time of all its threads and children [s]
  double megabytes =
      0;  ///< its largest memory [MB], and at least what this program had when it started it
  std::string failure;  ///< how it ended if not with 0, with the last it printed; or empty
};

/// Runs a program with one thread. What it prints goes to `log` in its folder.
/// \param command  its name, looked up as a shell does, and its arguments
/// \param folder   where it runs; exists
/// \param log      file for both of its output streams
/// \param longest  processor seconds after which it is ended
/// \return what it took
/// \throws ProblemError if no process can be started
[[nodiscard]] ChildRun run_child(const std::vector<std::string>& command,
                                 const std::filesystem::path& folder, const std::string& log,
                                 double longest);

/// \param program  looked up as a shell does \return whether it is installed
[[nodiscard]] bool is_program(const std::string& program);

/// All programs `python3` of the search path that can import a package: it may have come with any of them.
/// \param package  its name
/// \return full paths, in the order of the search path
[[nodiscard]] std::vector<std::string> pythons_with(const std::string& package);

}  // namespace signorini::bench
