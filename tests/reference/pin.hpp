// Reference numbers of the rigid pin in an elastic plate: Xuan & Li 2002, section 4, example 3.
//
// E = 1000 kN/cm^2, nu = 0.3, plane strain, q = 25 kN/cm^2 on the right side, epsilon = 0.2 cm, which we read as
// the clearance. Dimensions and pressures are in figures that our copy lacks; 5 cm for the hole, 20 cm for the square
// plate and the readings (T), q pulls, and (C), q presses, are ours, and so are all numbers below.
#pragma once
#include <array>

namespace reference {

/// One reading of the load, computed by a separate program with its own elements and solver.
struct PinReading {
  const char* name;
  double pressure;  // on the right side, against the body [kN/cm^2]
  std::array<double, 8>
      force;  // 15 x 15 even cells q4, half model, at 0, 12, ..., 84 degrees from the pole
  double right_displacement;  // u_x in the middle of the right side, same mesh [cm]
  std::array<double, 9>
      limit;  // pressure at 0, 10, ..., 80 degrees, meshes of 180 x 90 cells [kN/cm^2]
  double limit_displacement;  // same meshes [cm]
};

inline constexpr PinReading pin_readings[] = {
    {"T",
     -25,
     {18.9999324, 41.7319846, 50.7739259, 60.1983013, 66.8434304, 66.6110769, 53.2491687,
      5.8057608},
     1.361006,
     {35.67, 38.29, 45.07, 53.38, 60.34, 63.95, 63.08, 55.55, 29.26},
     1.387},
    {"C",
     25,
     {33.5625729, 67.1057239, 65.5381842, 59.3938334, 47.3630259, 22.3666861, 0, 0},
     -0.228866,
     {63.06, 63.23, 62.99, 60.60, 54.48, 43.60, 24.97, 0, 0},
     -0.230},
};

/// Rigid pin in an infinite plate, nu = 0.3, plane strain: the integral equation of the contact, which has
/// no closed form there. Half of the contact angle [deg], E_h Delta R / P and p(0) a / P.
struct RigidPin {
  double half_angle;
  double clearance_over_load;
  double pressure;
};
inline constexpr RigidPin rigid_pins[] = {
    {10, 42.544885, 3.652123}, {20, 10.325, 1.8432},     {30, 4.242329, 1.251534},
    {40, 2.0838, 0.96577},     {50, 1.0784, 0.80395},    {60, 0.533945, 0.705520},
    {70, 0.21019, 0.64452},    {75, 0.096681, 0.623673},
};

}  // namespace reference
