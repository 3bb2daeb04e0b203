#include "signorini/core/wording.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace signorini {
namespace {

/// How many letters must be put in, taken out or changed to make one word the other.
std::size_t edits(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t changed = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// The same, but a word that is only begun is no more than one letter away.
std::size_t distance(const std::string& from, const std::string& to) {
  return !from.empty() && to.rfind(from, 0) == 0 ? 1 : edits(from, to);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result(text);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

std::string clipped(std::string_view text) {
  constexpr std::size_t longest = 40;
  return printable(text.substr(0, longest)) + (text.size() > longest ? "..." : "");
}

std::string in_quotes(std::string_view text) { return "'" + clipped(text) + "'"; }

std::string joined(const std::vector<std::string>& words, std::string_view between) {
  std::string all;
  for (std::size_t k = 0; k < words.size(); ++k)
    all.append(k == 0 ? "" : between).append(words[k]);
  return all;
}

std::string listed(const std::vector<std::string>& names) {
  return names.empty() ? "none" : joined(names, ", ");
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 64;  // of a word that can be a misspelling
  std::size_t least = std::numeric_limits<std::size_t>::max();
  const std::string* nearest = nullptr;
  for (const std::string& name : known)
    if (const std::size_t apart = word.size() > longest ? least : distance(word, name);
        apart < least) {
      least = apart;
      nearest = &name;
    }
  const bool near = nearest != nullptr && 2 * least <= std::max(word.size(), nearest->size());
  return (near ? "; did you mean '" + *nearest + "'? There are: " : std::string("; there are: ")) +
         listed(known);
}

}  // namespace signorini
