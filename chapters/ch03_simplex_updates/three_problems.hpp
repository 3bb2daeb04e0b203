// Chapter 3 - Six rules and three problems to try them on.
#pragma once
#include <string>
#include <vector>

#include "addons/programme/dense_programme.hpp"
#include "papers/examples.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace ch03 {

using namespace signorini;

struct Rule {
  const char* name;
  WeightRule rule;
};
const Rule rules[] = {
    {"literal (28)", WeightRule::LiteralVertex}, {"2/(k+2)", WeightRule::Harmonic},
    {"line search", WeightRule::LineSearch},     {"away steps", WeightRule::AwaySteps},
    {"pairwise", WeightRule::Pairwise},          {"fully corrective", WeightRule::FullyCorrective}};

struct Named {
  std::string name;
  ContactProblem problem;
};

/// Two random programmes and a punch, which stands a little to the right of the middle, so that no two
/// pairs are alike and rounding decides nothing. Rows are scaled to a unit diagonal of G, as in every solver.
inline std::vector<Named> three_problems() {
  Indentation punch = half_plane_indentation(200);
  punch.problem.free_gap -= 0.05 * punch.position;
  std::vector<Named> list = {
      {"half-plane, 200", punch.problem},
      {"Rosen-Suzuki 50, 50", condense(rosen_suzuki(50, 50, 1).programme).problem},
      {"Rosen-Suzuki 20, 80", condense(rosen_suzuki(20, 80, 1).programme).problem}};
  for (Named& named : list) {
    const ScaledProblem scaled = equilibrate(named.problem);
    named.problem = {scaled.compliance, scaled.free};
  }
  return list;
}

}  // namespace ch03
