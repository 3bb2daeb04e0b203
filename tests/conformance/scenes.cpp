// Every solver on the road of a scene.
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/scene/scene.hpp"
#include "support/chosen.hpp"
#include "support/hertz.hpp"

using namespace signorini;
using signorini_test::chosen;
using signorini_test::hertz;
using signorini_test::hertz_load;

TEST_CASE("every solver: the same forces between two bodies, of which contact holds one",
          "[conformance][floating]") {
  const std::vector<Solver> members = chosen(solvers());
  if (members.empty()) return;
  HertzMeshSpec spec;
  spec.disc_cells = spec.plate_cells = 8;
  spec.disc_layers = spec.plate_layers = 8;
  Ledger ledger;
  const Model model = build(hertz(spec), ledger);
  const Condensed condensed = signorini::condense(model, ledger);
  const Solution first = solve(model, condensed, primal_dual_active_set(), ledger);
  REQUIRE(first.contact.report.status == SolveStatus::Solved);
  CHECK(first.certificate.holds(1e-14));
  CHECK(first.contact.force.sum() == Approx(hertz_load / 2).epsilon(1e-12));
  for (const Solver& solver : members) {
    if (solver.largest > 0 && solver.largest < first.contact.force.size()) continue;
    INFO(solver.name);
    const Solution other = solve(model, condensed, solver, ledger);
    if (other.contact.report.status != SolveStatus::Solved) {
      CHECK(may_fail(solver, Trait::Several));
      continue;
    }
    CHECK((other.contact.force - first.contact.force).norm() <= 1e-12 * first.contact.force.norm());
    CHECK(other.contact.amplitude(0) == Approx(first.contact.amplitude(0)).epsilon(1e-12));
  }
}
