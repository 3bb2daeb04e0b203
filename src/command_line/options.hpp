// The commands and options of the program, in one place.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "command_line/accuracy_run.hpp"
#include "command_line/scene_run.hpp"

namespace command_line {

/// What the command line says.
struct Request {
  std::string file;                      ///< its name, or `-`
  std::string solver;                    ///< a name, `all`, or empty
  std::string tolerance_text = "1e-12";  ///< as it was written
  double tolerance = 0;                  ///< as it was understood
  std::string backend = "frontal";       ///< name of the one that factors K
  std::string threads;                   ///< how many, or empty: one for each core
  signorini::Output output;  ///< files to write, in the place of those that a scene asks for
  AccuracyWish accuracy;     ///< of a scene that is to be refined
  std::string from;          ///< file of the state that load steps go on from, or empty
  bool json = false;         ///< one document instead of tables

  /// \return what messages call the file
  [[nodiscard]] std::string name() const { return file == "-" ? standard_input : file; }
};

/// Declares everything. Help, manual page and messages are made from it.
/// \param app      gets the commands and options
/// \param request  is filled when they are parsed
void declare(CLI::App& app, Request& request);

}  // namespace command_line
