// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Words of people in messages: as they can be shown, and what may have been meant.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "signorini/core/errors.hpp"

namespace signorini {

/// \param text  any
/// \return the text, with `?` for every byte that is no printable ASCII
[[nodiscard]] std::string printable(std::string_view text);

/// \param text  any
/// \return at most 40 characters of it, printable()
[[nodiscard]] std::string clipped(std::string_view text);

/// \param text  any
/// \return the text in quotes, clipped()
[[nodiscard]] std::string in_quotes(std::string_view text);

/// \param x  a vector of two numbers \return them in brackets
template <typename Vector>
[[nodiscard]] std::string in_brackets(const Vector& x) {
  return text('(', x(0), ", ", x(1), ')');
}

/// \param words  any \param between  such as ", " \return them one after the other
[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view between);

/// \param names  some words \return them with commas, or "none"
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// Helps with a word that is none of those known. Near is one that begins with the word, or else one of which half of
/// the letters need no change.
/// \param word   that was found
/// \param known  that exist
/// \return "; did you mean 'WORD'? There are: ..." or, if none is near, "; there are: ..."
[[nodiscard]] std::string suggestion(const std::string& word,
                                     const std::vector<std::string>& known);

}  // namespace signorini
