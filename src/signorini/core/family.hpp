// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Open families: tables of members that are found by their names.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {

/// \param family  members, each with a `name`
/// \return their names, with commas
template <typename Member>
[[nodiscard]] std::string names_of(const std::vector<Member>& family) {
  std::string names;
  for (const Member& member : family)
    names += (names.empty() ? "" : ", ") + std::string(member.name);
  return names;
}

/// The one list of a family to which programs add members. It is made when it is first asked for: a global object might
/// not exist yet when another file adds its members before `main`.
/// \return it, empty to begin with
template <typename Member>
[[nodiscard]] std::vector<Member>& open_family() {
  static std::vector<Member> members;
  return members;
}

/// Adds a member, unless the family has one of that name.
/// \param member  with a `name`
/// \param family  of members, in the order in which they are listed and asked
/// \param before  name of the member in front of which it goes; the last place if there is none of that name
template <typename Member>
void add_member(const Member& member, std::vector<Member>& family, const std::string& before = "") {
  const auto place = [&family](const std::string& name) {
    return std::find_if(family.begin(), family.end(),
                        [&name](const Member& known) { return known.name == name; });
  };
  if (place(member.name) == family.end()) family.insert(place(before), member);
}

/// Looks up a member.
/// \param family  members, each with a `name`
/// \param name    of the wanted one
/// \param what    what a message calls a member, such as "element"
/// \return the member
/// \throws ProblemError with the nearest name and all others if there is none
template <typename Member>
[[nodiscard]] const Member& find_member(const std::vector<Member>& family, const std::string& name,
                                        const char* what) {
  std::vector<std::string> known;
  for (const Member& member : family) {
    if (member.name == name) return member;
    known.emplace_back(member.name);
  }
  throw ProblemError(text("unknown ", what, " ", in_quotes(name), suggestion(name, known)));
}

}  // namespace signorini
