// Reference numbers of the lining in a tunnel: Lin et al., section 3.4.
//
// Two rings of 210 GPa and nu = 0.3 in plane strain, 0.15 cm apart, 180 MPa inside, a quarter with 120 nodes and 90
// cells. The text has no radii, figure 20 is not in our copy; 60, 68, 68.15, 76.15 cm are ours.
#pragma once

namespace reference {

/// What the paper prints [cm].
inline constexpr double lining_u_paper = 0.2897;     // largest displacement, the paper's method
inline constexpr double lining_u_abaqus = 0.290828;  // the same, ABAQUS
inline constexpr double lining_pair[2] = {0.1149, 0.0964};  // what node 10 moves more than node 80

/// Our radii on the paper's mesh, computed by a separate program with its own elements and solver.
struct LiningMesh {
  const char* element;
  double u;         // on the inner rim [cm]
  double pressure;  // nodal force by the length of the arc, not of the chord [MPa]
};
inline constexpr LiningMesh lining_meshes[] = {{"q4", 0.291410, 44.0187},
                                               {"q4_incompatible", 0.291868, 44.0735}};

}  // namespace reference
