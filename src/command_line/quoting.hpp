// Texts between quotes of other programs.
#pragma once
#include <string>

namespace command_line {

/// \param word  any
/// \return it for a shell: as it is if it means nothing else there, or between quotes
std::string for_shell(const std::string& word);

/// \param text  any
/// \return an expression of gnuplot on one line that means this text, with all that is in it
std::string for_gnuplot(const std::string& text);

}  // namespace command_line
