// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Notes in error messages: what a user should know is not lost when a scene is refused.
#pragma once
#include <string>
#include <vector>

#include "signorini/core/errors.hpp"

namespace signorini {

/// \param message  of an error
/// \param notes    that a user would not see for it
/// \return all of it in one line; what the message tells already is not told again
[[nodiscard]] std::string with_notes(const std::string& message,
                                     const std::vector<std::string>& notes);

/// \param message  from with_notes()
/// \return what it was before
[[nodiscard]] std::string without_notes(const std::string& message);

/// Does something so that its errors tell the notes as well.
/// \param notes   as they are when the error comes
/// \param action  to be done
/// \return what it returns
/// \throws ProblemError as the action, with the notes
template <typename Action>
auto with_context(const std::vector<std::string>& notes, Action&& action) {
  try {
    return action();
  } catch (const ProblemError& error) {
    throw ProblemError(with_notes(error.what(), notes));
  }
}

}  // namespace signorini
