// The words of an expected error.
#pragma once
#include <stdexcept>
#include <string>

#include "signorini/core/errors.hpp"

namespace signorini_test {

/// What `action` says when it throws an `Error`; empty if it throws nothing. Other errors pass through.
template <typename Error, typename Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// The message about a problem that is posed wrongly.
template <typename Action>
std::string problem_message(Action&& action) {
  return message_of<signorini::ProblemError>(action);
}

/// The message about a caller's mistake.
template <typename Action>
std::string argument_message(Action&& action) {
  return message_of<std::invalid_argument>(action);
}

}  // namespace signorini_test
