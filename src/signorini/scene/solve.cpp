// # Solve, recover
//
// The small problem has free gaps d and the compliance G of all pairs.
// [condense.cpp](condense.cpp) has made it. What a solver finds holds for d and G, which are
// rounded. So the forces are refined with K, p, A and g as they were posed, and the certificate
// measures those. Only then is the answer called a solution.
//
// In the example of that page d = -5 and G = 2. A solver finds the force 2.5 and the gap 0. What
// a user wants to see comes back from it: \f$ u = K^{-1}(p - A^T\lambda) = (0.5, 1) \f$.
//
// How it is solved is a choice of the program. The library has one way, solve_plainly(). An
// add-on may put another one into a slot, which knows more of hard cases, and every solve()
// below asks what the slot holds.
#include <cmath>
#include <optional>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/scene/balance.hpp"
#include "signorini/scene/checks.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/notes.hpp"
#include "signorini/scene/scene.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/refined_solve.hpp"

namespace signorini {
namespace {
using Eigen::VectorXd;

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
// link that method, it calls what this slot holds. The method may want to make G itself.
struct Way {
  SolveCondensed solve = solve_plainly;
  LeavesCompliance leaves = nullptr;
};
Way& way() {
  static Way now;
  return now;
}
// An add-on with equations may need several solutions for one: it asks the way again and again.
// A tie that carries tension is one example: its rows press from the one side or the other, and
// which, is only known when a solution is there.
SolveAround& around() {
  static SolveAround now = nullptr;
  return now;
}
}  // namespace

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
    if (solved && !model.loop) check_solution(model, condensed, solution);
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
// A program sets its way once, at its beginning. No solve() below knows solve_plainly() by
// name, so that a program that has set another way cannot get the old one by mistake. With the
// way goes what it wants to be left of G: condense_as_needed() asks for that.
void set_solve(SolveCondensed another, LeavesCompliance leaves) { way() = {another, leaves}; }
bool leaves_compliance(const Model& model, const Factor& factor) {
  return way().leaves != nullptr && way().leaves(model, factor);
}
void set_solve_around(SolveAround another) { around() = another; }
// Chapters that compare methods name the solver. All others take that of the scene.
Solution solve(const Model& model, const Condensed& condensed, const Solver& solver, Ledger ledger,
               const SolverOptions& options) {
  if (model.equations && around() != nullptr)
    return around()(way().solve, model, condensed, solver, std::move(ledger), options);
  return way().solve(model, condensed, solver, std::move(ledger), options);
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

// The three stages of the library. Load steps need a loop around the last one.
Solution solve(const Scene& scene) {
  require_input(!scene.path, "the scene has load steps: solve_steps() solves it step by step");
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense_as_needed(model, ledger);
  return solve(model, condensed, std::move(ledger));
}
}  // namespace signorini
