// Stacks of blocks that contact alone holds: by the entries that are there, and by the dense systems of the methods.
#include "addons/certified/many_bodies.hpp"

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "support/stack.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini_test::brick_wall;
using signorini_test::stack;

namespace {

/// One scene, condensed.
struct Prepared {
  Ledger ledger;
  Model model;
  Condensed condensed;
  explicit Prepared(const Scene& scene)
      : model(build(scene, ledger)), condensed(condense(model, ledger)) {}
};

/// The method of the default alone: it sees the dense problem.
Solver alone() { return primal_dual_active_set().before({}); }

}  // namespace

TEST_CASE("a stack of blocks by its few entries: the same forces after few sets", "[many_bodies]") {
  for (const double friction : {0.0, 0.3}) {
    Prepared scene(stack(26, friction));
    const MatrixXd modes = mode_shapes(scene.model.modes);
    CAPTURE(friction, modes.cols());
    REQUIRE(modes.cols() >= many_motions);
    const CondensedProgramme condensed = condensed_programme(scene.condensed, scene.ledger);
    const auto sparse = many_bodies_solution(scene.model.programme, condensed, modes, {}, scene.ledger);
    REQUIRE(sparse.has_value());
    CHECK(sparse->certificate.worst() <= certificate_tolerance);
    CHECK(sparse->state.report.iterations <= 10);
    const CertifiedSolution dense = certified_solve(scene.model.programme, condensed, modes, alone(),
                                                    {}, scene.ledger);
    REQUIRE(dense.state.report.status == SolveStatus::Solved);
    const double size = largest(dense.solution.force);
    CHECK(largest(VectorXd(sparse->solution.force - dense.solution.force)) <= 1e-9 * size);
    // Where they move to is the same as well, and what of it is rigid.
    CHECK(largest(VectorXd(sparse->solution.displacement - dense.solution.displacement)) <=
          1e-9 * largest(dense.solution.displacement));
    CHECK(largest(VectorXd(modes * (sparse->state.amplitude - dense.state.amplitude))) <=
          1e-9 * largest(VectorXd(modes * dense.state.amplitude)));
    CHECK(sparse->state.contact_status == dense.state.contact_status);
  }
}

TEST_CASE("a stack is solved before anything is condensed, with the forces of the dense systems",
          "[many_bodies]") {
  for (const double friction : {0.0, 0.3}) {
    Prepared scene(stack(26, friction));
    CAPTURE(friction);
    REQUIRE(solved_whole(scene.model));
    const Condensed left = condense_as_needed(scene.model, scene.ledger);
    CHECK(left.problem.compliance.size() == 0);
    CHECK(left.problem.rigid.size() == 0);
    const Solution whole = solve(scene.model, left, scene.ledger);
    CHECK(whole.contact.report.status == SolveStatus::Solved);
    CHECK(whole.certificate.worst() <= certificate_tolerance);
    CHECK(whole.contact.report.iterations <= 10);
    const Solution dense = solve(scene.model, scene.condensed, alone(), scene.ledger);
    REQUIRE(dense.contact.report.status == SolveStatus::Solved);
    const double force = dense.contact.force.maxCoeff();
    CHECK((whole.refined.force - dense.refined.force).cwiseAbs().maxCoeff() <= 1e-10 * force);
    // So are the amplitudes of rigid motions, beside the springs that ground K.
    CHECK((whole.contact.amplitude - dense.contact.amplitude).cwiseAbs().maxCoeff() <=
          1e-8 * dense.contact.amplitude.cwiseAbs().maxCoeff());
    CHECK(whole.notes == dense.notes);
    // Another method has its compliance, though it was left out.
    CHECK(solve(scene.model, left, alone(), scene.ledger).refined.force == dense.refined.force);
  }
}

// Hardly anything resists a tower that leans, so that refining its positions takes more sweeps than its forces do: those are known.
TEST_CASE("a slender tower with friction is solved by its entries, and each block bears what is above", "[many_bodies]") {
  constexpr int blocks = 160;
  const auto name = [](int k) { return "block " + std::to_string(k); };
  Scene scene;
  scene.bodies.clear();
  for (int i = 0; i < blocks; ++i) {
    Body body;
    body.mesh = signorini_test::block({0.01 * (7 * i % 3), static_cast<double>(i)}, {2, 1}, 2);
    body.mesh.name = name(i);
    body.material = {1e4, 0.3};
    body.loads.body_force = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, -1); };
    scene.bodies.push_back(std::move(body));
    ContactSpec contact;
    contact.source = {"bottom", name(i)};
    if (i == 0)
      contact.target = half_plane({0, 0}, {0, 1});
    else
      contact.target = Side{"top", name(i - 1)};
    contact.friction = Friction{0.4};
    scene.contacts.push_back(std::move(contact));
  }
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed left = condense_as_needed(model, ledger);
  REQUIRE(left.problem.compliance.size() == 0);
  const Solution whole = solve(model, left, ledger);
  REQUIRE(whole.contact.report.status == SolveStatus::Solved);
  CHECK(whole.contact.report.iterations <= 10);
  CHECK(whole.ledger.counted("refinement", "solves") <= 2);
  CHECK(whole.ledger.counted("condensation", "operations") == ledger.counted("condensation", "operations"));
  VectorXd borne = VectorXd::Zero(blocks);
  for (Index pair = 0; pair < whole.contact.force.size(); ++pair)
    borne(static_cast<Index>(model.contact_of[static_cast<std::size_t>(pair)])) += whole.contact.force(pair);
  for (int i = 0; i < blocks; ++i) CHECK(borne(i) == Approx(2.0 * (blocks - i)).epsilon(10 * certificate_tolerance));
}

