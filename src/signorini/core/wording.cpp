// # What may have been meant
//
// A user who writes `frictoin` wants to be told `friction`. The distance of two words is the least
// number of letters that must be put in, taken out or changed. If \f$ d_{ij} \f$ is that of the
// first i letters of one and the first j of the other, then
// \f[ d_{ij} = \min\bigl(d_{i-1,j-1} + [a_i \ne b_j],\; d_{i-1,j} + 1,\; d_{i,j-1} + 1\bigr), \qquad d_{i0} = i,\; d_{0j} = j. \f]
// Two letters that changed places are two changes, so `frictoin` is 2 away from `friction`.

#include "signorini/core/wording.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace signorini {
namespace {

// How many letters must be put in, taken out or changed to make one word the other.
// The table of `gap` and `gasp` ends, at its lower right, with 1: put in an s.
//
//            g a s p
//          0 1 2 3 4
//        g 1 0 1 2 3
//        a 2 1 0 1 2
//        p 3 2 1 1 1
// Row i needs only row i - 1, so one row is kept and overwritten.
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

// What a message shows of a file may hold anything, and a terminal would obey some of it.
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

// A word is near another if at least half of the letters of the longer one stay. Without that rule
// every word would suggest something. A very long word is no misspelling, and the table of its
// distances would take long.
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
