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
  const Trait several = Trait::Several;
  static const std::vector<ProblemClass> table = {
      {"empty", {}, empty_problem},
      {"one pair", {}, one_pair},
      {"two pairs in each of the four states", {several}, two_pairs},
      {"none active", {}, none_active},
      {"all active", {several}, all_active},
      {"built backwards", {several}, built_backwards},
      {"Rosen-Suzuki, at most as many rows as unknowns", {several}, rosen_suzuki_few},
      {"Rosen-Suzuki, more rows than unknowns", {dependent, several}, rosen_suzuki_many},
      {"stiff mode, cond(K) up to 1e13", {several}, stiff_mode},
      {"soft mode, cond(K) 1e6", {several}, soft_mode},
      {"weakly active", {degenerate, several}, weakly_active},
      {"half of the free gaps zero", {degenerate, several}, half_zero},
      {"duplicated rows", {dependent, degenerate, several}, duplicated_rows},
      {"redundant rows", {dependent, degenerate, several}, redundant_rows},
      {"dependent but for rounding", {dependent, ill, several}, rounded_dependent_rows},
      {"near-parallel rows, 1e-4", {ill, several}, near_parallel_4},
      {"near-parallel rows, 1e-8", {ill, dependent, several}, near_parallel_8},
      {"near-parallel rows, 1e-12", {ill, dependent, several}, near_parallel_12},
      {"rows scaled by 1e-8 to 1e8", {several}, scaled_rows},
      {"more rows violated than unknowns", {dependent, several}, many_violated},
      {"whole numbers, independent rows", {degenerate, several}, whole_independent},
      {"whole numbers, dependent rows", {dependent, degenerate, several}, whole_dependent},
      {"whole numbers, infeasible", {infeasible, dependent, several}, whole_infeasible},
      {"infeasible, wedged", {infeasible, dependent}, wedged},
      {"infeasible, simplex turned inside out",
       {infeasible, dependent, several},
       simplex_turned_out},
      {"chapter 1, block on an obstacle", {several}, block_on_obstacle},
      {"chapter 6, cantilever on a foundation", {several}, cantilever_on_foundation},
      {"half-plane", {several}, half_plane},
      {"half-plane, many pairs", {several}, half_plane_large},
      {"string over a wave", {several}, string_over_wave},
      {"cycling", {several}, cycling},
      {"cycling, asymmetric", {asymmetric, several}, cycling_asymmetric},
      {"Fathi", {slow, several}, fathi},
      {"Murty", {asymmetric, slow, several}, murty},
  };
  return table;
}

}  // namespace signorini_test
