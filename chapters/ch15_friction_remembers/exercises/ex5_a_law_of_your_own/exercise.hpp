/// \file
/// Exercise 15.5 - a family of laws of friction. Do not change this file.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace ex15_5 {

/// A member of the family.
struct Law {
  std::string name;  ///< no other member has it
  /// Largest friction force >= 0 of a closed pair [force], from the force that presses it > 0 [force]
  std::function<double(double force)> bound;
};

/// \param mu  coefficient >= 0 [-] \return Coulomb's law: mu times the force
[[nodiscard]] inline Law coulomb(double mu) {
  return {"coulomb", [mu](double force) { return mu * force; }};
}

/// \param c  >= 0 [force] \return Tresca's law, "tresca": c, whatever the force
[[nodiscard]] Law tresca(double c);

/// \param mu  coefficient >= 0 [-]
/// \param c   ceiling >= 0 [force]
/// \return "ceiling": Coulomb's law, but never more than c
[[nodiscard]] Law ceiling(double mu, double c);

/// A spring with a tip on a wall.
struct Slider {
  double stiffness;  ///< k > 0 [force/length]
  double place = 0;  ///< of the tip: its slip in total [length]
  double lost = 0;   ///< dissipated so far [force*length]
};

/// A load step.
/// \param law     a member
/// \param force   that presses the tip now [force]; 0: it is open
/// \param hand    where the hand is now [length]
/// \param slider  as before the step; gets place and dissipation of now
/// \return what the hand pulls [force]; nothing if the tip is open, which then moves until the spring is slack
[[nodiscard]] double step(const Law& law, double force, double hand, Slider& slider);

}  // namespace ex15_5
