#include "signorini/scene_file/keys.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace signorini {
namespace {

using Eigen::Index;

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

template <typename Integer>
void take_whole(const Value& value, Integer& into, Bound bound) {
  constexpr double largest = 1e9;
  if (value.kind != Value::Kind::Number || !fits(value.number, bound) ||
      value.number != std::floor(value.number) || std::abs(value.number) > largest)
    wrong_type(value, with_bound("whole number", bound));
  into = static_cast<Integer>(value.number);
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all.empty() ? "none" : all;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 64;  // of a word that can be a misspelling
  std::size_t least = std::numeric_limits<std::size_t>::max();
  const std::string* nearest = nullptr;
  for (const std::string& name : known)
    if (const std::size_t apart = word.size() > longest ? least : edits(word, name);
        apart < least) {
      least = apart;
      nearest = &name;
    }
  const bool near = nearest != nullptr && 2 * least <= std::max(word.size(), nearest->size());
  return (near ? "; did you mean '" + *nearest + "'? There are: " : std::string("; there are: ")) +
         listed(known);
}

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

void take(const Value& value, double& into, Bound bound) {
  if (value.kind != Value::Kind::Number || !fits(value.number, bound))
    wrong_type(value, type_name(&into, bound));
  into = value.number;
}

void take(const Value& value, Index& into, Bound bound) { take_whole(value, into, bound); }

void take(const Value& value, int& into, Bound bound) { take_whole(value, into, bound); }

void take(const Value& value, bool& into, Bound /*bound*/) {
  if (value.kind != Value::Kind::Truth) value.fail("expected true or false, got ", value.shown());
  into = value.truth;
}

void take(const Value& value, std::string& into, Bound bound) {
  if (value.kind != Value::Kind::Text || value.text.empty())
    wrong_type(value, type_name(&into, bound));
  into = value.text;
}

void take(const Value& value, Eigen::Vector2d& into, Bound bound) {
  const std::vector<Value>& both = list_of(value, 2, with_bound("number", bound));
  for (int axis = 0; axis < 2; ++axis)
    take(both[static_cast<std::size_t>(axis)], into[axis], bound);
}

void take(const Value& value, Eigen::VectorXd& into, Bound bound) {
  if (value.kind != Value::Kind::List || value.items.empty())
    wrong_type(value, type_name(&into, bound));
  into.resize(static_cast<Index>(value.items.size()));
  Index k = 0;
  for (const Value& item : value.items) take(item, into[k++], bound);
}

void take(const Value& value, std::vector<Index>& into, Bound bound) {
  if (value.kind != Value::Kind::List || value.items.empty())
    wrong_type(value, with_bound("list of whole numbers", bound));
  into.clear();
  for (const Value& item : value.items) {
    into.push_back(0);
    take(item, into.back(), bound);
  }
}

std::string type_name(const double* /*value*/, Bound bound) { return with_bound("number", bound); }

std::string type_name(const Index* /*value*/, Bound bound) {
  return with_bound("whole number", bound);
}

std::string type_name(const int* /*value*/, Bound bound) {
  return with_bound("whole number", bound);
}

std::string type_name(const bool* /*value*/, Bound /*bound*/) { return "true or false"; }

std::string type_name(const std::string* /*value*/, Bound /*bound*/) { return "text"; }

std::string type_name(const Eigen::Vector2d* /*value*/, Bound bound) {
  return with_bound("[x, y]", bound);
}

std::string type_name(const Eigen::VectorXd* /*value*/, Bound bound) {
  return with_bound("list of numbers", bound);
}

std::string written(double value) { return text(value); }

std::string written(Index value) { return text(value); }

std::string written(int value) { return text(value); }

std::string written(bool value) { return value ? "true" : "false"; }

std::string written(const std::string& value) { return value.empty() ? value : '"' + value + '"'; }

std::string written(const Eigen::Vector2d& value) {
  return text("[", value.x(), ", ", value.y(), "]");
}

std::string written(const Eigen::VectorXd& value) {
  std::string list;
  for (const double number : value) list += (list.empty() ? "[" : ", ") + text(number);
  return list.empty() ? list : list + "]";
}

}  // namespace signorini
