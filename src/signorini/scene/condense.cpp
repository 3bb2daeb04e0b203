// # Condense
//
// The programme has as many unknowns as the meshes have free components. Contact has only
// its pairs. So displacements are eliminated: \f$ u = K^{-1}(p - A^T\lambda) \f$ turns the
// gaps \f$ g - Au \f$ into
// \f[ \text{gap} = d + G\lambda, \qquad d = g - AK^{-1}p, \qquad G = AK^{-1}A^T. \f]
// By hand: two springs of stiffness 1 in a row are held at the left, a force of 3 pulls the
// right end, and a stop is 1 away from that end:
// \f[ K = \begin{pmatrix} 2 & -1 \\ -1 & 1 \end{pmatrix}, \quad
// K^{-1} = \begin{pmatrix} 1 & 1 \\ 1 & 2 \end{pmatrix}, \f]
// and \f$ A = (0, 1) \f$. Without the stop \f$ u = (3, 6) \f$, so \f$ d = 1 - 6 = -5 \f$,
// and \f$ G = 2 \f$. The gap closes with \f$ \lambda = 2.5 \f$, and \f$ u = (0.5, 1) \f$.
//
// K is factored once. The factor gives d and G, and later each displacement that refinement
// asks for. That is why contact may cost little more than a linear solve: G has as many rows
// as there are pairs and slips.
//
// Where pairs are very many and few of them close, most of G is never looked at. A program
// may have a way to solve that makes the rows which it needs; then G is left to that way. Of many
// bodies on top of each other G is larger than K, and a way may need none of it.
#include <functional>
#include <optional>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/notes.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {
namespace {
using Eigen::Index, Eigen::VectorXd;

// A singular K has a pivot that vanishes. The message must say which node of which body
// moves, not which row.
std::string describe_unknown(const Model& model, Index unknown) {
  std::size_t b = model.bodies.size() - 1;
  while (model.bodies[b].first_unknown > unknown) --b;
  const BodyModel& body = model.bodies[b];
  return text("body '", body.mesh.name, "', ",
              body.unknowns.describe(body.mesh, unknown - body.first_unknown));
}

// K, and one spring per rigid mode, which alone hold the bodies. Without them K is singular
// and has no factor. In balance the springs carry nothing, so that their size does not
// matter.
Factor factor(const Model& model, Ledger& ledger) {
  const Ledger::Phase phase(ledger, "factor");
  const Stiffness K{
      model.programme.stiffness, model.programme.A, [&model] { return unknown_positions(model); },
      [&model](Index unknown) { return describe_unknown(model, unknown); }, grounding(model.modes), model.order};
  return model.backend.factor(K, ledger);
}

// The ledger counts whole operations.
long long one_solve(const Condensed& condensed) {
  return static_cast<long long>(condensed.factor.solve_operations());
}

// G is dense: with 2000 pairs it has 32 MB.
void form_compliance(const Model& model, Condensed& condensed, Ledger& ledger) {
  ContactProblem& problem = condensed.problem;
  problem.compliance = condensed.factor.compliance(model.programme.A, ledger);
  ledger.bytes(problem.compliance.size() * static_cast<long long>(sizeof(double)));
}

// The costs are written into the ledger as they arise. One solve with K is the unit: the
// chapters measure contact by it.
Condensed condensed_unless(LeavesCompliance left, const Model& model, Ledger& ledger) {
  Condensed condensed{with_context(model.notes, [&] { return factor(model, ledger); }), {}, {}};
  const Ledger::Phase phase(ledger, "condensation");
  ledger.count("operations of one solve", one_solve(condensed));
  if (!left(model, condensed.factor)) form_compliance(model, condensed, ledger);
  condensed.problem.law = model.law;
  ledger.count("operations", one_solve(condensed));
  move_freely(model, condensed.factor.solve(model.programme.load), condensed);
  return condensed;
}

}  // namespace

// d and the free slips are what the programme has without contact forces. Load steps change
// p and g, but neither K nor A: they call this once per step, and the factor and G stay.
// Bodies that contact alone holds also get R and r, because r depends on p. They belong to G: who
// has left that to a way has left them, too.
void move_freely(const Model& model, VectorXd free_displacement, Condensed& condensed) {
  const QuadraticProgramme& programme = model.programme;
  ContactProblem& problem = condensed.problem;
  condensed.free_displacement = std::move(free_displacement);
  const VectorXd free =
      gaps(programme, {condensed.free_displacement, {}, VectorXd::Zero(programme.A.rows())});
  const Index slips = static_cast<Index>(model.law.pair.size());
  problem.free_gap = free.head(free.size() - slips);
  problem.free_slip = free.tail(slips);
  if (is_complete(condensed) && !model.modes.empty())
    add_rigid_modes(programme, mode_shapes(model.modes), problem, direction_rounding(model.modes));
}

// Load steps, estimates and those who look at G themselves want all of it.
Condensed condense(const Model& model, Ledger& ledger) {
  return condensed_unless([](const Model&, const Factor&) { return false; }, model, ledger);
}
// One load, and nobody but solve() to ask for G: the way that is set says what it needs.
Condensed condense_as_needed(const Model& model, Ledger& ledger) {
  return condensed_unless(leaves_compliance, model, ledger);
}

// An empty G of three pairs was left out. An empty G of no pairs is all of it.
bool is_complete(const Condensed& condensed) {
  const ContactProblem& problem = condensed.problem;
  return problem.compliance.rows() == problem.free_gap.size() + problem.free_slip.size();
}

// What was left out is made with the factor that is there, and the phase goes on. Rigid motions had
// been left, too.
Condensed completed(const Model& model, Condensed condensed, Ledger& ledger) {
  if (is_complete(condensed)) return condensed;
  const Ledger::Phase phase(ledger, "condensation");
  form_compliance(model, condensed, ledger);
  move_freely(model, condensed.free_displacement, condensed);
  return condensed;
}

// Whoever refines a solution needs a solve with K and must not know the factor. So it gets
// functions, which count what they do. Of some unknowns that K joins with no others, the
// factor may solve alone, which is cheaper.
CondensedProgramme condensed_programme(const Condensed& condensed, Ledger& ledger) {
  const auto counted = [&ledger](double operations, Factor::Solve solve_for) {
    return [&ledger, operations, solve_for = std::move(solve_for)](const VectorXd& load) {
      ledger.count("operations", static_cast<long long>(operations));
      return solve_for(load);
    };
  };
  using Solve = std::function<VectorXd(const VectorXd&)>;
  return {
      condensed.problem, condensed.free_displacement,
      counted(condensed.factor.solve_operations(),
              [&](const Eigen::Ref<const VectorXd>& load) { return condensed.factor.solve(load); }),
      [&condensed, counted](const std::vector<Index>& unknowns) {
        const std::optional<Factor::Part> part = condensed.factor.part(unknowns);
        return part ? Solve(counted(part->solve_operations, part->solve)) : Solve();
      },
      condensed.known.diagonal.size() > 0 ? &condensed.known : nullptr,
      condensed.expected ? &*condensed.expected : nullptr};
}

}  // namespace signorini
