// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Where a law of finite strain stops to be one of a material.
#pragma once
#include <string>
#include <vector>

#include "addons/motion/finite_strain.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// The least \f$ a_i n_J A_{iJkL} a_k n_L \f$ of unit vectors a and n in the plane: what a material has against a plane wave with
/// the normal n that moves it along a. Where it is negative the law is not strongly elliptic.
/// \param response  of a law, with its tangent
/// \return the least of 32 directions n and all a [force/length^2]
[[nodiscard]] double least_wave_stiffness(const StressResponse& response);

/// \param model     with bodies that have laws
/// \param solution  of it
/// \return a note for each body with cells where that least value is negative: strong ellipticity is lost
[[nodiscard]] std::vector<std::string> notes_on_laws(const Model& model, const Solution& solution);

}  // namespace signorini
