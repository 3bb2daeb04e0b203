#include "signorini/scene_file/toml_value.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <utility>

namespace signorini {
namespace {

/// A word short enough for a message, without characters that are not printed.
std::string clipped(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string result(word.substr(0, longest));
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return result + (word.size() > longest ? "..." : "");
}

/// Where something stands: tables and lists begin with their first key, of which they know the line.
std::size_t line_of(const toml::source_region& source, std::size_t otherwise) {
  return source.begin ? static_cast<std::size_t>(source.begin.line) : otherwise;
}

Value converted(const toml::node& node, Value into);

void convert_list(const toml::array& list, Value& into) {
  into.kind = Value::Kind::List;
  into.items.reserve(list.size());
  for (const toml::node& item : list)
    into.items.push_back(
        converted(item, {{}, {}, into.path, line_of(item.source(), into.line), into.origin}));
}

void convert_table(const toml::table& table, Value& into) {
  using Position = std::pair<std::size_t, std::size_t>;
  std::vector<std::pair<Position, Value>> members;
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    const std::size_t line = line_of(key.source(), line_of(node.source(), into.line));
    const std::size_t column = static_cast<std::size_t>(key.source().begin.column);
    Value member{
        {}, name, into.path + (into.path.empty() ? "" : ".") + clipped(name), line, into.origin};
    members.emplace_back(Position(line, column), converted(node, std::move(member)));
  }
  std::sort(members.begin(), members.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  into.kind = Value::Kind::Table;
  for (auto& member : members) into.items.push_back(std::move(member.second));
}

Value converted(const toml::node& node, Value into) {
  if (const toml::table* const table = node.as_table()) {
    convert_table(*table, into);
  } else if (const toml::array* const list = node.as_array()) {
    convert_list(*list, into);
  } else if (const auto* const words = node.as_string()) {
    into.kind = Value::Kind::Text;
    into.text = words->get();
  } else if (const auto* const whole = node.as_integer()) {
    into.kind = Value::Kind::Number;
    into.number = static_cast<double>(whole->get());
  } else if (const auto* const real = node.as_floating_point()) {
    into.kind = Value::Kind::Number;
    into.number = real->get();
  } else if (const auto* const truth = node.as_boolean()) {
    into.kind = Value::Kind::Truth;
    into.truth = truth->get();
  } else {
    into.kind = Value::Kind::Time;
  }
  return into;
}

}  // namespace

std::string in_quotes(std::string_view text) { return "'" + clipped(text) + "'"; }

const Value* Value::find(std::string_view member) const {
  for (const Value& item : items)
    if (item.name == member) return &item;
  return nullptr;
}

std::vector<const Value*> Value::one_or_several() const {
  if (kind != Kind::List) return {this};
  std::vector<const Value*> all;
  for (const Value& item : items) all.push_back(&item);
  return all;
}

std::string Value::shown() const {
  switch (kind) {
    case Kind::Text:
      return "the text " + in_quotes(text);
    case Kind::Number:
      return signorini::text("the number ", number);
    case Kind::Truth:
      return truth ? "true" : "false";
    case Kind::Time:
      return "a date or time";
    case Kind::List:
      return signorini::text("a list of ", items.size());
    case Kind::Table:
      return "a table";
  }
  return {};
}

Value parse_toml(std::string_view content, Origin origin) {
  const std::string name = origin.name;
  try {
    const toml::table table = toml::parse(content);
    return converted(table, {{}, {}, {}, 1, std::make_shared<const Origin>(std::move(origin))});
  } catch (const toml::parse_error& error) {
    std::string said(error.description().substr(0, 200));
    std::replace_if(
        said.begin(), said.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    throw ProblemError(
        signorini::text(name, ":", line_of(error.source(), 1), ": this is no TOML: ", said));
  }
}

}  // namespace signorini
