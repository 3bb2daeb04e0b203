/// \file
/// Tables of keys: what a key is called, what it must hold and how it is read, in one line each.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "addons/files/toml_value.hpp"
#include "signorini/core/alignment.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {

/// What people are told of a key.
struct KeyInfo {
  std::string name;       ///< as in the file
  std::string type;       ///< what its value must be, such as "number > 0"
  std::string unit;       ///< dimension, empty if none
  std::string standard;   ///< what holds without the key, as a file would say it; empty: nothing
  std::string help;       ///< one line
  bool required = false;  ///< whether it must be there
};

/// A key of a table that fills a T.
template <typename T>
struct Key : KeyInfo {
  std::function<void(const Value&, T&)> read;  ///< checks the value and puts it into the T

  /// \param info  what people are told of it \param reader  see `read`
  Key(KeyInfo info, std::function<void(const Value&, T&)> reader)
      : KeyInfo(std::move(info)), read(std::move(reader)) {}
  /// \param key  of what every T is
  template <typename Base>
  Key(const Key<Base>& key) : KeyInfo(key), read(key.read) {}
};

/// The keys of a table, in the order in which they are read.
template <typename T>
using Keys = std::vector<Key<T>>;

/// What numbers may be.
enum class Bound {
  Any,          ///< finite
  NotNegative,  ///< 0 or more
  Positive      ///< more than 0
};

/// One word for one member of an enumeration.
template <typename E>
struct Word {
  const char* name;  ///< as in the file
  E meaning;         ///< the member
};

/// The words of an enumeration; every one that files may name specialises it with `static std::vector<Word<E>> all()`.
template <typename E>
struct Words;

/// Checks that a value is a table whose keys are known and that it has those that it must have.
/// \param table      to be checked
/// \param keys       known here
/// \param elsewhere  returns, for a key that is not known here, where it would be, or nothing
/// \throws ProblemError otherwise
void check_members(const Value& table, const std::vector<KeyInfo>& keys,
                   const std::function<std::string(const std::string&)>& elsewhere = {});

/// \param keys  any \return what people are told of them
template <typename T>
[[nodiscard]] std::vector<KeyInfo> infos(const Keys<T>& keys) {
  return {keys.begin(), keys.end()};
}

/// Fills a T from those members of a table that have a key, in the order of the keys.
/// \param table  through check_members()
/// \param keys   of the table
/// \param into   to be filled
template <typename T>
void fill(const Value& table, const Keys<T>& keys, T& into) {
  for (const Key<T>& key : keys)
    if (const Value* const value = table.find(key.name)) key.read(*value, into);
}

/// Checks a table and fills a T from it.
/// \param table  any value
/// \param keys   of the table
/// \param into   to be filled
/// \throws ProblemError as check_members() and for values of a wrong type
template <typename T>
void read_members(const Value& table, const Keys<T>& keys, T& into) {
  check_members(table, infos(keys));
  fill(table, keys, into);
}

/// Reads a table, or a list of them, item by item.
/// \param read  reads one of them
/// \return the reader of a Key
template <typename T>
[[nodiscard]] std::function<void(const Value&, T&)> each_item(void (*read)(const Value&, T&)) {
  return [read](const Value& value, T& into) {
    for (const Value* const item : value.one_or_several()) read(*item, into);
  };
}

/// A list of so many values.
/// \param value  any
/// \param count  of values that are wanted
/// \param what   each of them is, for messages
/// \return its items
/// \throws ProblemError if it is no list, or of another length
[[nodiscard]] const std::vector<Value>& list_of(const Value& value, std::size_t count,
                                                const std::string& what);

/// What a member of one of the plain types is filled with: double, Index, int, bool, std::string, Vector2d,
/// VectorXd, lists of Index and of double. take(), type_name() and written() know optional ones and words as well.
template <typename M>
struct Plain {
  /// \param value  of a key \param into  receives it \param bound  of numbers
  /// \throws ProblemError for a value that is anything else
  static void take(const Value& value, M& into, Bound bound);
  /// \param bound  of numbers \return what messages and the reference call the type
  [[nodiscard]] static std::string type_name(Bound bound);
  /// \param value  any \return as a file would say it; empty for what says nothing
  [[nodiscard]] static std::string written(const M& value);
};

/// The type of the value of an M that may be absent, else the M.
template <typename M>
struct Present {
  using Type = M;                               ///< the M
  static constexpr bool may_be_absent = false;  ///< whether there may be none
};
/// \copydoc Present
template <typename M>
struct Present<std::optional<M>> {
  using Type = M;                              ///< of its value
  static constexpr bool may_be_absent = true;  ///< whether there may be none
};

