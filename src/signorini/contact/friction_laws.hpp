/// \file
/// The laws of friction by name: an open family.
///
/// The law says how much friction a pair can bear. That it resists sliding, and slides only at its
/// bound, is the same for all laws and stands in the solvers.
#pragma once
#include <string>
#include <vector>

namespace signorini {

/// Friction between two sides, by a law of the family; slip counts from the load step before.
///
/// The usual law, "coulomb", is |tau| <= mu lambda + c where the sides touch. With mu = 0 and c > 0 that is Tresca's,
/// too; "tresca" refuses a mu.
struct Friction {
  double coefficient = 0;       ///< mu >= 0 [-]
  double cohesion = 0;          ///< c >= 0 where the sides touch [force/length^2]
  std::string law = "coulomb";  ///< name in friction_laws()
};

/// How large the friction force of a closed pair may be: \f$ b = slope\,\lambda + offset \f$.
struct FrictionBound {
  double slope = 0;   ///< >= 0 [-]
  double offset = 0;  ///< >= 0 [force]
};

/// A law. A member is a function that says what the numbers of a contact make of one pair, and a line in the table.
///
/// Solvers, certificates and load steps take every bound that is a straight line over the force that presses the pair,
/// see FrictionLaw, and nothing else: so a new law needs no other change. One whose bound is curved would.
struct FrictionLawMember {
  const char* name;     ///< as in find_friction_law() and in a scene
  const char* summary;  ///< one line for lists
  /// The bound of a pair of a given weight, see Pairs [length^2]. Throws ProblemError, which says what to
  /// do, for a number that has no meaning in this law. That slope and offset are numbers >= 0 is looked at elsewhere.
  FrictionBound (*bound)(const Friction& friction, double weight);
};

/// The family.
/// \return all members, in the order of lists and tables
[[nodiscard]] const std::vector<FrictionLawMember>& friction_laws();

/// Looks up a member.
/// \param name  of the law
/// \return the member
/// \throws ProblemError listing the known names if there is none
[[nodiscard]] const FrictionLawMember& find_friction_law(const std::string& name);

}  // namespace signorini
