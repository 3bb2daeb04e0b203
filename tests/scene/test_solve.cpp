#include <cmath>
#include <limits>
#include <sstream>

#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/scene.hpp"
#include "support/cantilever.hpp"
#include "support/message.hpp"
#include "support/random.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::cantilever;

TEST_CASE("a plan says what is on and what is off, without assembling", "[plan]") {
  const Scene scene = cantilever("q4_incompatible", 50, 5);
  const Plan found = plan(scene);
  CHECK(found.unknowns.count == 2 * 51 * 6 - 2 * 6);
  CHECK(found.gaps.A.rows() == 50);  // the corner at the clamp cannot move
  CHECK(found.quality[0].largest_aspect_ratio == Approx(1).epsilon(1e-12));
  CHECK(found.notes.empty());
  std::ostringstream out;
  out << found;
  CHECK_THAT(out.str(),
             ContainsSubstring("on    body 'beam': 250 cells q4_incompatible") &&
                 ContainsSubstring("on    load on 'top'") &&
                 ContainsSubstring("on    contact of 'bottom' of 'beam' with a rigid half plane") &&
                 ContainsSubstring("off   body force"));
}

TEST_CASE("what is absent is off", "[plan]") {
  Scene scene = cantilever("q4", 10, 2);
  scene.contacts.clear();
  scene.bodies[0].loads = {};
  const Plan found = plan(scene);
  std::vector<std::string> names;
  for (const Effect& effect : effects()) names.emplace_back(effect.name);
  CHECK(found.off == names);
  CHECK(found.gaps.A.rows() == 0);
}

TEST_CASE("a plan warns of an element that will lock and of overlap before loading", "[plan]") {
  Scene scene = cantilever("q4", 10, 2);
  scene.bodies[0].material.state = PlaneState::Strain;
  scene.bodies[0].material.poisson_ratio = 0.4999;
  REQUIRE(plan(scene).notes.size() == 1);
  CHECK_THAT(plan(scene).notes[0], ContainsSubstring("q4 locks") && ContainsSubstring("q4_bbar"));
  scene.bodies[0].element = "q4_bbar";
  CHECK(plan(scene).notes.empty());
  scene.contacts[0].target = disc({40, -10}, 10.5);
  REQUIRE(plan(scene).notes.size() == 1);
  CHECK_THAT(plan(scene).notes[0], ContainsSubstring("overlap by 0.5"));
}

TEST_CASE("displacements that are given are no overlap of the meshes", "[plan]") {
  Scene scene = cantilever("q4", 10, 2);
  const double under = scene.bodies[0].mesh.nodes.col(1).minCoeff();
  for (const double overlap : {0.0, 0.25}) {
    CAPTURE(overlap);
    scene.contacts[0].target = half_plane({0.6 * overlap, under + 0.8 * overlap}, {0.6, 0.8});
    scene.bodies[0].supports = {prescribed("top", Axis::X, 0), prescribed("bottom", Axis::Y, -0.125)};
    const std::vector<std::string> notes = plan(scene).notes;
    REQUIRE(notes.size() == (overlap > 0 ? 1 : 0));
    if (overlap > 0) CHECK_THAT(notes[0], ContainsSubstring("overlap by 0.25 before loading"));
  }
}

TEST_CASE("sides that touch but for the rounding of positions do not overlap", "[plan]") {
  Scene scene = cantilever("q4", 10, 2);
  scene.bodies[0].mesh = moved(scene.bodies[0].mesh, {0, 0.3});
  for (const double rounding : {0.0, 1e-16, 1e-10}) {
    CAPTURE(rounding);
    scene.contacts[0].target = half_plane({0, 0.3 + rounding}, {0, 1});
    scene.bodies[0].supports = {prescribed("left", Axis::X, 0)};
    CHECK(plan(scene).notes.empty() == (rounding < 1e-12));
  }
}

TEST_CASE("building a plan searches no pairs and has no need of the scene", "[plan][ledger]") {
  int asked = 0;
  const auto height = [&asked](double) { return static_cast<void>(++asked), -1.0; };
  Scene scene = cantilever("q4", 10, 2);
  scene.contacts[0].target = profile(height, [](double) { return 0.0; });
  Plan planned = plan(scene);
  const int once = asked;
  CHECK(once > 0);
  scene = {};
  Ledger ledger;
  const Model copied = build(planned, ledger);
  const Model moved = build(std::move(planned), ledger);
  CHECK(asked == once);
  CHECK(copied.programme.A.rows() == 10);
  CHECK((copied.programme.A - moved.programme.A).norm() == 0);
  CHECK((copied.programme.stiffness - moved.programme.stiffness).norm() == 0);
  REQUIRE(ledger.entries().size() == 1);
  CHECK(ledger.entries()[0].path == "assembly");
  CHECK(ledger.entries()[0].calls == 2);

  scene = cantilever("q4", 10, 2);
  scene.contacts[0].target = profile(height, [](double) { return 0.0; });
  asked = 0;
  const Model both = build(scene, ledger);
  CHECK(asked == once);
  CHECK(ledger.entries().back().path == "plan");
}

