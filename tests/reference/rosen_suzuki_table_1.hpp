// Table 1 of Xuan & Li 2002 (section 4, example 1, in the journal): random quadratic programmes after Rosen and
// Suzuki, solved by Lemke's method and by the paper's, on a personal computer with a Pentium II.
#pragma once
#include <array>

namespace reference {

/// One line of the table, as printed.
struct RandomProgramme {
  int n;                 // variables
  int m;                 // constraints
  double lemke_seconds;  // "CPU time"
  double paper_seconds;
  double ratio;  // f_P / f_L: objective of the paper's method over that of Lemke's
};

inline constexpr std::array<RandomProgramme, 12> table_1 = {{
    {10, 5, 0.0547, 0.1094, 1.000000429},
    {10, 10, 0.1094, 0.2773, 1.000000339},
    {10, 20, 0.2188, 0.4922, 0.999974259},
    {10, 40, 0.5000, 0.5547, 1.000000028},
    {20, 10, 0.3281, 0.3828, 1.000062813},
    {20, 20, 0.7188, 0.8750, 1.000144523},
    {20, 40, 1.5391, 2.0859, 1.000043496},
    {20, 80, 5.1641, 1.5391, 1.000020437},
    {50, 25, 3.9063, 2.3672, 1.000000208},
    {50, 50, 10.2734, 13.4609, 1.000021058},
    {50, 100, 26.2656, 16.5312, 1.000100312},
    {50, 200, 84.6719, 31.6406, 1.000013100},
}};

}  // namespace reference
