// # Condense, solve, recover
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
// What the solver finds holds for the condensed problem, whose d and G are rounded. So the
// forces are refined with K, p, A and g as they were posed, and the certificate measures
// those. Only then is the answer called a solution.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "signorini/contact/gaps.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/scene/balance.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/checks.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/notes.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/scene/scene.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/refined_solve.hpp"

namespace signorini {
namespace {
using Eigen::Index;
using Eigen::VectorXd;

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

// Held components come back here: users know nodes, and the solution has unknowns.
std::vector<NodeArray> displacements_of_bodies(const Model& model, const VectorXd& displacement) {
  const NodeArray all = expand(model.unknowns, displacement);
  std::vector<NodeArray> bodies;
  for (const BodyModel& body : model.bodies)
    bodies.emplace_back(all.middleRows(body.first_node, body.mesh.n_nodes()));
  return bodies;
}

// With friction a load may be too large for any balance. Then the useful answer is how much
// of it would be held. A proof that nothing holds beyond, and a search that found nothing,
// are different sentences.
std::string limit_in_words(const Solution& solution) {
  const std::optional<double>& limit = solution.limit;
  if (!limit) return {};
  if (solution.unbounded_direction.empty())
    return text("Grown from nothing in proportion, ", *limit,
                " of this load is held, and nothing is found beyond");
  if (*limit == 0)
    return "Friction holds no part of this load, however small, because it grows with the load. ";
  return text("Friction holds at most ", *limit, " of this load. ");
}
// A program may put another method in the place of solve_plainly(). The library does not
// link that method, it calls what this slot holds.
SolveCondensed& way() {
  static SolveCondensed now = solve_plainly;
  return now;
}
// An add-on with equations may need several solutions for one: it asks the way again and again.
SolveAround& around() {
  static SolveAround now = nullptr;
  return now;
}
// The ledger counts whole operations.
long long one_solve(const Condensed& condensed) {
  return static_cast<long long>(condensed.factor.solve_operations());
}

}  // namespace

// d and the free slips are what the programme has without contact forces. Load steps change
// p and g, but neither K nor A: they call this once per step, and the factor and G stay.
// Bodies that contact alone holds also get R and r, because r depends on p.
void move_freely(const Model& model, VectorXd free_displacement, Condensed& condensed) {
  const QuadraticProgramme& programme = model.programme;
  ContactProblem& problem = condensed.problem;
  condensed.free_displacement = std::move(free_displacement);
  const VectorXd free =
      gaps(programme, {condensed.free_displacement, {}, VectorXd::Zero(programme.A.rows())});
  const Index slips = static_cast<Index>(model.law.pair.size());
  problem.free_gap = free.head(free.size() - slips);
  problem.free_slip = free.tail(slips);
  if (!model.modes.empty())
    add_rigid_modes(programme, mode_shapes(model.modes), problem, direction_rounding(model.modes));
}

// The costs are written into the ledger as they arise. One solve with K is the unit: the
// chapters measure contact by it.
Condensed condense(const Model& model, Ledger& ledger) {
  Condensed condensed{with_context(model.notes, [&] { return factor(model, ledger); }), {}, {}};
  const Ledger::Phase phase(ledger, "condensation");
  ledger.count("operations of one solve", one_solve(condensed));
  ContactProblem& problem = condensed.problem;
  problem.compliance = condensed.factor.compliance(model.programme.A, ledger);
  ledger.bytes(problem.compliance.size() * static_cast<long long>(sizeof(double)));
  problem.law = model.law;
  ledger.count("operations", one_solve(condensed));
  move_freely(model, condensed.factor.solve(model.programme.load), condensed);
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
      condensed.known.diagonal.size() > 0 ? &condensed.known : nullptr};
}