/// A value of a key: checked, and put into what it fills.
/// \param value  of a key
/// \param into   receives it
/// \param bound  of numbers
/// \throws ProblemError for a value that is anything else
template <typename M>
void take(const Value& value, M& into, Bound bound = Bound::Any) {
  if constexpr (Present<M>::may_be_absent) {
    take(value, into.emplace(), bound);
  } else if constexpr (std::is_enum_v<M>) {
    std::string word;
    take(value, word);
    std::vector<std::string> known;
    for (const auto& [name, meaning] : Words<M>::all()) {
      known.emplace_back(name);
      if (name != word) continue;
      into = meaning;
      return;
    }
    value.fail("unknown word ", in_quotes(word), suggestion(word, known));
  } else {
    Plain<M>::take(value, into, bound);
  }
}

/// Fills a T from a table, or its main member from a value alone.
/// \param value   any
/// \param keys    of the table
/// \param into    to be filled
/// \param main    member that the value alone fills
/// \param bound   of it
/// \throws ProblemError as read_members() and take()
template <typename T, typename M>
void take_or_table(const Value& value, const Keys<T>& keys, T& into, M T::*main,
                   Bound bound = Bound::Any) {
  if (value.kind == Value::Kind::Table) return read_members(value, keys, into);
  take(value, into.*main, bound);
}

/// \param bound  of numbers \return what messages and the reference call the type of a member
template <typename M>
[[nodiscard]] std::string type_name(Bound bound = Bound::Any) {
  using Type = typename Present<M>::Type;
  if constexpr (std::is_enum_v<Type>) {
    std::string names;
    for (const auto& word : Words<Type>::all())
      names += (names.empty() ? "\"" : " or \"") + std::string(word.name) + '"';
    return names;
  } else {
    return Plain<Type>::type_name(bound);
  }
}

/// \param value  of a member \return as a file would say it; empty for what says nothing
template <typename M>
[[nodiscard]] std::string written(const M& value) {
  if constexpr (Present<M>::may_be_absent) {
    return value ? written(*value) : std::string();
  } else if constexpr (std::is_enum_v<M>) {
    for (const auto& word : Words<M>::all())
      if (word.meaning == value) return '"' + std::string(word.name) + '"';
    return {};
  } else {
    return Plain<M>::written(value);
  }
}

/// A text that names a member of an open family.
/// \param value   any
/// \param family  members, each with a `name`
/// \param what    what messages call a member, such as "element"
/// \param into    receives the name
/// \throws ProblemError if it is no text or names no member
template <typename Member>
void take_member(const Value& value, const std::vector<Member>& family, const char* what,
                 std::string& into) {
  take(value, into);
  value.explain([&] { static_cast<void>(find_member(family, into, what)); });
}

/// A key that fills one member. The value of a default T is what holds without it.
/// \param name    of the key
/// \param member  to be filled
/// \param unit    of it
/// \param help    one line
/// \param bound   of numbers
/// \return the key
template <typename T, typename M>
[[nodiscard]] Key<T> key(const char* name, M T::*member, const char* unit, const char* help,
                         Bound bound = Bound::Any) {
  return {{name, type_name<M>(bound), unit, written(T{}.*member), help},
          [member, bound](const Value& value, T& into) { take(value, into.*member, bound); }};
}

/// A key that fills two members from a list of two.
/// \param name    of the key
/// \param first   member
/// \param second  member
/// \param unit    of both
/// \param help    one line
/// \param bound   of both
/// \return the key
template <typename T, typename M>
[[nodiscard]] Key<T> key(const char* name, M T::*first, M T::*second, const char* unit,
                         const char* help, Bound bound = Bound::Any) {
  const std::string type = "two of: " + type_name<M>(bound);
  return {{name, type, unit, "[" + written(T{}.*first) + ", " + written(T{}.*second) + "]", help},
          [first, second, bound](const Value& value, T& into) {
            const std::string each = type_name<M>(bound);
            const std::vector<Value>& both = list_of(value, 2, each);
            take(both[0], into.*first, bound);
            take(both[1], into.*second, bound);
          }};
}

/// \param key  any \return the same key, whose help says what holds without it
template <typename T>
[[nodiscard]] Key<T> without_standard(Key<T> key) {
  key.standard.clear();
  return key;
}

/// \param key  any \return the same key, which must now be there
template <typename T>
[[nodiscard]] Key<T> required(Key<T> key) {
  key.required = true;
  return without_standard(key);
}

}  // namespace signorini