TEST_CASE("a solution carries the notes of the plan", "[plan][solve]") {
  Scene scene = cantilever("q4", 10, 2);
  scene.contacts[0].target = disc({40, -10}, 10.5);
  const std::vector<std::string> notes = plan(scene).notes;
  REQUIRE(notes.size() == 1);
  CHECK(solve(scene).notes == notes);
}

TEST_CASE("one factorisation of the stiffness serves the whole solution", "[ledger]") {
  const Solution solution = solve(cantilever("q4_incompatible", 50, 5));
  long long factorisations = 0;
  for (const LedgerEntry& entry : solution.ledger.entries())
    if (entry.path == "factor/numeric") factorisations += entry.calls;
  CHECK(factorisations == 1);
  CHECK(solution.ledger.counted("factor/numeric", "nonzeros") > 600);
  CHECK(solution.ledger.counted("assembly", "unknowns") == 600);
  CHECK(solution.ledger.counted("assembly", "pairs") == 50);
  CHECK(solution.ledger.counted("refinement", "solves") > 1);
  CHECK(solution.ledger.counted("refinement", "solves") <= 5);
  CHECK(solution.contact.report.iterations <= 30);  // of 50 pairs
}

TEST_CASE("the gap in a solution is that of the displaced nodes", "[solve][XuanLi2002-13]") {
  const Scene scene = cantilever("q4_incompatible", 50, 5);
  const Solution solution = solve(scene);
  const Pairs pairs = plan(scene).gaps.pairs;
  for (Index pair = 0; pair < solution.contact.gap.size(); ++pair) {
    const Index node = pairs.node[static_cast<std::size_t>(pair)];
    CHECK(solution.contact.gap(pair) ==
          Approx(1 + solution.displacements[0](node, 1)).epsilon(0).margin(1e-14));
    CHECK(solution.pressure(pair) ==
          Approx(solution.contact.force(pair) / pairs.weight(pair)).epsilon(1e-15).margin(0));
  }
}

TEST_CASE("both solvers give the same solution of a small scene", "[solve]") {
  Scene scene = cantilever("q4_incompatible", 12, 2);
  const Solution fast = solve(scene);
  scene.solver = find_solver("enumerate");
  const Solution sure = solve(scene);
  CHECK(fast.contact.active() == sure.contact.active());
  CHECK_FALSE(fast.contact.active().empty());
  CHECK((fast.contact.force - sure.contact.force).norm() < 1e-13 * sure.contact.force.norm());
}

TEST_CASE("a body pressed into a disc, a hole and a wave is certified", "[solve]") {
  const auto wave = profile([](double x) { return -1.5 + 0.4 * std::cos(x); },
                            [](double x) { return -0.4 * std::sin(x); });
  for (const Obstacle& obstacle : {disc({40, -6}, 5), hole({30, 400}, 402), wave}) {
    CAPTURE(obstacle.name);
    Scene scene = cantilever("q4_incompatible", 60, 6);
    scene.contacts[0].target = obstacle;
    const Solution solution = solve(scene);
    CHECK(solution.contact.report.status == SolveStatus::Solved);
    CHECK_FALSE(solution.contact.active().empty());
    CHECK(solution.certificate.worst() <= 1e-12);
  }
}

TEST_CASE("a body force alone acts like a pressure of the same weight", "[solve]") {
  Scene weight = cantilever("q4_incompatible", 50, 5);
  weight.bodies[0].loads = {[](const Eigen::Vector2d&) { return Eigen::Vector2d(0, -3.6 / 5); },
                            {}};
  const Solution solution = solve(weight);
  CHECK(solution.certificate.holds());
  // Where on the section the load acts changes the local stress, not the beam: a few thousandths.
  CHECK(solution.contact.force.sum() ==
        Approx(solve(cantilever("q4_incompatible", 50, 5)).contact.force.sum()).epsilon(0.01));
}

