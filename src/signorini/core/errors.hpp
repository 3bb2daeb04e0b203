/// \file
/// Argument checks and the errors that the library throws.
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>

namespace signorini {

/// The problem as posed is wrong or has no unique solution; the message says what to change.
///
/// Thrown for input that a user of a finished program can get wrong (a free body, an inverted cell,
/// a folder that cannot be written). Programs end with exit code 2. A method that does not converge
/// is no error of this kind: it is reported by its SolveStatus.
class ProblemError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A method ended without a solution, and the program cannot go on. Programs end with exit code 1.
class NotSolved : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One string from many parts.
/// \param parts  anything that can be streamed
/// \return the parts one after the other, numbers with 6 digits
template <typename... Parts>
[[nodiscard]] std::string text(const Parts&... parts) {
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

/// Checks an argument, which the caller must get right.
/// \param ok     what must hold
/// \param parts  of the message: the function, what it expects, what it got
/// \throws std::invalid_argument with the parts as text() unless `ok`
template <typename... Parts>
void require_argument(bool ok, const Parts&... parts) {
  if (!ok) throw std::invalid_argument(text(parts...));
}

/// Checks input, which the user of a program must get right.
/// \param ok     what must hold
/// \param parts  of the message: what is wrong, what was found, what to change
/// \throws ProblemError with the parts as text() unless `ok`
template <typename... Parts>
void require_input(bool ok, const Parts&... parts) {
  if (!ok) throw ProblemError(text(parts...));
}

}  // namespace signorini
