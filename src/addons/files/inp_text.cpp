#include "addons/files/inp_text.hpp"

#include <algorithm>
#include <cctype>

#include "addons/text/letters.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_comment(std::string_view line) { return line.substr(0, 2) == "**"; }

std::string_view unquoted(std::string_view word) {
  const bool quoted = word.size() > 1 && word.front() == '"' && word.back() == '"';
  return quoted ? word.substr(1, word.size() - 2) : word;
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  while (!line.empty()) {
    const std::size_t comma = std::min(line.find(','), line.size());
    fields.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(std::min(comma + 1, line.size()));
  }
  return fields;
}

}  // namespace

std::string inp_key(std::string_view name) {
  std::string key;
  for (const char c : unquoted(trimmed(name)))
    key += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return key;
}

bool InpText::next() {
  std::string_view line;
  do {
    if (!next_line()) return false;
    line = rest_of_line();
  } while (is_comment(line));
  keyword_.clear();
  if (line.front() != '*') {
    fields_ = split(line);
    return true;
  }
  std::string whole(line);
  while (whole.back() == ',' && next_line())
    if (const std::string_view more = rest_of_line(); !is_comment(more)) whole += more;
  parameters_.clear();
  for (const std::string_view field : split(whole)) {
    const std::size_t equal = std::min(field.find('='), field.size());
    if (field.data() == whole.data())
      keyword_ = inp_key(field.substr(1));
    else
      parameters_[inp_key(field.substr(0, equal))] =
          unquoted(trimmed(field.substr(std::min(equal + 1, field.size()))));
  }
  if (keyword_.empty() || has_control_characters(keyword_)) fail("a keyword behind '*'", line);
  return true;
}

const std::string& InpText::value(const char* parameter) const {
  const auto found = parameters_.find(parameter);
  if (found == parameters_.end() || found->second.empty())
    fail(text("*", keyword_, ": expected a parameter ", parameter, "=NAME"));
  if (has_control_characters(found->second))
    fail("a name without control characters", found->second);
  return found->second;
}

}  // namespace signorini
