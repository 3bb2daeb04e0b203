// Which members of a family the conformance suite looks at: `make conformance WHAT=name`.
#pragma once
#include <string>
#include <vector>

namespace signorini_test {

/// The name in the environment variable SIGNORINI_CONFORMANCE; empty, and all members are meant. A name that no
/// member of any family has ends the program with status 2 and a list of those that there are.
const std::string& chosen_name();

/// \param family  any
/// \return its members, or the one with the chosen name, if it is in this family
template <class Member>
std::vector<Member> chosen(const std::vector<Member>& family) {
  if (chosen_name().empty()) return family;
  std::vector<Member> one;
  for (const Member& member : family)
    if (member.name == chosen_name()) one.push_back(member);
  return one;
}

}  // namespace signorini_test
