// What a model with friction keeps of the one without, and what is said when friction is not solved.
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "meshes/ring.hpp"
#include "papers/saddle_point_newton.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/hertz.hpp"
#include "support/message.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

Scene rough_beam(double coefficient) {
  Scene scene = cantilever("q4_incompatible", 20, 2);
  scene.contacts[0].friction = Friction{coefficient, 0};
  return scene;
}

std::string complaint(const Scene& scene) {
  return problem_message([&] { static_cast<void>(plan(scene)); });
}

std::string failure(const Scene& scene) {
  return message_of<NotSolved>([&] { static_cast<void>(solved(scene, "the beam")); });
}

}  // namespace

TEST_CASE(
    "programme and condensed problem of a model with friction have slips behind the gaps of that "
    "without",
    "[friction][model]") {
  Ledger ledger;
  const Model rough = build(rough_beam(0.3), ledger);
  const Model smooth = build(rough_beam(0), ledger);
  const Index pairs = smooth.programme.A.rows();
  CHECK(smooth.law.pair.empty());
  REQUIRE(rough.law.pair.size() == static_cast<std::size_t>(pairs));
  REQUIRE(rough.programme.A.rows() == 2 * pairs);  // gaps, then slips
  CHECK((rough.programme.A.topRows(pairs) - smooth.programme.A).norm() == 0);
  CHECK(rough.programme.initial_gap.head(pairs) == smooth.programme.initial_gap);

  // Sums over more rows: equal but for rounding.
  const Condensed with = condense(rough, ledger);
  const Condensed without = condense(smooth, ledger);
  const ContactProblem& same = without.problem;
  CHECK(same.free_slip.size() == 0);
  CHECK((with.problem.compliance.topLeftCorner(pairs, pairs) - same.compliance).norm() <=
        1e-10 * same.compliance.norm());
  CHECK((with.problem.free_gap - same.free_gap).norm() <= 1e-10 * same.free_gap.norm());
  CHECK(with.problem.compliance.rows() == 2 * pairs);

  // A method for gaps alone finds the smooth solution from the first rows.
  QuadraticProgramme gaps_alone = rough.programme;
  gaps_alone.A = NodalRows(rough.programme.A.topRows(pairs));
  gaps_alone.initial_gap = rough.programme.initial_gap.head(pairs);
  const Solution expected = solve(smooth, without, ledger);
  const SaddlePointSolution found = saddle_point_newton(gaps_alone);
  REQUIRE(found.report.status == SolveStatus::Solved);
  CHECK((found.solution.force - expected.contact.force).norm() <=
        1e-10 * expected.contact.force.norm());
}

TEST_CASE("slip rows are those of pairs that can slide and whose own contact rubs",
          "[friction][model]") {
  Ledger ledger;
  Scene scene = rough_beam(0.3);  // its bottom
  scene.contacts.insert(scene.contacts.begin(), {{"top"}, half_plane({0, 6}, {0, -1})});
  const Model model = build(scene, ledger);
  const Index pairs = model.pairs.weight.size();
  const Index frictional_pairs = pairs / 2;
  REQUIRE(pairs == 40);
  REQUIRE(model.law.pair.size() == static_cast<std::size_t>(frictional_pairs));
  CHECK(model.law.pair.front() == frictional_pairs);
  CHECK(model.law.pair.back() == pairs - 1);
  CHECK(model.law.coefficient == Eigen::VectorXd::Constant(frictional_pairs, 0.3));
  CHECK(model.programme.A.rows() == pairs + frictional_pairs);
  CHECK(model.programme.initial_gap.size() == pairs + frictional_pairs);
  CHECK(condense(model, ledger).problem.compliance.rows() == pairs + frictional_pairs);

  // What supports hold along the contact has no slip, and if that is everything there is no friction.
  scene.bodies[0].supports.push_back(prescribed_at("bottom", {25, 0}, Axis::X));
  CHECK(plan(scene).law.pair.size() == static_cast<std::size_t>(frictional_pairs - 1));
  scene.bodies[0].supports.push_back(prescribed("bottom", Axis::X, 0));
  CHECK(plan(scene).law.pair.empty());
  CHECK(plan(scene).solver.solve == scene.solver.solve);
  CHECK(build(scene, ledger).programme.A.rows() == pairs);
}

