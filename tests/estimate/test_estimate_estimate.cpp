#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "addons/estimate/contact_edges.hpp"
#include "addons/estimate/contact_ends.hpp"
#include "addons/estimate/estimate.hpp"
#include "addons/estimate/mesh_refinement.hpp"
#include "addons/estimate/profile.hpp"
#include "catch_compat.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/readings.hpp"
#include "support/effectivity.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

namespace {

std::vector<Estimate> estimated(const SolvedScene& run, const std::vector<Goal>& goals) {
  Ledger ledger;
  return estimates(run.model, run.condensed, run.solution, goals, ledger);
}

/// Estimated over true error.
double effectivity(const Estimate& estimate, double truth) {
  const double error = truth - estimate.value;
  return estimate.error / (estimate.is_signed ? error : std::abs(error));
}

/// A block on a flat, pressed evenly and free to spread: its stress is uniform.
Scene pressed(const std::string& element) {
  const Element& cell = find_element(element);
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block_for(cell, {2, 1}, 4, 3);
  body.element = element;
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = {symmetric("left")};
  body.loads.edges = {{"top", 10, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

}  // namespace

TEST_CASE("a solution that is exact has no error", "[estimate][closed-form]") {
  const char* element = GENERATE("q4", "q4_bbar", "q4_incompatible", "q8", "t3", "t6");
  CAPTURE(element);
  const SolvedScene run = solved(pressed(element), "block");
  const std::vector<Estimate> all =
      estimated(run, {{"normal_force", NormalForce{}},
                      {"part", NormalForce{"", [](const Eigen::Vector2d& x) { return x.x(); }}},
                      {"top", Displacement{"", Axis::Y, "top"}},
                      {"side", Displacement{"", Axis::X, "right"}}});
  CHECK(all[0].value == Approx(20).epsilon(1e-12));
  CHECK(all[2].value == Approx(-10 * (1 - 0.09) / 1000).epsilon(1e-12));
  for (const Estimate& one : all) {
    CAPTURE(one.goal);
    CHECK(std::abs(one.error) <= 1e-11 * std::abs(one.value));
    CHECK(one.algebraic <= 1e-12 * std::abs(one.value));
  }
}

TEST_CASE("what a goal overlooks between the nodes is what makes it right", "[goal][closed-form]") {
  // The integral of x^2 times an even pressure: nodal forces see chords of the parabola.
  const SolvedScene run = solved(pressed("q4"), "block");
  const Goal moment{"moment",
                    NormalForce{"", [](const Eigen::Vector2d& x) { return x.x() * x.x(); }}};
  const double read = value(run.model, run.solution, moment);
  CHECK(read > 10 * 8.0 / 3 * 1.01);
  CHECK(read + quadrature_error(run.model, run.solution, moment) ==
        Approx(10 * 8.0 / 3).epsilon(1e-12));

  // The forces of an ellipse of pressure on nodes: their fit is too flat.
  SolvedScene hertz_run = solved(measured_hertz().scene("q4", 12), "Hertz");
  const Goal peak{"peak", PeakPressure{}};
  const ContactLine line = line_of(hertz_run.model, "", {0, 0});
  const auto pressure = [](double x) { return 25 * std::sqrt(std::max(0.0, 1 - x * x)); };
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    double& force = hertz_run.solution.contact.force(line.pair[k]);
    force = 0;
    const auto side = [&](std::size_t other) {
      const double way = line.x[other] - line.x[k];
      for (const GaussPoint& gauss : gauss_line(16)) {
        const double t = (1 + gauss.xi) / 2;
        force += gauss.weight / 2 * std::abs(way) * (1 - t) * pressure(line.x[k] + t * way);
      }
    };
    if (k > 0) side(k - 1);
    if (k + 1 < line.x.size()) side(k + 1);
  }
  const double flat = value(hertz_run.model, hertz_run.solution, peak);
  const double right = flat + quadrature_error(hertz_run.model, hertz_run.solution, peak);
  CHECK(std::abs(right - 25) < 0.2 * std::abs(flat - 25));
}

TEST_CASE("the free boundary: the cubic through three ends of the contact",
          "[estimate][closed-form]") {
  const SolvedScene run = solved(measured_cantilever().scene("q4", 30), "cantilever");
  const std::vector<Index>& active = run.solution.contact.active();
  const Index pairs = run.solution.contact.gap.size();
  const ScaledProblem scaled = equilibrate(run.condensed.problem);
  struct Closed {
    double sum;
    Eigen::VectorXd force, movement;
  };
  const auto closed = [&](std::vector<Index> set) {
    std::sort(set.begin(), set.end());
    const ActiveSetSolution solution = solve_active_set(scaled, statuses_of(set, pairs));
    return Closed{solution.force.cwiseProduct(scaled.scale).sum(), solution.force,
                  solution.movement};
  };
  // The beam lies on its tip: contact ends at one place only.
  std::vector<Index> more = active, fewer = active;
  const bool first = active.back() == pairs - 1;
  REQUIRE(active.back() - active.front() + 1 == static_cast<Index>(active.size()));
  REQUIRE((first || active.front() == 0));
  const Index last = first ? active.front() : active.back(), next = first ? last - 1 : last + 1;
  more.push_back(next);
  fewer.erase(first ? fewer.begin() : fewer.end() - 1);
  const Closed here = closed(active), out = closed(more), in = closed(fewer);
  const double energy_out = -here.movement(next) * out.force(next);
  const double energy_in = -in.movement(last) * here.force(last);
  const double ratio = std::sqrt(energy_out / energy_in);  // (1/2 - t) / (1/2 + t)
  const double t = (1 - ratio) / (1 + ratio) / 2;
  // Of the polynomial s, s^2, s^3: its values one pair out and in, and its slope at t.
  Eigen::Matrix3d rows;
  rows << 1, 1, 1, -1, 1, -1, 1, 2 * t, 3 * t * t;
  const Eigen::Vector3d a =
      rows.fullPivLu().solve(Eigen::Vector3d(out.sum - here.sum, in.sum - here.sum, 0));
  const Estimate one = estimated(run, {measured_cantilever().goals[0]}).front();
  REQUIRE(std::abs(one.parts.free_boundary) > 1e-6 * one.value);
  CHECK(one.parts.free_boundary == Approx(t * (a(0) + t * (a(1) + t * a(2)))).epsilon(1e-8));
}

TEST_CASE("the free boundary: what the half-width by moments lacks where the end is not at b",
          "[estimate][closed-form]") {
  // A parabola pressed into a half-plane that may touch to e only: b by the second moment is b sqrt(2 e^2 - e^4), e in b.
  const auto J = [](double e) { return std::sqrt(2 * e * e - e * e * e * e); };
  const double h = GENERATE(0.05, 0.1), t = GENERATE(-0.4, -0.2, 0.3, 0.5);
  CAPTURE(h, t);
  const double e = 1 - t * h;
  const ContactEnd end{0, 1, -1, -1, t};
  const double V = free_boundary(end, J(e) - J(e + h), J(e - h) - J(e));
  CHECK(V == Approx(1 - J(e)).epsilon(3 * h * h));
}

TEST_CASE("around its end contact is left to the free boundary", "[estimate]") {
  const SolvedScene run = solved(measured_hertz().scene("q4", 12), "Hertz");
  const Dual dual(run.model, run.condensed, run.solution);
  const std::vector<ContactEnd> ends = contact_ends(contact_edges(run.model), run.solution, dual);
  REQUIRE(ends.size() == 1);
  CHECK(std::abs(ends[0].offset) <= 0.5);
  const Index first = run.model.pairs.node[static_cast<std::size_t>(ends[0].closed)];
  for (const BodyModel& body : run.model.bodies) {  // the meshes match: one node of each
    const Eigen::VectorXd away = away_from_ends(ends, run.model, body);
    const Eigen::RowVector2d end = run.model.pairs.position.row(ends[0].closed);
    for (Index cell = 0; cell < away.size(); ++cell) {
      bool around = false;
      for (Index k = 0; k < body.mesh.cell_size(cell); ++k) {
        const Index node = body.mesh.cells(cell, k);
        around =
            around || body.first_node + node == first ||
            (&body != &source_of(run.model, ends[0].closed) &&
             std::abs(body.mesh.nodes(node, 0) - end.x()) < 1e-3 && body.mesh.nodes(node, 1) == 0);
      }
      CHECK(away(cell) == Approx(around ? 0 : 1).margin(1e-9));
    }
  }
}

// Truths: cells of eight nodes, four times as many along each side as on the finest mesh here. They differ from those of
// half as many by 3e-5 (cantilever), 1e-4 (footing), 6e-6 (pin), 1e-4 (push).
TEST_CASE("forces and displacements: estimated over true error is between a half and two",
          "[estimate][effectivity]") {
  struct Case {
    Measured problem;
    Index cells;
    std::vector<double> truth;
  };
  const Case now = GENERATE(Case{measured_cantilever(), 50, {71.6256, -0.801041}},
                            Case{measured_push(), 16, {21.8976}},
                            Case{measured_footing(), 15, {16.3999, -5.283997e-3}},
                            Case{measured_pin(), 48, {1.386732, 233.0827}});
  const char* element = GENERATE("q4", "q4_bbar", "t3");
  CAPTURE(now.problem.name, element);
  const SolvedScene run = solved(now.problem.scene(element, now.cells), now.problem.name);
  const std::vector<Estimate> all = estimated(run, now.problem.goals);
  for (std::size_t k = 0; k < all.size(); ++k) {
    CAPTURE(all[k].goal, all[k].value, all[k].error, now.truth[k]);
    CHECK(all[k].is_signed);
    CHECK(effectivity(all[k], now.truth[k]) >= 0.5);
    CHECK(effectivity(all[k], now.truth[k]) <= 2);
  }
}

// Truths: as above, with friction; they differ from those of half or two thirds as many cells by 3e-4 (force of the footing)
// and less.
TEST_CASE("where pairs slide against friction estimates are as good", "[estimate][effectivity]") {
  struct Case {
    Measured problem;
    Index cells;
    double friction;
    std::vector<double> truth;
  };
  const Case now = GENERATE(Case{measured_cantilever(), 50, 0.02, {71.6214, -0.801068}},
                            Case{measured_footing(), 18, 0.1, {16.6242, -5.250875e-3}},
                            Case{measured_pin(), 72, 0.2, {1.328580, 223.8545}});
  const char* element = GENERATE("q4", "q4_bbar", "t3");
  CAPTURE(now.problem.name, element);
  Scene scene = now.problem.scene(element, now.cells);
  scene.contacts[0].friction = Friction{now.friction};
  const SolvedScene run = solved(scene, now.problem.name);
  const std::vector<Estimate> all = estimated(run, now.problem.goals);
  for (std::size_t k = 0; k < all.size(); ++k) {
    CAPTURE(all[k].goal, all[k].value, all[k].error, now.truth[k]);
    CHECK(effectivity(all[k], now.truth[k]) >= 0.5);
    CHECK(effectivity(all[k], now.truth[k]) <= 2);
  }
}

TEST_CASE("half-width and peak of Hertz: the size of the error within a factor of two",
          "[estimate][effectivity][closed-form]") {
  HertzProblem theory;
  const double half_width = hertz_half_width(theory.theory());
  const double peak = hertz_peak_pressure(theory.theory());
  const SolvedScene run = solved(measured_hertz().scene("q4", GENERATE(12, 16)), "Hertz");
  const std::vector<Estimate> all = estimated(run, measured_hertz().goals);
  CHECK(!all[0].is_signed);
  for (const double e : {effectivity(all[0], half_width), effectivity(all[1], peak)}) {
    CHECK(e >= 0.5);
    CHECK(e <= 2);
  }
}

TEST_CASE("half-widths: most estimates are good, and none is too small",
          "[estimate][effectivity]") {
  struct Case {
    const char* element;
    int good;  // of 10
    double most;
  };
  const Case now = GENERATE(Case{"q4", 10, 2}, Case{"t3", 10, 2}, Case{"q4_incompatible", 7, 3});
  CAPTURE(now.element);
  const std::vector<double> truth = {hertz_half_width(HertzProblem{}.theory())};
  int good = 0;
  for (const HertzMeshSpec& spec : hertz_layouts({14, 18})) {
    const Measurement one = measured(hertz(spec, now.element), {{"b", HalfWidth{}}}, truth).front();
    CAPTURE(one.estimate.value, one.estimate.error);
    CHECK(one.effectivity() >= 0.5);
    CHECK(one.effectivity() <= now.most);
    good += one.good() ? 1 : 0;
  }
  CHECK(good >= now.good);
}

TEST_CASE("estimates follow the units, and repeat to the bit", "[estimate][property]") {
  HertzProblem problem;
  problem.mesh = [] {
    HertzMeshSpec spec;
    spec.disc_cells = spec.plate_cells = spec.disc_layers = spec.plate_layers = 8;
    spec.disc_rows = spec.plate_rows = 6;
    return spec;
  }();
  HertzProblem other = problem;
  other.length = 1e3;
  other.force = 1e-6;
  const std::vector<Goal> goals = measured_hertz().goals;
  const SolvedScene run = solved(scene_of(problem), "Hertz");
  const std::vector<Estimate> here = estimated(run, goals);
  const std::vector<Estimate> again = estimated(run, goals);
  const std::vector<Estimate> there = estimated(solved(scene_of(other), "Hertz"), goals);
  const double units[] = {1e3, 1e-12, 1e3, 1e3};
  for (std::size_t k = 0; k < goals.size(); ++k) {
    CAPTURE(goals[k].name);
    CHECK(here[k].error == again[k].error);
    CHECK(there[k].error == Approx(units[k] * here[k].error).epsilon(1e-7));
    double sum = 0;
    for (const Eigen::VectorXd& body : here[k].share) sum += body.sum();
    CHECK(sum == Approx(here[k].parts.interior).epsilon(1e-12));
  }
}

TEST_CASE("nothing is factored or solved for an estimate but two right-hand sides", "[estimate]") {
  const SolvedScene run = solved(measured_cantilever().scene("q4", 20), "cantilever");
  Ledger ledger;
  const Estimate one =
      estimate(run.model, run.condensed, run.solution, measured_cantilever().goals[1], ledger);
  CHECK(one.goal == "deflection");
  CHECK(ledger.counted("estimate", "solves") == 2);
  for (const LedgerEntry& entry : ledger.entries())
    CHECK(entry.path.find("factor") == std::string::npos);
}

TEST_CASE("one contact of two feet is estimated as two contacts", "[estimate]") {
  Scene two = pressed("q4");
  Mesh& mesh = two.bodies[0].mesh;
  mesh = refined_mesh(refined_mesh(mesh));
  const std::vector<CellSide> bottom = mesh.boundaries.at(two.contacts[0].source.boundary);
  const std::ptrdiff_t third = static_cast<std::ptrdiff_t>(bottom.size() / 3);
  const std::vector<CellSide> left(bottom.begin(), bottom.begin() + third);
  const std::vector<CellSide> right(bottom.end() - third, bottom.end());
  mesh.boundaries["left foot"] = left;
  mesh.boundaries["right foot"] = right;
  mesh.boundaries["feet"] = left;
  mesh.boundaries["feet"].insert(mesh.boundaries["feet"].end(), right.begin(), right.end());
  const double R = 80;
  two.contacts[0].target =
      profile([&](double x) { return -x * x / (2 * R); }, [&](double x) { return -x / R; });
  Scene one = two;
  one.contacts[0].source.boundary = "feet";
  two.contacts.push_back(two.contacts[0]);
  two.contacts[0].source.boundary = "left foot";
  two.contacts[1].source.boundary = "right foot";
  const SolvedScene together = solved(one, "feet");
  const SolvedScene apart = solved(two, "foot and foot");
  const std::vector<ContactEdge> edges = contact_edges(together.model);
  CHECK(edges.size() == contact_edges(apart.model).size());
  CHECK(edges.size() == left.size() + right.size());
  const auto part = [](const SolvedScene& run) {
    return gap_between_nodes(run.model, contact_edges(run.model), run.model.pairs.weight);
  };
  CHECK(part(together) == Approx(part(apart)).epsilon(1e-12).margin(0));
}

TEST_CASE("what a parabola lies below its chords is the part of the gap",
          "[estimate][closed-form]") {
  // A block over y = x^2 / 2R: g'' = -1/R, and of the dual pressure 1 everywhere R has h^2 / 12 times the length.
  Scene scene = pressed("q4");
  const double R = 80;
  scene.contacts[0].target =
      profile([&](double x) { return -x * x / (2 * R); }, [&](double x) { return -x / R; });
  const SolvedScene run = solved(scene, "block on a hill");
  const double part =
      gap_between_nodes(run.model, contact_edges(run.model), run.model.pairs.weight);
  const double h = 0.5;
  CHECK(part == Approx(-h * h / 12 / R * 2).epsilon(1e-3));  // the normals turn a little
}

TEST_CASE("what no estimate is promised for is refused by name", "[estimate]") {
  const auto said = [](const Scene& scene, const Goal& goal) {
    const SolvedScene run = solved(scene, "scene");
    return problem_message([&] { (void)estimated(run, {goal}); });
  };
  const Goal force{"normal_force", NormalForce{}};
  HertzProblem gauss;
  gauss.gap_operator = "gauss_points";
  gauss.mesh.disc_cells = gauss.mesh.plate_cells = 8;
  CHECK_THAT(said(scene_of(gauss), force), ContainsSubstring("Gauss points"));
  Scene poked = measured_cantilever().scene("q4", 20);
  poked.bodies[0].loads.points = {{{50, 5}, {0, -1}}};
  CHECK_THAT(said(poked, {"tip", Displacement{"", Axis::Y, "", {{50, 5}}}}),
             ContainsSubstring("point force"));
  SolvedScene stepped = solved(measured_cantilever().scene("q4", 20), "cantilever");
  stepped.model.path.times = {1};
  CHECK_THAT(problem_message([&] { (void)estimated(stepped, {force}); }),
             ContainsSubstring("load steps"));
  SolvedScene unsolved = solved(measured_cantilever().scene("q4", 20), "cantilever");
  unsolved.solution.contact.report.status = SolveStatus::Breakdown;
  CHECK_THAT(problem_message([&] { (void)estimated(unsolved, {force}); }),
             ContainsSubstring("not solved"));
}

TEST_CASE("an error budget keeps apart what can be estimated and what cannot", "[estimate]") {
  Estimate one{"force", 10, {0.3, 0.02, 0.01, -0.1, 0.07}, 0.3, true, 1e-14, {}, {}, {}};
  const std::vector<BudgetLine> budget = error_budget(one, {10.5, {}});
  REQUIRE(budget.size() == 6);
  CHECK(budget[0].amount.value() == 1e-14);
  CHECK(budget[1].amount.value() == Approx(0.03));
  CHECK(budget[2].amount.value() == Approx(0.2));
  CHECK(budget[3].amount.value() == Approx(0.07));
  CHECK(budget[4].amount.value() == Approx(0.5));
  CHECK(!budget[5].amount);
  CHECK(one.parts.sum() == Approx(0.3));
  CHECK(one.parts.sizes() == Approx(0.5));
  CHECK(one.parts.norm() == Approx(std::sqrt(0.1054)));
}
