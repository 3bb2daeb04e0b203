/// \file
/// Open families: tables of members that are found by their names.
#pragma once
#include <string>
#include <vector>

#include "signorini/core/errors.hpp"

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

/// Looks up a member.
/// \param family  members, each with a `name`
/// \param name    of the wanted one
/// \param what    what a message calls a member, such as "element"
/// \return the member
/// \throws ProblemError listing the known names if there is none
template <typename Member>
[[nodiscard]] const Member& find_member(const std::vector<Member>& family, const std::string& name,
                                        const char* what) {
  for (const Member& member : family)
    if (member.name == name) return member;
  throw ProblemError(
      text("unknown ", what, " '", name, "'; known ", what, "s: ", names_of(family)));
}

}  // namespace signorini
