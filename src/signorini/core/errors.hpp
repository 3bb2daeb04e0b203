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
/// is no error: it is reported by its Status.
class ProblemError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A method ended without a solution, and the program cannot go on. Programs end with exit code 1.
class NotSolved : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The streamed parts as one string, numbers with 6 digits.
template <typename... Parts>
[[nodiscard]] std::string text(const Parts&... parts) {
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

/// Throws std::invalid_argument with the streamed parts unless `ok`: the caller's mistake.
template <typename... Parts>
void require(bool ok, const Parts&... parts) {
  if (!ok) throw std::invalid_argument(text(parts...));
}

/// Throws ProblemError with the streamed parts unless `ok`: the problem is posed wrongly.
template <typename... Parts>
void pose(bool ok, const Parts&... parts) {
  if (!ok) throw ProblemError(text(parts...));
}

}  // namespace signorini
