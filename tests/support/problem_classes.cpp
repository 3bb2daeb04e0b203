// The table of problem classes.
#include "support/problem_classes.hpp"

#include "support/classes/classes.hpp"

namespace signorini_test {

const std::vector<ProblemClass>& problem_classes() {
  using signorini::Trait;
  const Trait ordinary = Trait::Ordinary;
  const Trait asymmetric = Trait::Asymmetric;
  const Trait dependent = Trait::Dependent;
  const Trait infeasible = Trait::Infeasible;
  const Trait degenerate = Trait::Degenerate;
  const Trait ill = Trait::IllConditioned;
  const Trait slow = Trait::Slow;
  const Trait several = Trait::Several;
  const Trait friction = Trait::Friction;
  static const std::vector<ProblemClass> table = {
      {"empty", {}, empty_problem},
      {"one pair", {}, one_pair},
      {"two pairs in each of the four states", {several}, two_pairs},
      {"none active", {}, none_active},
      {"all active", {ordinary, several}, all_active},
      {"built backwards", {ordinary, several}, built_backwards},
      {"three unknowns", {ordinary, several}, small_programme},
      {"Rosen-Suzuki, at most as many rows as unknowns", {ordinary, several}, rosen_suzuki_few},
      {"Rosen-Suzuki, more rows than unknowns", {ordinary, dependent, several}, rosen_suzuki_many},
      {"stiff mode, cond(K) up to 1e13", {ordinary, several}, stiff_mode},
      {"two equations", {ordinary, several}, equations},
      {"soft mode, cond(K) 1e6", {ordinary, several}, soft_mode},
      {"weakly active", {ordinary, degenerate, several}, weakly_active},
      {"half of the free gaps zero", {ordinary, degenerate, several}, half_zero},
      {"duplicated rows", {ordinary, dependent, degenerate, several}, duplicated_rows},
      {"redundant rows", {ordinary, dependent, degenerate, several}, redundant_rows},
      {"dependent but for rounding", {ordinary, dependent, ill, several}, rounded_dependent_rows},
      {"near-parallel rows, 1e-4", {ordinary, ill, several}, near_parallel_4},
      {"near-parallel rows, 1e-8", {ordinary, ill, dependent, several}, near_parallel_8},
      {"near-parallel rows, 1e-12", {ordinary, ill, dependent, several}, near_parallel_12},
      {"rows scaled by 1e-8 to 1e8", {ordinary, several}, scaled_rows},
      {"more rows violated than unknowns", {ordinary, dependent, several}, many_violated},
      {"whole numbers, independent rows", {ordinary, degenerate, several}, whole_independent},
      {"whole numbers, dependent rows",
       {ordinary, dependent, degenerate, several},
       whole_dependent},
      {"whole numbers, infeasible", {infeasible, dependent, several}, whole_infeasible},
      {"infeasible, wedged", {infeasible, dependent}, wedged},
      {"infeasible, simplex turned inside out",
       {infeasible, dependent, several},
       simplex_turned_out},
      {"chapter 1, block on an obstacle", {several}, block_on_obstacle},
      {"chapter 6, cantilever on a foundation", {several}, cantilever_on_foundation},
      {"chapter 7, pin in a plate", {ordinary, several}, pin_in_hole_of_a_plate},
      {"chapter 14, lining", {several}, lining_in_rock},
      {"half-plane", {several}, half_plane},
      {"half-plane, many pairs", {several}, half_plane_large},
      {"string over a wave", {ordinary, several}, string_over_wave},
      {"cycling", {ordinary, several}, cycling},
      {"cycling, asymmetric", {ordinary, asymmetric, several}, cycling_asymmetric},
      {"Fathi", {ordinary, slow, several}, fathi},
      {"Murty", {ordinary, asymmetric, slow, several}, murty},
      {"files, generated", {ordinary, slow, several}, generated_files},
      {"Siconos, regular", {ordinary, several}, siconos_regular},
      {"Siconos, semidefinite", {dependent, degenerate}, siconos_semidefinite},
      {"Siconos, asymmetric", {ordinary, asymmetric, slow, several}, siconos_asymmetric},
      {"Siconos, asymmetric and singular",
       {ordinary, asymmetric, dependent, degenerate, several},
       siconos_singular},
      {"Siconos, asymmetric and infeasible",
       {asymmetric, dependent, infeasible},
       siconos_infeasible},
      {"Maros-Meszaros, inequalities", {ordinary, degenerate, several}, maros_meszaros_rows},
      {"Maros-Meszaros, equations",
       {ordinary, dependent, degenerate, ill, several},
       maros_meszaros_equations},
      {"bar on springs", {several}, bar_on_springs},
      {"bar pulled away", {}, bar_pulled_away},
      {"bar, undecided", {ordinary, dependent, degenerate, several}, bar_undecided},
      {"punch", {ordinary, several}, punch},
      {"walls too close", {infeasible, dependent}, walls_too_close},
      {"floating, built backwards", {ordinary, slow, several}, floating_backwards},
      {"friction, one pair", {friction}, friction_one_pair},
      {"friction, moderate", {ordinary, several, friction}, friction_moderate},
      {"friction, strong", {ordinary, several, friction}, friction_strong},
      {"friction, none", {ordinary, several, friction}, friction_none},
      {"friction, of some pairs", {ordinary, several, friction}, friction_of_some},
      {"friction, cohesion", {ordinary, several, friction}, friction_cohesion},
      {"friction, floating", {ordinary, several, friction}, friction_floating},
      {"friction, cylinder", {ordinary, several, friction}, friction_cylinder},
      {"friction, cylinder pushed away", {friction}, friction_cylinder_away},
      {"friction, Siconos", {ordinary, several, friction}, friction_siconos},
  };
  return table;
}

}  // namespace signorini_test
