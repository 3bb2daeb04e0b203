/// \file
/// Load steps: one factor for a whole path, and friction that remembers.
///
/// K, the factor, the compliance and the rigid modes do not change along a path, but for the compliance of bodies that
/// move and, of those with a law, K and its factor, see StepLoop. What changes is linear in the
/// histories: p, g and \f$ K^{-1}p \f$ are sums of parts, each condensed once. So a step costs the triangular solves
/// of its refinement and dense algebra on the boundary, and begins from what the pairs did last.
///
/// If all loads go on in one proportion, u and forces do too, until a pair changes. So from the third step on, of bodies that stay, that
/// supports hold and no bond joins, a step is first looked for on the line through the last two. If its forces close all gaps there but for
/// rounding, and its certificate is a tenth of what it may be, it needs no solve with K. Else it is solved as any other.
///
/// The law of friction holds for the slip since the last step: \f$ s_k = s(t_k) + T u_k - s_{k-1} \f$, where
/// \f$ s_{k-1} \f$ is the slip in total before. A pair that sticks keeps its total to the last bit. Friction of a node
/// that supports drag along acts on them alone: at its bound while they move, none while they stand, where it could be
/// anything up to the bound.
#pragma once
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "addons/steps/histories.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// A model whose loads follow histories, with all unknowns but the contact forces eliminated.
struct CondensedPath {
  Condensed condensed;  ///< at the time that was set last
  /// `n` K^-1 times the load of each part of the model [length]
  std::vector<Eigen::VectorXd> free_displacement;
};

/// Where a path is after some steps: all that the next step has to know, and what a step found.
struct PathState {
  Eigen::Index steps = 0;  ///< done so far, halves of steps counted
  double time = 0;         ///< of the last one [time]
  /// `n_c` what all pairs do; empty before the first step
  std::vector<ContactStatus> contact_status = {};
  Eigen::VectorXd slip = {};  ///< `n_s` in total, of the source along the tangent [length]
  /// `n_s` since the step before [length]; exactly 0 of a pair that sticks
  Eigen::VectorXd increment = {};
  /// `n_s` sum over the steps of |tau| |increment| [force*length], >= 0
  Eigen::VectorXd dissipation = {};
  /// Of bodies that move, for each contact: what nodes dissipated until they lost their pair [force*length]; empty: none did
  Eigen::VectorXd dissipated_elsewhere = {};
  PrimalDual solution = {};  ///< u in two parts and forces of all rows of A, of the last step
  double began = 0;  ///< when the last step began [time]
  /// How far u went in it, in two parts, and by how much the forces of all rows grew; empty behind the first step, where loads turned,
  /// and without pairs. Of bodies that move u alone, in one part
  PrimalDual way = {};
};

/// A step of a path.
struct Step {
  Solution solution;  ///< its slips are those since the step before
  PathState state;    ///< after it if the step was solved, else before it
};

/// Called with the model as loaded at the time of the step, and a step that was solved.
using StepObserver = std::function<void(const Model& model, const Step& step)>;

/// How a path ended.
struct PathEnd {
  PathState state;  ///< after the last step that was solved
  /// `Solved` if the last time was reached, else that of the step that failed
  SolveStatus status = SolveStatus::Solved;
  /// in words, if it was not reached: where, why, and where to go on from
  std::string reason = {};
  Eigen::Index halvings = 0;  ///< how many steps failed and were tried half as long
  /// From which time on the loads are more than contact and friction can hold [time], if that was found: `Infeasible`
  /// proves that nothing balances them beyond, see Solution::limit; else nothing was found 1e-10 of the step beyond
  std::optional<double> limit = {};
};

/// Condenses a model and each part of its loads.
/// \param model   from build() of a scene with load steps
/// \param ledger  receives the phases `factor` and `condensation`
/// \return what step() needs
/// \throws ProblemError as condense(), or if the scene has no load steps
[[nodiscard]] CondensedPath condense_path(const Model& model, Ledger& ledger);

/// Loads a model as its histories say.
/// \param time  any [time]
/// \param model  from build() of a scene with load steps; gets p, g and the loads, temperatures and given
///   displacements of its bodies at that time
void set_time(double time, Model& model);

/// Loads a model as at the time of a state and, if its bodies move, places their pairs where they stood then.
/// \param state  of a path
/// \param model  from build() of a scene with load steps
/// \throws ProblemError if bodies of the model cannot stand there
void stand(const PathState& state, Model& model);

/// \param state  of a path, or null
/// \return its sums, as tables and files of the step want them; nothing of null
[[nodiscard]] std::optional<PathTotals> totals(const PathState* state);

