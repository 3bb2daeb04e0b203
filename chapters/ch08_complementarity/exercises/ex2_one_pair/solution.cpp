#include "exercise.hpp"
#include "signorini/problem/complementarity_functions.hpp"

namespace ex8_2 {

System equations(const Pair& pair, const Eigen::Vector4d& unknowns) {
  using signorini::fischer_burmeister;
  using signorini::fischer_burmeister_slope;
  const double Gn = pair.normal_compliance, Gt = pair.tangential_compliance, H = pair.coupling;
  const double fn = unknowns(0), ft = unknowns(1), plus = unknowns(2), minus = unknowns(3);
  const double gap = pair.free_gap + Gn * fn + H * ft;
  const double slip = pair.free_slip + H * fn + Gt * ft;
  const double mu = pair.mu, bound = (Gn * fn > gap ? pair.cohesion : 0) + mu * fn;
  const double left = Gt * (bound - ft), right = Gt * (bound + ft);
  const auto n = fischer_burmeister_slope(gap, Gn * fn);
  const auto m = fischer_burmeister_slope(minus, left);
  const auto p = fischer_burmeister_slope(plus, right);
  System system;
  system.residual << fischer_burmeister(gap, Gn * fn), slip - plus + minus,
      fischer_burmeister(minus, left), fischer_burmeister(plus, right);
  system.jacobian << Gn * (n.a + n.b), H * n.a, 0, 0,  //
      H, Gt, -1, 1,                                    //
      m.b * Gt * mu, -m.b * Gt, 0, m.a,                //
      p.b * Gt * mu, p.b * Gt, p.a, 0;
  return system;
}

}  // namespace ex8_2
