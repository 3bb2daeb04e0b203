#include "exercise.hpp"
#include "signorini/problem/complementarity_functions.hpp"

namespace ex8_2 {

// `split` of one_pair.hpp: compliances of 1 and no coupling, cohesion in every pair, lengths beside forces.
// Change it.
System equations(const Pair& pair, const Eigen::Vector4d& unknowns) {
  using signorini::fischer_burmeister;
  using signorini::fischer_burmeister_slope;
  const double fn = unknowns(0), ft = unknowns(1), plus = unknowns(2), minus = unknowns(3);
  const double gap = pair.free_gap + fn, bound = pair.cohesion + pair.mu * fn;
  const auto n = fischer_burmeister_slope(gap, fn);
  const auto m = fischer_burmeister_slope(minus, bound - ft);
  const auto p = fischer_burmeister_slope(plus, bound + ft);
  System system;
  system.residual << fischer_burmeister(gap, fn), pair.free_slip + ft - plus + minus,
      fischer_burmeister(minus, bound - ft), fischer_burmeister(plus, bound + ft);
  system.jacobian << n.a + n.b, 0, 0, 0,  //
      0, 1, -1, 1,                        //
      pair.mu * m.b, -m.b, 0, m.a,        //
      pair.mu * p.b, p.b, p.a, 0;
  return system;
}

}  // namespace ex8_2
