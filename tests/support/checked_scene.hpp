// Whether a solved scene solves what was posed: by arithmetic of its own, from K, p, A, g and the law.
#pragma once
#include "signorini/scene/solution.hpp"

namespace signorini_test {

/// How far a solution is from each law, free of units; 0 is perfect.
///
/// Everything is summed in `__float128`, or long double where a compiler has none, and nothing is taken from
/// the library but the model and the numbers of the solution. Rows count as if they had norm 1. Lengths are
/// divided by the largest |a_i| (|u| + (|p| + |A^T f|) / K_jj) of all rows, which a pair would move by if its
/// neighbours let it; forces by the largest load or contact force on an unknown.
struct SceneErrors {
  double equilibrium = 0;      ///< p - K u - A^T f, with friction forces among f
  double strain = 0;           ///< of the rigid part of u: K times it, over what its terms may be
  double penetration = 0;      ///< overlap
  double tension = 0;          ///< negative contact force
  double complementarity = 0;  ///< smaller of |gap| and |force|
  double cone =
      0;  ///< friction force beyond mu lambda + c, or any on a pair that is said to be open
  double stick = 0;    ///< slip of a pair that is said to stick
  double sliding = 0;  ///< smaller of |slip| and what friction lacks to resist it
  double reading = 0;  ///< difference of the gaps, slips and forces that are told from those of u
  double balance = 0;  ///< of the resultants that are told, see unbalanced(); 0 unless it was asked
  double length = 0;   ///< that lengths were divided by [length]
  /// Whether pairs that carry or stick leave no rigid motion. Without that others may still do.
  bool held = true;

  /// \return the largest of all; infinity if one is not a number
  [[nodiscard]] double worst() const;
};

/// Keeps the largest, and what is not a number. \param[in,out] figure  so far \param value  the next one
void grow(double& figure, double value);

/// Checks a solution whose status is Solved. \param model from build() \param solution of it
/// \param length  that lengths are divided by at least: what slips count from was rounded to it [length]
/// \param stiffest  largest K_jj of the bodies, if the K of the model has not all of them [force/length]; 0: it has
SceneErrors check_scene(const signorini::Model& model, const signorini::Solution& solution,
                        double length = 0, double stiffest = 0);

}  // namespace signorini_test
