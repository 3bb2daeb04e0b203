// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The family of checks: observers that tell a user what is legal but seldom meant. A check writes notes, and the last of its functions may
/// withdraw a solution. What would give wrong answers whatever is computed is refused before that. The library has no member; a program gets those of the add-on
/// checks by register_checks().
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// One member of the family. Each of its functions may be null; those that return notes return none if all is well.
struct Check {
  using Notes = std::vector<std::string>;  ///< one sentence or more each
  const char* name;                        ///< of the member
  /// Asked by plan() of every body, before effects.
  Notes (*mesh)(const Scene& scene, const BodyModel& body) = nullptr;
  /// Asked by plan() of every body, after effects; the boundaries of its loads exist.
  Notes (*loads)(const Body& body) = nullptr;
  /// Asked by plan() of every contact, with its pairs as the meshes give them: supports have taken none yet, and nothing
  /// has changed gaps.
  Notes (*contact)(const ContactSpec& contact, const std::vector<BodyModel>& bodies,
                   const Pairs& pairs) = nullptr;
  /// Asked by solve() of a solution that is Solved.
  Notes (*solution)(const Model& model, const Solution& solution) = nullptr;
  /// Asked by solve() behind all others: may add to a solution that is Solved, or withdraw it.
  void (*withdraw)(const Model& model, const Condensed& condensed, Solution& solution) = nullptr;
};

/// \return all members, in the order in which they are asked
[[nodiscard]] const std::vector<Check>& checks();

/// Adds a member to the family, unless it has one of that name. \param member  of an add-on or a program
void add_check(const Check& member);

/// Asks every member that has a function.
/// \param notes     gets what they return
/// \param function  of a member, such as `&Check::mesh`
/// \param subjects  its arguments
template <typename... Subjects>
void ask_checks(std::vector<std::string>& notes,
                Check::Notes (*Check::*function)(const Subjects&...), const Subjects&... subjects) {
  for (const Check& check : checks())
    if (check.*function != nullptr)
      for (std::string& note : (check.*function)(subjects...)) notes.push_back(std::move(note));
}

/// Asks every member for its notes on a solution, then those that may withdraw it.
/// \param model      that was solved
/// \param condensed  from condense() of it
/// \param[in,out] solution  Solved
void check_solution(const Model& model, const Condensed& condensed, Solution& solution);

}  // namespace signorini
