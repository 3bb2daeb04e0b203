#include "addons/files/json.hpp"

#include <cmath>
#include <cstdio>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {
namespace {

/// How many bytes the letter of UTF-8 beyond ASCII has that begins at `at`; 0 if none does.
std::size_t length_of_letter(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0U;
  };
  const unsigned first = byte(0);
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (byte(k) < 0x80 || byte(k) > 0xbf) return 0;
  // What a shorter letter says, halves of pairs of UTF-16, and what lies beyond the last letter.
  const unsigned second = byte(1);
  const bool none = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                    (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return none ? 0 : length;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (const std::size_t length = length_of_letter(text, at); length > 0) {
      result.append(text, at, length);
      at += length - 1;
    } else if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c >= ' ' && c <= '~') {
      result += c;
    } else {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned char>(c));
      result += escape;
    }
  }
  return result + '"';
}

std::string literal(double value) { return std::isfinite(value) ? shortest(value) : "null"; }

}  // namespace

void Json::place() {
  if (!named_ && !open_.empty()) {
    out_ += first_ ? "\n" : ",\n";
    out_.append(2 * open_.size(), ' ');
  }
  first_ = false;
  named_ = false;
}

Json& Json::put(const std::string& literal) {
  place();
  out_ += literal;
  return *this;
}

Json& Json::object() {
  put("{");
  open_.push_back('}');
  first_ = true;
  return *this;
}

Json& Json::array() {
  put("[");
  open_.push_back(']');
  first_ = true;
  return *this;
}

Json& Json::end() {
  require_argument(!open_.empty(), "Json::end: nothing is open");
  const char bracket = open_.back();
  open_.pop_back();
  if (!first_) {
    out_ += '\n';
    out_.append(2 * open_.size(), ' ');
  }
  out_ += bracket;
  first_ = false;
  return *this;
}

Json& Json::key(const std::string& name) {
  put(quoted(name) + ": ");
  named_ = true;
  return *this;
}

Json& Json::value(const std::string& value) { return put(quoted(value)); }
Json& Json::value(double value) { return put(literal(value)); }
Json& Json::value(Eigen::Index value) { return put(std::to_string(value)); }
Json& Json::value(bool value) { return put(value ? "true" : "false"); }

Json& Json::value(const Eigen::VectorXd& values) {
  std::string list = "[";
  for (Eigen::Index i = 0; i < values.size(); ++i) list += (i > 0 ? ", " : "") + literal(values(i));
  return put(list + "]");
}

Json& Json::value(const std::vector<std::string>& values) {
  std::string list = "[";
  for (std::size_t i = 0; i < values.size(); ++i)
    list += (i > 0 ? ", " : "") + (values[i].empty() ? "null" : quoted(values[i]));
  return put(list + "]");
}

std::string Json::text() const {
  require_argument(open_.empty(), "Json::text: ", open_.size(), " levels are still open");
  return out_ + "\n";
}

}  // namespace signorini