/// Goes one step. Slip counts from the step before, in the place of the slip of \PaperEq{LinEtAl, 8}.
/// \param past    where the path is
/// \param time    where the step ends, beyond `past.time` [time]
/// \param model   gets the loads of that time; g of the slips counts from `past`
/// \param path    from condense_path() of it
/// \param ledger  goes on in the solution; pass an empty one to know what the step alone cost
/// \return the solution, see solve(), and where the path then is
/// \throws ProblemError unless the time is beyond `past.time`, or if the state has other numbers of pairs or slips
///   than the model
[[nodiscard]] Step step(const PathState& past, double time, Model& model, CondensedPath& path,
                        Ledger ledger);

/// Whether a state can be gone on from.
/// \param state  of a path
/// \param model  from build() of a scene with load steps; gets the loads of the time of the state
/// \throws ProblemError unless the state solves its own step of this model
void check_state(const PathState& state, Model& model);

/// Goes along the path of a scene. A step that is not solved is tried half as long, and again, as often as the path
/// allows; then the path ends there, with the last state that was good. A step that is `SlidTooFar` or `TurnedTooFar` is not
/// halved and ends it.
///
/// Loads beyond what friction can hold are followed to their limit. If it is proved that nothing balances the loads of a
/// step, the next one goes as far as they can be balanced, less 1e-10 of the step. Without a proof, after the halvings,
/// the change of a pair that ends what was solved last is foreseen, as forces are linear in the loads until then; one
/// step goes so far, and one 1e-10 of the step further. If that fails, this is the limit, else the path goes on. A path
/// that allows no halvings takes no steps but its own. Of bodies that move, forces are not linear in the loads: no change is
/// foreseen and no limit told.
/// \param scene    with load steps
/// \param observe  called after every step that was solved, halves too; may be empty
/// \param from     where to go on, as an observer or read_state() got it: every number is then that of the path that was
///   never interrupted
/// \return the end; check its status
/// \throws ProblemError as build() and condense(), if the scene has no load steps, or if `from` is not of this scene
[[nodiscard]] PathEnd solve_steps(const Scene& scene, const StepObserver& observe = {},
                                  const PathState& from = {});

/// The same with what a scene was made into.
/// \param model    from build(); then has the loads of the step that was tried last
/// \param path     from condense_path() of it
/// \param ledger   of both, goes on in the first step; every later step has one of its own
/// \param observe  as above
/// \param from     as above, through check_state()
/// \return the end; check its status
/// \throws ProblemError as step()
[[nodiscard]] PathEnd solve_steps(Model& model, CondensedPath& path, Ledger ledger,
                                  const StepObserver& observe, const PathState& from);

/// Writes a state as text, every number with the digits that give back its bits.
/// \param state  of a path
/// \param out    where to
void write_state(const PathState& state, std::ostream& out);

/// Reads what write_state() wrote.
/// \param content  of the file
/// \param name     of the file, for messages
/// \return the state, bit by bit
/// \throws ProblemError with the line where the text is something else
[[nodiscard]] PathState read_state(const std::string& content, const std::string& name);

/// Where the work of the loads went: sums over the steps so far [force*length].
///
/// Between two steps all forces and displacements are taken to change in proportion, so that the work of a force is its
/// mean times the displacement. Then \f$ work = strain + dissipation + between \f$ holds to rounding for any path.
struct Work {
  double loads = 0;  ///< done by loads and temperatures, the forces of temperatures taken as loads
  double supports = 0;     ///< done by given displacements
  double contacts = 0;     ///< done by interferences that grow
  double strain = 0;       ///< energy stored in bodies and springs
  double dissipation = 0;  ///< |tau| |increment| of all pairs, as in PathState::dissipation
  /// What a step does not resolve, \f$ \tfrac12(\tau_k - \tau_{k-1})\Delta s \f$ of pairs that begin to slide
  /// within it and \f$ \tfrac12(\lambda_k\,gap_{k-1} - \lambda_{k-1}\,gap_k) \f$ of pairs that close or open: it
  /// vanishes with the size of the steps, and where no pair changes within one.
  double between = 0;

  /// \return what loads, supports and contacts put in
  [[nodiscard]] double put_in() const { return loads + supports + contacts; }
};

/// Adds up the work along a path, as an observer. It costs about one assembly per step.
class WorkMeter {
 public:
  /// \param model  as loaded at the time of the step
  /// \param step   the next one, the first time step 1 of the path
  /// \throws ProblemError if the steps before the first one that is added are missing, as after a restart, or if bodies move
  void add(const Model& model, const Step& step);
  /// \return the sums so far, from rest without loads
  [[nodiscard]] const Work& work() const { return work_; }

 private:
  struct Body {
    NodeArray displacement;
    NodeArray load;     // of loads and temperature
    NodeArray support;  // what holds it, where it is held
  };
  // Adds the work of loads and supports; returns the displacements of all nodes.
  Eigen::VectorXd add_bodies(const Model& model, const Step& step);

  Work work_;
  std::vector<Body> bodies_;
  Eigen::VectorXd force_;  // of all rows
  Eigen::VectorXd gap_;
  Eigen::VectorXd interference_;
};

}  // namespace signorini
