#include "addons/files/json.hpp"

#include <cmath>
#include <cstdio>

#include "addons/text/letters.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {
namespace {

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
