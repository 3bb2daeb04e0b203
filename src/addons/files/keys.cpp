#include "addons/files/keys.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "addons/text/letters.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;

std::string with_bound(const std::string& type, Bound bound) {
  return type + (bound == Bound::Positive ? " > 0" : bound == Bound::NotNegative ? " >= 0" : "");
}

bool fits(double number, Bound bound) {
  return std::isfinite(number) &&
         (bound == Bound::Any || number > 0 || (bound == Bound::NotNegative && number == 0));
}

[[noreturn]] void wrong_type(const Value& value, const std::string& type) {
  value.fail("expected a ", type, ", got ", value.shown());
}

template <typename Number>
std::enable_if_t<std::is_arithmetic_v<Number>> read_as(const Value& value, Number& into,
                                                       Bound bound) {
  constexpr double largest = 1e9;  // whole number
  if (value.kind != Value::Kind::Number || !fits(value.number, bound) ||
      (std::is_integral_v<Number> && value.number != std::floor(value.number)))
    wrong_type(value, Plain<Number>::type_name(bound));
  if (std::is_integral_v<Number> && std::abs(value.number) > largest)
    value.fail("expected at most ", largest, ", got ", value.shown());
  into = static_cast<Number>(value.number);
}

void read_as(const Value& value, bool& into, Bound /*bound*/) {
  if (value.kind != Value::Kind::Truth) value.fail("expected true or false, got ", value.shown());
  into = value.truth;
}

void read_as(const Value& value, std::string& into, Bound /*bound*/) {
  if (value.kind != Value::Kind::Text || value.text.empty()) wrong_type(value, "text");
  if (has_control_characters(value.text))
    value.fail("expected a text of one line, got one with control characters, ",
               in_quotes(value.text), ": take out ends of lines, tabs and what begins with escape");
  into = value.text;
}

void read_as(const Value& value, Eigen::Vector2d& into, Bound bound) {
  const std::vector<Value>& both = list_of(value, 2, with_bound("number", bound));
  for (int axis = 0; axis < 2; ++axis) take(both[at(axis)], into[axis], bound);
}

/// Lists of numbers of any length but 0.
template <typename List>
std::enable_if_t<!std::is_arithmetic_v<List>> read_as(const Value& value, List& into, Bound bound) {
  if (value.kind != Value::Kind::List || value.items.empty())
    wrong_type(value, Plain<List>::type_name(bound));
  into.resize(static_cast<decltype(into.size())>(value.items.size()));
  auto number = into.begin();
  for (const Value& item : value.items) take(item, *number++, bound);
}

}  // namespace

void check_members(const Value& table, const std::vector<KeyInfo>& keys,
                   const std::function<std::string(const std::string&)>& elsewhere) {
  std::vector<std::string> known;
  for (const KeyInfo& key : keys) known.push_back(key.name);
  if (table.kind != Value::Kind::Table)
    table.fail("expected a table of ", listed(known), ", got ", table.shown());
  for (const Value& member : table.items) {
    if (std::find(known.begin(), known.end(), member.name) != known.end()) continue;
    const std::string other = elsewhere ? elsewhere(member.name) : std::string();
    if (!other.empty()) member.fail("has no meaning here, ", other, "; there are: ", listed(known));
    member.fail("unknown key", suggestion(member.name, known));
  }
  for (const KeyInfo& key : keys)
    if (key.required && table.find(key.name) == nullptr)
      table.fail("the key '", key.name, "' is missing: ", key.type, ", ", key.help);
}

const std::vector<Value>& list_of(const Value& value, std::size_t count, const std::string& what) {
  if (value.kind != Value::Kind::List || value.items.size() != count)
    value.fail("expected a list of ", count, ", each a ", what, ", got ", value.shown());
  return value.items;
}

template <typename M>
void Plain<M>::take(const Value& value, M& into, Bound bound) {
  read_as(value, into, bound);
}

template <typename M>
std::string Plain<M>::type_name(Bound bound) {
  if constexpr (std::is_same_v<M, bool>)
    return "true or false";
  else if constexpr (std::is_same_v<M, std::string>)
    return "text";
  else if constexpr (std::is_integral_v<M>)
    return with_bound("whole number", bound);
  else if constexpr (std::is_same_v<M, double>)
    return with_bound("number", bound);
  else if constexpr (std::is_same_v<M, Eigen::Vector2d>)
    return with_bound("[x, y]", bound);
  else
    return "list of " + with_bound("numbers", bound);
}

template <typename M>
std::string Plain<M>::written(const M& value) {
  if constexpr (std::is_same_v<M, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_same_v<M, std::string>) {
    return value.empty() ? value : '"' + value + '"';
  } else if constexpr (std::is_arithmetic_v<M>) {
    return text(value);
  } else {
    std::string list;
    for (const auto number : value) list += (list.empty() ? "[" : ", ") + text(number);
    return list.empty() ? list : list + "]";
  }
}

template struct Plain<double>;
template struct Plain<Index>;
template struct Plain<int>;
template struct Plain<bool>;
template struct Plain<std::string>;
template struct Plain<Eigen::Vector2d>;
template struct Plain<Eigen::VectorXd>;
template struct Plain<std::vector<Index>>;
template struct Plain<std::vector<double>>;

}  // namespace signorini