TEST_CASE("few bodies, load steps and other methods are condensed", "[many_bodies]") {
  const auto whole = [](Scene scene) { return solved_whole(plan(scene)); };
  CHECK(whole(stack(26, 0)));
  CHECK_FALSE(whole(stack(10, 0)));
  Scene other = stack(26, 0);
  other.solver = alone();
  CHECK_FALSE(whole(other));
  Scene steps = stack(26, 0);
  steps.path = Path{{1}, {}};
  CHECK_FALSE(whole(steps));
}

TEST_CASE("a load that lifts the top block is refused by the dense method, with its reason",
          "[many_bodies]") {
  Scene scene = stack(26, 0);
  scene.bodies.back().loads.edges = {{"top", -1, {}}};
  scene.bodies.back().loads.points.clear();
  const Solution lifted = solve(scene);
  CHECK(lifted.contact.report.status == SolveStatus::Infeasible);
  CHECK_THAT(lifted.unbounded_direction, ContainsSubstring("block 25"));
  // Where the dense method would be too long, the end says so.
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Index rows = model.programme.A.rows();
  const Condensed left = condense_as_needed(model, ledger);
  CHECK_FALSE(whole_solution(model, left, ledger, rows).has_value());
  const std::optional<CertifiedSolution> lost = whole_solution(model, left, ledger, rows - 1);
  REQUIRE(lost.has_value());
  CHECK(lost->state.report.status == SolveStatus::Breakdown);
  CHECK_THAT(lost->state.reason, ContainsSubstring(std::to_string(rows) + " rows"));
}

TEST_CASE("the condensed problem of a stack has the same forces", "[many_bodies]") {
  for (const double friction : {0.0, 0.3}) {
    Prepared scene(stack(26, friction));
    const ContactProblem& problem = scene.condensed.problem;
    const auto sparse = many_bodies_state(problem, {});
    CAPTURE(friction);
    REQUIRE(sparse.has_value());
    CHECK(certify(problem, *sparse).worst() <= 0.25 * certificate_tolerance);
    const ContactState dense = solve_with_proofs(problem, alone(), {});
    REQUIRE(dense.report.status == SolveStatus::Solved);
    CHECK(largest(VectorXd(sparse->force - dense.force)) <= 1e-9 * largest(dense.force));
    CHECK(sparse->contact_status == dense.contact_status);
    // The statuses of a solution are confirmed by one set.
    SolverOptions options;
    options.start = dense.contact_status;
    const auto again = many_bodies_state(problem, options);
    REQUIRE(again.has_value());
    CHECK(again->report.iterations == 1);
  }
}

TEST_CASE("what no contact holds has no answer by few entries", "[many_bodies]") {
  Scene scene = stack(26, 0);
  scene.bodies.back().loads.edges = {{"top", -1, {}}};  // lifts the top block
  scene.bodies.back().loads.points.clear();
  Prepared prepared(scene);
  CHECK_FALSE(many_bodies_state(prepared.condensed.problem, {}).has_value());
  const CondensedProgramme condensed = condensed_programme(prepared.condensed, prepared.ledger);
  CHECK_FALSE(many_bodies_solution(prepared.model.programme, condensed,
                                   mode_shapes(prepared.model.modes), {}, prepared.ledger)
                  .has_value());
}

TEST_CASE("few bodies and methods that were asked for are left alone", "[many_bodies]") {
  SolverOptions limited;
  limited.iteration_limit = 3;
  CHECK(many_bodies(many_motions, primal_dual_active_set(), {}));
  CHECK_FALSE(many_bodies(many_motions - 1, primal_dual_active_set(), {}));
  CHECK_FALSE(many_bodies(many_motions, primal_dual_active_set(), limited));
  CHECK_FALSE(many_bodies(many_motions, alone(), {}));
}

// Whole sets of pairs go round here. Newton's method ends after some steps; pairs that give way less and less take hundreds of
// factors, of which each costs as much.
TEST_CASE("a wall of bricks with friction is solved after few steps, and bears its weight", "[many_bodies]") {
  const Scene scene = brick_wall(6, 0.5);
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  CHECK(solution.certificate.holds());
  CHECK(solution.contact.report.iterations <= 50);
  Ledger ledger;
  const Model model = build(scene, ledger);
  double onto_the_lowest = 0;
  for (std::size_t pair = 0; pair < model.contact_of.size(); ++pair)
    if (*model.contact_bodies[model.contact_of[pair]].target < 6)
      onto_the_lowest += solution.contact.force(static_cast<Index>(pair));
  CHECK(onto_the_lowest == Approx(30 * 0.5 * 0.1).epsilon(1e-10));
}