TEST_CASE("a set of closed pairs that wrong condensed data suggest is corrected", "[solve]") {
  const Scene scene = cantilever("q4_incompatible", 50, 5);
  Ledger ledger;
  const Model model = build(scene, ledger);
  Condensed condensed = condense(model, ledger);
  const Solution right = solve(model, condensed, scene.solver, ledger);
  condensed.problem.free_gap.array() += 2;  // as if the foundation were 2 cm further away
  const Solution corrected = solve(model, condensed, scene.solver, ledger);
  REQUIRE(corrected.contact.report.status == SolveStatus::Solved);
  CHECK(corrected.contact.active() == right.contact.active());
  CHECK((corrected.contact.force - right.contact.force).norm() <
        1e-12 * right.contact.force.norm());
  CHECK(corrected.certificate.holds());
}

TEST_CASE("a body all of whose nodes are held is where they are held", "[solve]") {
  Scene scene = cantilever("q4", 4, 1);  // has no node inside
  scene.contacts.clear();
  const auto field = [](const Eigen::Vector2d& x) {
    return Eigen::Vector2d(1e-3 * x.x(), 2e-3 * x.y());
  };
  Body& body = scene.bodies[0];
  body.supports.clear();
  for (const auto& [name, sides] : body.mesh.boundaries)
    body.supports.push_back({name, true, true, field});
  const Solution solution = solve(scene);
  CHECK(solution.contact.report.status == SolveStatus::Solved);
  CHECK(solution.certificate.holds());
  CHECK(solution.refined.displacement.size() == 0);
  REQUIRE(solution.displacements.size() == 1);
  REQUIRE(solution.displacements[0].rows() == body.mesh.n_nodes());
  for (Index k = 0; k < body.mesh.n_nodes(); ++k)
    CHECK(solution.displacements[0].row(k).transpose() ==
          field(body.mesh.nodes.row(k).transpose()));

  scene.path = Path{};
  scene.path->times = {1, 2};
  int steps = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    WorkMeter meter;
    if (++steps == 1) meter.add(model, step);
    CHECK(step.solution.displacements == solution.displacements);
  });
  CHECK(end.status == SolveStatus::Solved);
  CHECK(steps == 2);
}

TEST_CASE("a program that needs a solution stops without one and says why", "[solve]") {
  Solution solution = solve(cantilever("q4", 10, 2));
  CHECK_NOTHROW(require_solved(solution, "the beam"));
  solution.contact.report.status = SolveStatus::IterationLimit;
  solution.contact.report.iterations = 12;
  CHECK_THAT(signorini_test::message_of<NotSolved>([&] { require_solved(solution, "the beam"); }),
             ContainsSubstring("the beam was not solved: iteration limit after 12 iterations"));
}

TEST_CASE(
    "no admissible displacement has less energy, and the inequality holds towards all of them",
    "[solve][XuanLi2002-7][XuanLi2002-8][XuanLi2002-9][XuanLi2002-10]") {
  const Scene scene = cantilever("q4_incompatible", 24, 3);
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Solution solution = solve(model, condense(model, ledger), scene.solver, ledger);
  const QuadraticProgramme& programme = model.programme;
  const Eigen::VectorXd& u = solution.refined.displacement;
  const auto energy = [&](const Eigen::VectorXd& w) {
    return 0.5 * w.dot(programme.stiffness * w) - programme.load.dot(w);
  };
  const Eigen::VectorXd force = programme.stiffness * u - programme.load;
  const Eigen::VectorXd rounding =  // of each entry of it: a row of K has at most 18 terms
      18 * std::numeric_limits<double>::epsilon() *
      (programme.stiffness.cwiseAbs() * u.cwiseAbs() + programme.load.cwiseAbs());
  Random random(17);
  int outside = 0;
  for (int sample = 0; sample < 100; ++sample) {
    Eigen::VectorXd w = u;
    for (Eigen::Index i = 0; i < w.size(); ++i) w(i) += 0.1 * random.uniform(-1, 1);
    outside += force.dot(w - u) < 0 ? 1 : 0;
    // Back along the normals, which are unit vectors of different nodes.
    w -= programme.A.transpose() * (programme.A * w - programme.initial_gap).cwiseMax(0.0);
    CHECK(force.dot(w - u) > -rounding.dot((w - u).cwiseAbs()));  // 0 where closed nodes stay
    CHECK(energy(w) > energy(u));
  }
  CHECK(outside > 10);  // the inequality says something: it fails for displacements that overlap
}