// From unknowns to what is looked at: pressures, displacements of nodes, the balance of what
// is told. Checks look at solutions only: notes on the strains of an unsolved problem would
// mislead. They may withdraw one, as where pairs have slid off the sides that they faced. An
// iteration of a loop is no solution yet, and the loop asks them at its end. Unsolved numbers are still recovered, because a figure of them may show what went
// wrong. If nothing could be refined there are no displacements, and only the report is returned.
// A scene whose nodes are all held has no displacements either, but it is solved.
Solution recovered(const Model& model, const Condensed& condensed, RefinedEnd end,
                   std::vector<std::string> notes, Ledger ledger) {
  Solution solution;
  solution.notes = std::move(notes);
  solution.contact = std::move(end.state);
  solution.certificate = end.certificate;
  const bool solved = solution.contact.report.status == SolveStatus::Solved;
  if (solved || end.solution.displacement.size() > 0) {
    const Ledger::Phase phase(ledger, "recovery");
    solution.pressure = solution.contact.force.cwiseQuotient(model.pairs.weight);
    solution.certificate.balance = imbalance(model, solution.contact, end.solution.force);
    solution.displacements = displacements_of_bodies(model, end.solution.displacement);
    solution.refined = std::move(end.solution);
    if (solved && !model.loop) judge_solution(model, condensed, solution);
  }
  solution.ledger = std::move(ledger);
  return solution;
}
// The forces of a solver claim to be a solution. refined_solve() makes displacements of them
// that fit the original K, p, A and g, and certifies the result.
Solution solve_plainly(const Model& model, const Condensed& condensed, const Solver& solver,
                       Ledger ledger, const SolverOptions& options) {
  RefinedEnd end = in_these_units(condensed.problem, [&] {
    return refined_solve(model.programme, condensed_programme(condensed, ledger),
                         mode_shapes(model.modes), solver, options, ledger);
  });
  return recovered(model, condensed, std::move(end), model.notes, std::move(ledger));
}
// Every solve() below asks the slot, so that a program that has set another way cannot get
// the old one by mistake.
void set_solve(SolveCondensed another) { way() = another; }
void set_solve_around(SolveAround another) { around() = another; }
// Chapters that compare methods name the solver. All others take that of the scene.
Solution solve(const Model& model, const Condensed& condensed, const Solver& solver, Ledger ledger,
               const SolverOptions& options) {
  if (model.equations && around() != nullptr)
    return around()(way(), model, condensed, solver, std::move(ledger), options);
  return way()(model, condensed, solver, std::move(ledger), options);
}
Solution solve(const Model& model, const Condensed& condensed, Ledger ledger) {
  return solve(model, condensed, model.solver, std::move(ledger));
}
// The reason of the solver, the motion that is left and the share of the load that is held
// are known in different places. This puts them into one sentence. If the load pulls a body
// away, the sentence ends with what to do.
std::string why_unsolved(const Solution& solution) {
  const std::string& reason = solution.contact.reason;
  if (solution.unbounded_direction.empty() && !solution.limit) return reason;
  if (solution.unbounded_direction.empty())
    return text(reason, reason.empty() ? "" : ". ", limit_in_words(solution));
  return text(reason.empty() ? "the load pulls a body away from all it could rest on" : reason,
              ": ", solution.unbounded_direction, ". ", limit_in_words(solution),
              "Turn the load round or add a support");
}

// Programs of the chapters stop here. An unsolved problem must not become a number in a
// table. The message has the status, the reason and the certificate, so that nobody has to
// run again to see them.
void require_solved(const Solution& solution, const std::string& what) {
  const Report& report = solution.contact.report;
  if (report.status == SolveStatus::Solved) return;
  const std::string reason = why_unsolved(solution);
  if (!solution.unbounded_direction.empty())
    throw NotSolved(with_notes(text(what, " was not solved: ", reason), solution.notes));
  std::string message = text(what, " was not solved: ", to_string(report.status), " after ",
                             report.iterations, " iterations");
  if (!reason.empty()) message += ": " + reason;
  if (std::isfinite(solution.certificate.worst()))
    message += text("; certificate: ", solution.certificate);
  throw NotSolved(with_notes(message, solution.notes));
}

// The road of the library in three steps. Load steps need a loop around the last one.
Solution solve(const Scene& scene) {
  require_input(!scene.path, "the scene has load steps: solve_steps() solves it step by step");
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  return solve(model, condensed, std::move(ledger));
}
}  // namespace signorini
