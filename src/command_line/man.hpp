// The manual page, and messages about the command line, from the options as they are declared.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace command_line {

/// \param app      with all commands and options
/// \param version  of the program
/// \return the page in the language of man(7)
std::string man_page(const CLI::App& app, const std::string& version);

/// What is wrong with a command line, and what was expected.
/// \param app    that has parsed it
/// \param error  that it threw
/// \return one line
std::string message_of(const CLI::App& app, const CLI::ParseError& error);

}  // namespace command_line
