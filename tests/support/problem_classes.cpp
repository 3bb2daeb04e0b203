// The table of problem classes.
#include "support/problem_classes.hpp"

#include "support/classes/classes.hpp"

namespace signorini_test {

const std::vector<ProblemClass>& problem_classes() {
  using signorini::Trait;
  const Trait asymmetric = Trait::Asymmetric;
  const Trait dependent = Trait::Dependent;
  const Trait infeasible = Trait::Infeasible;
  const Trait degenerate = Trait::Degenerate;
  const Trait ill = Trait::IllConditioned;
  const Trait slow = Trait::Slow;
  static const std::vector<ProblemClass> table = {
      {"empty", {}, empty_problem},
      {"one pair", {}, one_pair},
      {"two pairs in each of the four states", {}, two_pairs},
      {"none active", {}, none_active},
      {"all active", {}, all_active},
      {"built backwards", {}, built_backwards},
      {"Rosen-Suzuki, at most as many rows as unknowns", {}, rosen_suzuki_few},
      {"Rosen-Suzuki, more rows than unknowns", {dependent}, rosen_suzuki_many},
      {"stiff mode, cond(K) up to 1e13", {}, stiff_mode},
      {"soft mode, cond(K) 1e6", {}, soft_mode},
      {"weakly active", {degenerate}, weakly_active},
      {"half of the free gaps zero", {degenerate}, half_zero},
      {"duplicated rows", {dependent, degenerate}, duplicated_rows},
      {"redundant rows", {dependent, degenerate}, redundant_rows},
      {"dependent but for rounding", {dependent, ill}, rounded_dependent_rows},
      {"near-parallel rows, 1e-4", {ill}, near_parallel_4},
      {"near-parallel rows, 1e-8", {ill, dependent}, near_parallel_8},
      {"near-parallel rows, 1e-12", {ill, dependent}, near_parallel_12},
      {"rows scaled by 1e-8 to 1e8", {}, scaled_rows},
      {"more rows violated than unknowns", {dependent}, many_violated},
      {"whole numbers, independent rows", {degenerate}, whole_independent},
      {"whole numbers, dependent rows", {dependent, degenerate}, whole_dependent},
      {"whole numbers, infeasible", {infeasible, dependent}, whole_infeasible},
      {"infeasible, wedged", {infeasible, dependent}, wedged},
      {"infeasible, simplex turned inside out", {infeasible, dependent}, simplex_turned_out},
      {"chapter 1, block on an obstacle", {}, block_on_obstacle},
      {"chapter 6, cantilever on a foundation", {}, cantilever_on_foundation},
      {"half-plane", {}, half_plane},
      {"half-plane, 1000 pairs", {}, half_plane_large},
      {"string over a wave", {}, string_over_wave},
      {"cycling", {}, cycling},
      {"cycling, asymmetric", {asymmetric}, cycling_asymmetric},
      {"Fathi", {slow}, fathi},
      {"Murty", {asymmetric, slow}, murty},
  };
  return table;
}

}  // namespace signorini_test
