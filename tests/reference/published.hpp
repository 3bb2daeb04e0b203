// Numbers of contact problems that other programs publish or keep for their own tests.
#pragma once

namespace reference {

/// Two elements with a gap of 0.1 between them, plane stress, E = 288, nu = 1/3, the top moved by (-0.2, -0.2):
/// exact for the mesh. JuliaFEM/MortarContact2D.jl (MIT), test/test_contact2d.jl, commit 228ccd82.
struct TwoElements {
  double pressure;     // of both pairs
  double lower[2][2];  // displacements of the upper corners of the lower element, left and right
  double upper[2][2];  // of the lower corners of the upper element
};
inline constexpr TwoElements two_elements = {
    30.375, {{-0.01875, -0.05}, {0.01875, -0.05}}, {{-0.21875, -0.15}, {-0.18125, -0.15}}};

/// The contact patch test of El-Abbasi and Bathe (2001) as Code_Aster has it, V6.03.121 (SSNP121): two unit squares,
/// E = 2e6 Pa, nu = 0, the top moved down by 0.1 m.
inline constexpr double patch_pressure = 1e5;     // [Pa]
inline constexpr double patch_interface = -0.05;  // vertical displacement [m]

/// Contact benchmark 1 of NAFEMS (Konter 2006), also Code_Aster V6.03.154 (SSNP154): a steel roller, R = 50 mm,
/// E = 210 GPa, on an aluminium block, E = 70 GPa, nu = 0.3 both, plane strain, 35 kN/mm, no friction.
inline constexpr double roller_half_width = 6.21463;  // Hertz [mm]
inline constexpr double roller_peak = 3585.36;        // Hertz [MPa]
inline constexpr double roller_displacement =
    -1.30690;  // under the roller, MARC, 4-node cells [mm]
inline constexpr double roller_displacement_q8 = -1.30802;  // the same, 8-node cells

/// The benchmark of the group GRECO, Code_Aster V6.04.128 (SSNV128), after Feijoo, Barbosa and Zouain: the lower side
/// of the block of rough_block() moves by so much at x = 0, 1.25, 5, 7.5 and 11.25 mm: means of several programs,
/// which Code_Aster takes for right within 5 %.
inline constexpr double rough_block_slip[5] = {2.86e-5, 2.72e-5, 2.28e-5, 1.98e-5, 1.5e-5};  // [m]
inline constexpr double rough_block_tolerance = 0.05;
/// The same by Code_Aster, 325 triangles of 6 nodes and a penalty; astest/ssnv128d.comm.
inline constexpr double rough_block_slip_aster[5] = {2.8722e-5, 2.7355e-5, 2.2996e-5, 1.9943e-5,
                                                     1.5569e-5};

}  // namespace reference
