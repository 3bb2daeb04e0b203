/// \file
/// The family of strain laws: small strain, and what add-ons add, such as those of finite strain.
#pragma once
#include <string>
#include <vector>

#include "signorini/fem/strain_law.hpp"

namespace signorini {

/// \return small strain, and the members that were added, in that order
[[nodiscard]] const std::vector<StrainLaw>& strain_laws();

/// Adds a member to the family, unless it has one of that name. A program does so at its beginning: materials refer to
/// members. \param member  of an add-on or a program
void add_strain_law(const StrainLaw& member);

/// Looks up a law.
/// \param name  of a member
/// \return the member; null for small strain
/// \throws ProblemError listing the known names if there is none
[[nodiscard]] const StrainLaw* find_strain_law(const std::string& name);

}  // namespace signorini