// On the lines of symmetry of two quarters the tangent at the ends of the contact is held, but for rounding and for the
// normal that a mortar operator takes from the half of the side that is there.
TEST_CASE("a pair on a line of symmetry does not rub, in any unit", "[friction][model][units]") {
  for (const char* name : {"node_to_segment", "mortar"})
    for (const auto& [unit, cells] : std::vector<std::pair<double, Index>>{
             {1e-3, 9}, {1.0, 9}, {7.3, 9}, {25.4, 9}, {1e4, 9}, {1.0, 4}, {1.0, 16}}) {
      CAPTURE(name, unit, cells);
      Scene scene;
      scene.bodies.resize(2);
      for (const bool around : {false, true}) {
        AnnulusSpec spec;
        spec.name = around ? "around" : "inside";
        spec.inner_radius = unit * (around ? 68.15 : 60);
        spec.outer_radius = unit * (around ? 76.15 : 68);
        spec.cells_angle = cells;
        spec.cells_radius = 5;
        spec.sector = Sector::Quarter;
        scene.bodies[around].mesh = make_annulus(spec);
        scene.bodies[around].supports = {symmetric("symmetry"), symmetric("symmetry_y")};
      }
      scene.contacts = {{{"outer", "inside"}, Side{"inner", "around"}}};
      scene.contacts[0].gap_operator = name;
      scene.contacts[0].friction = Friction{0.3, 0};
      const Plan planned = plan(scene);
      CHECK(planned.gaps.pairs.weight.size() == cells + 1);
      CHECK(planned.law.pair.size() == static_cast<std::size_t>(cells - 1));
    }
}

TEST_CASE("a smooth contact beside a rough one has no friction forces", "[friction][model]") {
  Scene scene = rough_beam(0.3);
  scene.contacts.insert(scene.contacts.begin(), {{"top"}, half_plane({0, 6}, {0, -1})});
  const Solution both = solve(scene);
  REQUIRE(both.contact.report.status == SolveStatus::Solved);
  CHECK(both.certificate.holds());
  const ContactState& state = both.contact;
  REQUIRE(state.force.size() == 40);
  REQUIRE(state.friction.size() == 20);  // of the frictional pairs
  CHECK(state.frictional_pairs.front() == 20);
  CHECK(state.force.head(20).isZero(0));  // the beam is pressed down and never touches above
  const Eigen::VectorXd alone = solve(rough_beam(0.3)).contact.friction;
  CHECK((state.friction - alone).norm() <= 1e-10 * alone.norm());
}

TEST_CASE("bodies that float keep their frictionless balance beside that with friction",
          "[friction][model][floating]") {
  Ledger ledger;
  Scene scene = scene_of(HertzProblem());
  const ContactProblem smooth = condense(build(scene, ledger), ledger).problem;
  scene.contacts[0].friction = Friction{0.3, 0};
  const ContactProblem rough = condense(build(scene, ledger), ledger).problem;
  const Eigen::Index pairs = smooth.free_gap.size();
  CHECK((rough.rigid.topRows(pairs) - smooth.rigid).norm() <= 1e-14 * smooth.rigid.norm());
  CHECK((rough.resultant - smooth.resultant).norm() == 0);
  CHECK(rough.rigid.rows() == 2 * pairs - 1);  // the axis keeps one from sliding
}

TEST_CASE("one solver is asked with friction and without", "[friction][model]") {
  Ledger ledger;
  for (const double coefficient : {0.0, 0.3}) {
    const Scene scene = rough_beam(coefficient);
    CHECK(plan(scene).solver.solve == scene.solver.solve);
    const Model model = build(scene, ledger);
    const Solution solution = solve(model, condense(model, ledger), ledger);
    CHECK_NOTHROW(require_solved(solution, "the beam"));
    CHECK(solution.contact.frictional_pairs.empty() == (coefficient == 0));
  }
}

