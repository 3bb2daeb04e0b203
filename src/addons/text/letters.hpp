// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Which bytes of a text are letters, and which a terminal or another program would obey.
#pragma once
#include <cstddef>
#include <string_view>

namespace signorini {

/// \param text  any bytes
/// \param at    below its size
/// \return how many bytes the letter of UTF-8 beyond ASCII has that begins there; 0 if none does
[[nodiscard]] std::size_t length_of_letter(std::string_view text, std::size_t at);

/// Whether a text has control characters: ends of lines, tabs, those of terminals. A name with one would end a line of a
/// table or of a script.
/// \param text  any bytes, in UTF-8 if they are more than ASCII
/// \return whether one is below U+0020, or from U+007F to U+009F
[[nodiscard]] bool has_control_characters(std::string_view text);

}  // namespace signorini
