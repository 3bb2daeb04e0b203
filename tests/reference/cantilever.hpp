// Reference numbers of the cantilever above a rigid flat foundation: Xuan & Li 2002, section 4, example 2.
//
// l = 50 cm, h = 5 cm, gap 1 cm, q = 3.6 kN/cm^2, E = 2.1e4 kN/cm^2, nu = 0.29, plane stress. The rest is in a
// figure that our copy lacks; length l, height h, thickness 1 cm, left end clamped, q on the upper face and a
// flat foundation are our reading. The paper draws the pressure; its text has no number of it.
#pragma once
#include <array>

namespace reference {

// Closed form: beam theory (see src/closed_form/beam.hpp). q = 3.6, in cm and kN.
inline constexpr double euler_touchdown = 45.7346;
inline constexpr double euler_force = 70.2371;
inline constexpr double timoshenko_touchdown = 42.7332;
inline constexpr double timoshenko_force = 71.7364;
inline constexpr double timoshenko_point_force = 5.1964;  // what stays at the tip
// Closed form: only the tip touches, q = 1.
inline constexpr double euler_tip_force = 13.5;
inline constexpr double timoshenko_tip_force = 13.588;

/// Mesh-exact: the answer on one mesh, computed by a separate program with its own elements and solver.
struct MeshExact {
  const char* element;
  int cells_x;
  int cells_y;
  double total_force;            // [kN]
  int closed_pairs;              // from x = 42 cm to the tip
  double free_tip_deflection;    // without the foundation, lower corner [cm]; 0 if not known
  double potential_energy;       // u K u / 2 - p u with contact [kN cm]; 0 if not known
  std::array<double, 9> forces;  // x = 42, 43, ..., 50 cm [kN]; zeros if not known
};

inline constexpr MeshExact meshes[] = {
    {"q4",
     50,
     5,
     71.0017023,
     9,
     -12.714977,
     -93.558147,
     {.8145446, 9.9218296, 11.6895807, 11.1172196, 9.8942042, 8.6130626, 7.6569199, 7.3729467,
      3.9213945}},
    {"q4_incompatible",
     50,
     5,
     71.5302497,
     9,
     -12.960121,
     -93.970099,
     {3.0201551, 10.1529035, 11.5827111, 10.8769287, 9.6119684, 8.3147791, 7.3382799, 6.9990030,
      3.6335208}},
    {"q4", 100, 10, 71.4604341, 17, 0, 0, {}},
    {"q4_incompatible", 100, 10, 71.5943802, 17, 0, 0, {}},
};

// Extrapolated from meshes of up to 800 x 80 incompatible cells; five digits.
inline constexpr double plane_total_force = 71.626;

}  // namespace reference