TEST_CASE("friction that is not solved says why", "[friction][model]") {
  Scene scene = rough_beam(0.5);
  scene.solver = find_solver("friction_split_literal");  // fails where a pair opens, see there
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status != SolveStatus::Solved);
  const std::string& reason = solution.contact.reason;
  REQUIRE_FALSE(reason.empty());
  CHECK_THAT(failure(scene), ContainsSubstring("the beam was not solved: breakdown after") &&
                                 ContainsSubstring(reason));
  CHECK_FALSE(solution.certificate.holds());
}

TEST_CASE("a pair that could lock by itself is no reason to warn of other solutions",
          "[friction][model]") {
  for (const double coefficient : {0.3, 3.0}) {  // with 3 it could, under another load
    const Solution solution = solve(rough_beam(coefficient));
    CHECK(solution.contact.uniqueness != Uniqueness::Doubtful);
    CHECK(solution.notes.empty());
  }
}

TEST_CASE("names that nothing needs yet are refused too, and idle choices noted", "[plan][input]") {
  Scene scene = rough_beam(0);
  scene.solver = {};
  CHECK_THAT(complaint(scene), ContainsSubstring("solver and back end must be members"));
  scene = rough_beam(0.3);
  scene.backend = {};
  CHECK_THAT(complaint(scene), ContainsSubstring("solver and back end must be members"));
  scene = rough_beam(0);
  scene.contacts[0].gap_operator = "motar";
  CHECK_THAT(complaint(scene), ContainsSubstring("motar"));

  scene = rough_beam(0);
  CHECK(plan(scene).notes.empty());
  scene.contacts[0].gap_operator = "node_to_segment";
  scene.contacts[0].points = 2;
  REQUIRE(plan(scene).notes.size() == 1);
  CHECK_THAT(plan(scene).notes[0], ContainsSubstring("for a rigid obstacle: gap_operator, points"));

  scene = scene_of(HertzProblem());
  ContactSpec& contact = scene.contacts[0];
  contact.points = 2;
  for (const auto& [name, idle] : {std::pair("mortar", ""), std::pair("gauss_points", "quadrature"),
                                   std::pair("node_to_segment", "points, quadrature")}) {
    CAPTURE(name);
    contact.gap_operator = name;
    contact.quadrature = Quadrature::SourceEdges;
    std::string notes;
    for (const std::string& note : plan(scene).notes)
      if (note.find("without meaning") != std::string::npos) notes += note;
    if (std::string(idle).empty())
      CHECK(notes.empty());
    else
      CHECK_THAT(notes, ContainsSubstring(text(name, ": ", idle)));
  }
}

// Two cylinders of revolution, of 5 cells on 4: the normal of the node on the axis is exact, and a slip there is rounding or
// an error of the mesh. To say that the axis is a line of symmetry says nothing new.
TEST_CASE("a node on the axis does not rub, whether its boundary is called symmetric or not",
          "[friction][axial]") {
  const auto cylinders = [](bool said) {
    Scene scene;
    scene.bodies = {{}, {}};
    scene.bodies[0].mesh = block("a", {0, 0}, {4, 2}, 5, 3);
    scene.bodies[0].material = {1000, 0.3, PlaneState::Axial};
    scene.bodies[0].supports = {fixed("bottom")};
    scene.bodies[1].mesh = block("b", {0, 2}, {4, 2}, 4, 3);
    scene.bodies[1].material = {300, 0.45, PlaneState::Axial};
    scene.bodies[1].loads.edges = {{"top", 10, {}}};
    if (said)
      for (Body& body : scene.bodies) body.supports.push_back(symmetric("left"));
    scene.contacts = {{{"bottom", "b"}, Side{"top", "a"}}};
    scene.contacts[0].friction = Friction{0.1, 0};
    return solved(scene, "the cylinders");
  };
  const SolvedScene one = cylinders(false);
  const SolvedScene other = cylinders(true);
  REQUIRE(one.solution.contact.force.size() == 5);
  CHECK(one.model.law.pair.size() == 4);
  CHECK(one.model.law.pair == other.model.law.pair);
  const double size = one.solution.contact.force.maxCoeff();
  CHECK((one.solution.contact.friction - other.solution.contact.friction).cwiseAbs().maxCoeff() <=
        1e-12 * size);
}
