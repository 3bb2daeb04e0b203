// What a user hardly meant is told: by an error, or by a note that nothing loses.
#include <algorithm>
#include <cmath>

#include "addons/checks/warnings.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/notes.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/doubtful_scenes.hpp"
#include "support/loose_meshes.hpp"
#include "support/message.hpp"
#include "support/random_scenes.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Of each note that a sound scene does not have.
const char* const warnings[] = {
    "loose pieces",           "coincide with others",    "hang on the side",
    "zero everywhere",        "no force and no moment",  "no node of the boundary faces",
    "can open or close",      "lie behind the target",   "no pair carries a force",
    "deformations for small", "forces of single pairs",  "straight edges of the target",
    "has closed a gap of",    "is thick there",          "Where the bodies have moved to",
    "do not balance, by",     "has no share of the side"};

bool has_all(const std::string& line, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(), [&line](const std::string& word) {
    return line.find(word) != std::string::npos;
  });
}

bool tells(const std::vector<std::string>& notes, const std::vector<std::string>& words) {
  return std::any_of(notes.begin(), notes.end(),
                     [&words](const std::string& note) { return has_all(note, words); });
}

std::string lines(const std::vector<std::string>& notes) {
  std::string all;
  for (const std::string& note : notes) all += note + '\n';
  return all;
}

}  // namespace

TEST_CASE("a doubtful scene is told, a sound one is not", "[warnings]") {
  for (const DoubtfulScene& doubtful : doubtful_scenes()) {
    CAPTURE(doubtful.mistake);
    const auto planned = [&] { return plan(doubtful.scene).notes; };
    const auto solved = [&] { return solve(doubtful.scene).notes; };
    if (doubtful.said == Said::Error) {
      const std::string error = problem_message(planned);
      CAPTURE(error);
      CHECK(has_all(error, doubtful.words));
      CHECK(problem_message(solved) == error);
    } else {
      const std::vector<std::string> before = planned();
      const Solution after = solve(doubtful.scene);
      CAPTURE(lines(before), lines(after.notes));
      REQUIRE(after.contact.report.status == SolveStatus::Solved);
      CHECK(tells(before, doubtful.words) == (doubtful.said == Said::Plan));
      CHECK(tells(after.notes, doubtful.words));
      REQUIRE(after.notes.size() >= before.size());
      CHECK(std::equal(before.begin(), before.end(), after.notes.begin()));
    }
    const Solution sound = solve(doubtful.sound);
    CAPTURE(lines(sound.notes));
    CHECK(sound.contact.report.status == SolveStatus::Solved);
    for (const char* warning : warnings) CHECK_FALSE(tells(sound.notes, {warning}));
  }
}

TEST_CASE("doubts have the same words in other units, but for the numbers of places",
          "[warnings]") {
  for (const double pressure : {3.6, 360.0, 3.6e6}) {
    const auto kinds = [&](const Units& units) {
      const std::vector<std::string> notes =
          solve(cantilever("q4_incompatible", 20, 2, pressure, units)).notes;
      std::vector<std::string> found;
      for (const char* word : {"strain ", "rotation ", "pressure ", "units"})
        if (tells(notes, {word})) found.emplace_back(word);
      return found;
    };
    CAPTURE(pressure);
    const std::vector<std::string> usual = kinds({});
    CHECK(usual.empty() == (pressure == 3.6));
    CHECK(kinds({1e-6, 1e6}) == usual);
    CHECK(kinds({1e3, 1e-3}) == usual);
  }
}

// u = (x, y) G^T: every strain measure has a closed form, on cells of any shape.
TEST_CASE("strain and rotation of a linear displacement are exact on distorted cells",
          "[warnings]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    Scene scene;
    Body& body = scene.bodies[0];
    body.mesh = mapped(named_block("block", {3, 5}, {4, 2}, 4, 3, order), [](const Vector2d& x) {
      return Vector2d(x.x() + 0.1 * x.y() * x.y(), x.y() + 0.05 * x.x() * x.y());
    });
    body.element = order == MeshOrder::Linear ? "q4_incompatible" : "q8";
    body.material = {1000, 0.3, PlaneState::Stress, 1};
    body.supports = {fixed("left")};
    Ledger ledger;
    const Model model = build(scene, ledger);
    Solution solution = solve(model, condense(model, ledger), ledger);
    const Eigen::Matrix2d G = (Eigen::Matrix2d() << 0.03, 0.05, -0.01, -0.02).finished();
    solution.displacements[0] = body.mesh.nodes * G.transpose();
    const double strain = 0.005 + std::hypot(0.025, 0.02);
    const double rotation = 0.03 * 180 / pi;
    for (const double factor : {1 - 1e-9, 1 + 1e-9}) {
      const auto notes = [&](const SmallLimits& limits) {
        return solution_warnings(model, solution, limits);
      };
      CHECK(notes({factor * strain, 90, 1}).empty() == (factor > 1));
      CHECK(notes({1, factor * rotation, 1}).empty() == (factor > 1));
    }
  }
}

TEST_CASE("in axial symmetry a hoop strain counts", "[warnings]") {
  Scene scene = signorini_test::cantilever("q4_incompatible", 4, 2);
  scene.contacts.clear();
  Ledger ledger;
  Model model = build(scene, ledger);
  Solution solution = solve(model, condense(model, ledger), ledger);
  solution.displacements[0].setZero();
  solution.displacements[0].col(0).setConstant(1);  // at the radii 0 to 50
  CHECK(solution_warnings(model, solution).empty());
  model.bodies[0].material.base.state = PlaneState::Axial;
  CHECK(tells(solution_warnings(model, solution), {"strain 16 %", "cell 0"}));  // at 6.25
}

TEST_CASE("the pressure is compared with the softer body, whichever side it is", "[warnings]") {
  for (const std::size_t soft : {0, 1}) {
    Scene scene = two_blocks(named_block("lower", {-1, -1}, {2, 1}, 4, 2),
                             named_block("upper", {-1, 0}, {2, 1}, 4, 2));
    scene.bodies[soft].material.youngs_modulus = 1;
    scene.bodies[1].supports = {prescribed_at("top", {-1, 1}, Axis::X)};
    scene.bodies[1].loads.edges = {{"top", 0.2, {}}};
    CAPTURE(soft);
    CHECK(tells(solve(scene).notes, {"contact pressure 0.2"}));
    Body& body = scene.bodies[soft];  // a soft core under a hard skin is not pressed
    Material hard = body.material;
    hard.youngs_modulus = 1000;
    const Index skin = soft == 0 ? 1 : 0;  // two rows of four cells
    for (Index k = 0; k < 4; ++k) body.mesh.regions["skin"].push_back(4 * skin + k);
    body.layers = {{"skin", hard}};
    CHECK_FALSE(tells(solve(scene).notes, {"contact pressure"}));
  }
}

TEST_CASE("faces of a crack that may touch are meant", "[warnings]") {
  const Mesh mesh = split_block(0.5, 2);
  Scene scene;
  scene.bodies[0].mesh = mesh;
  scene.bodies[0].material = {1000, 0.3, PlaneState::Strain, 1};
  scene.bodies[0].supports = {fixed("bottom"), fixed("bottom2")};
  scene.bodies[0].loads.edges = {{"left", 1, {}}};
  CHECK(tells(plan(scene).notes, {"3 nodes coincide"}));
  // The boundaries go on below the tip, where the halves share their nodes: of each the upper part is meant.
  Mesh& own = scene.bodies[0].mesh;
  const auto above = [&own](std::vector<CellSide> sides) {
    sides.erase(std::remove_if(sides.begin(), sides.end(),
                               [&own](const CellSide& side) {
                                 for (const Index node : own.side_nodes(side))
                                   if (own.nodes(node, 1) < 1) return true;
                                 return false;
                               }),
                sides.end());
    return sides;
  };
  own.boundaries["right"] = above(own.boundaries["right"]);
  own.boundaries["left2"] = above(own.boundaries["left2"]);
  scene.contacts = {{{"right"}, Side{"left2"}}};
  scene.contacts[0].gap_operator = "node_to_segment";
  const Solution solution = solve(scene);
  CHECK(solution.contact.report.status == SolveStatus::Solved);
  CHECK(solution.contact.force.sum() > 0);
  CAPTURE(lines(solution.notes));
  for (const char* warning : warnings) CHECK_FALSE(tells(solution.notes, {warning}));
}

TEST_CASE("pressure around a closed boundary has no resultant and is meant", "[warnings]") {
  Scene scene;
  AnnulusSpec ring;
  ring.cells_angle = 24;
  Body& body = scene.bodies[0];
  body.mesh = make_annulus(ring);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.supports = {prescribed_at("outer", {2, 0}, Axis::Y),
                   prescribed_at("outer", {-2, 0}, Axis::Y),
                   prescribed_at("outer", {-2, 0}, Axis::X)};
  body.loads.edges = {{"inner", 1, {}}};
  CHECK(plan(scene).notes.empty());
  body.loads.edges = {{"inner", 0, [](const Vector2d& x) { return Vector2d(x.normalized()); }}};
  CHECK(plan(scene).notes.empty());
  body.loads.edges = {{"inner", 0, {}}};
  CHECK(tells(plan(scene).notes, {"load on 'inner' of", "zero everywhere"}));
}

TEST_CASE("what lies on the axis has no area to be pressed on", "[warnings]") {
  Scene scene = cantilever("q4", 4, 2);
  Body& body = scene.bodies[0];
  body.material.state = PlaneState::Axial;
  body.supports = {prescribed_at("bottom", {0, 0}, Axis::Y)};
  scene.contacts.clear();
  body.loads.edges = {{"left", 1, {}}};
  CHECK(tells(plan(scene).notes, {"load on 'left' of", "does nothing: it lies on the axis"}));
  body.loads.edges = {{"right", 1, {}}};
  CHECK(plan(scene).notes.empty());
}

TEST_CASE("contacts that share sides are one contact twice, those that share a node are not",
          "[warnings]") {
  Scene scene = cantilever("q4_incompatible", 20, 2);
  const double all = solve(scene).contact.force.sum();
  Mesh& mesh = scene.bodies[0].mesh;
  const std::vector<CellSide> bottom = mesh.boundaries.at("bottom");
  scene.contacts.push_back(scene.contacts[0]);
  const auto split = [&](std::ptrdiff_t first_end, std::ptrdiff_t second_begin) {
    mesh.boundaries["one"] = {bottom.begin(), bottom.begin() + first_end};
    mesh.boundaries["two"] = {bottom.begin() + second_begin, bottom.end()};
    scene.contacts[0].source.boundary = "one";
    scene.contacts[1].source.boundary = "two";
  };
  split(15, 14);
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene)); }),
             ContainsSubstring("contacts 1 and 2") && ContainsSubstring("'two' of 'beam'"));
  split(15, 15);
  CHECK(solve(scene).contact.force.sum() == Approx(all).epsilon(1e-10));
  split(20, 0);  // between two walls
  scene.contacts[1].target = half_plane({0, -2}, {0, 1});
  CHECK_NOTHROW(plan(scene));
}

TEST_CASE("an error tells the notes as well", "[warnings]") {
  Scene scene = cantilever("q4", 10, 2);
  scene.bodies[0].material.state = PlaneState::Strain;
  scene.bodies[0].material.poisson_ratio = 0.45;
  REQUIRE(plan(scene).notes.size() == 1);
  const std::string note = ". Note: " + plan(scene).notes[0];
  Scene loose = scene;
  loose.bodies[0].supports.clear();
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(loose)); }), ContainsSubstring(note));
  Scene infinite = scene;
  infinite.bodies[0].loads.body_force = [](const Vector2d&) { return Vector2d(0, 1 / 0.0); };
  CHECK_THAT(problem_message([&] { static_cast<void>(solve(infinite)); }), ContainsSubstring(note));
  Solution solution = solve(scene);
  solution.contact.report.status = SolveStatus::IterationLimit;
  CHECK_THAT(message_of<NotSolved>([&] { require_solved(solution, "the beam"); }),
             ContainsSubstring("was not solved") && ContainsSubstring(note));
}

// Bodies, loads and contacts of random scenes are sound; how large their loads are is left to chance.
TEST_CASE("random scenes raise no doubt but of what they have", "[warnings][random]") {
  for (const RandomScenes kind : {RandomScenes::Frictionless, RandomScenes::Frictional})
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      CAPTURE(seed);
      const RandomScene drawn = random_scene(seed, kind);
      std::vector<std::string> notes;
      const std::string error = problem_message([&] { notes = plan(drawn.scene).notes; });
      for (const char* cause : {"same sides", "in front of the"})
        CHECK_THAT(error, !ContainsSubstring(cause));
      for (const char* warning : warnings)
        if (warning != std::string("zero everywhere") &&
            warning != std::string("straight edges of the target"))
          CHECK_FALSE(tells(notes, {warning}));
      const auto idle = [](const EdgeLoad& load) { return load.pressure == 0 && !load.traction; };
      bool has_idle = false;
      for (const Body& body : drawn.scene.bodies)
        has_idle = has_idle || std::any_of(body.loads.edges.begin(), body.loads.edges.end(), idle);
      if (error.empty() && has_idle) CHECK(tells(notes, {"zero everywhere"}));
    }
}

TEST_CASE("an error tells every note once, however many tell them", "[warnings]") {
  const std::vector<std::string> one = {"soft"}, both = {"soft", "thin"};
  const std::string told = signorini_test::problem_message([&] {
    with_context(both, [&] { with_context(one, [] { throw ProblemError("it fails"); }); });
  });
  CHECK(told == "it fails. Note: soft; thin");
  CHECK(with_notes("it fails", {}) == "it fails");
  const std::vector<std::string> five = {"locks", "bends", "bends", "turns", "slides"};
  const std::string some = with_notes("it fails", five);
  CHECK(some == "it fails. Note: locks; bends; turns; and 1 more");
  CHECK(with_notes(some, five) == some);
  CHECK(without_notes(told) == "it fails");
  CHECK(without_notes("it fails") == "it fails");
}

// On the axis the shape function of the end of a side with three nodes has the integral 0.
TEST_CASE("a node on the axis that no pair keeps out is told", "[warnings]") {
  const auto notes = [](const std::string& gap_operator, const std::string& quadratic) {
    const std::string mesh = ", size = [4, 2], cells = [4, 2], quadratic = " + quadratic + " }\n";
    return plan(parse_scene(
                    "material = { youngs_modulus = 1000, poisson_ratio = 0.3, state = \"axial "
                    "symmetry\" }\n"
                    "[[body]]\nname = \"a\"\nmesh = { kind = \"block\"" +
                        mesh +
                        "fixed = \"bottom\"\n"
                        "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", corner = [0, 2]" +
                        mesh +
                        "pressure = { top = 1 }\n"
                        "[[contact]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\noperator = \"" +
                        gap_operator + "\"\n",
                    "name", ".")
                    .scene)
        .notes;
  };
  CHECK(tells(notes("node_to_segment", "true"),
              {"contact of 'bottom' of 'b'", "the node at (0, 2) on the axis", "mortar"}));
  CHECK_FALSE(tells(notes("node_to_segment", "false"), {"on the axis"}));
  CHECK_FALSE(tells(notes("mortar", "true"), {"on the axis"}));
}

TEST_CASE("an obstacle that rises between two nodes is told, one that the nodes see is not",
          "[warnings]") {
  const auto notes = [](Index cells, const std::string& target) {
    return plan(parse_scene("[[body]]\nmesh = { kind = \"block\", size = [4, 1], cells = [" +
                                std::to_string(cells) +
                                ", 1] }\nmaterial = { youngs_modulus = 1000, poisson_ratio = 0.3 "
                                "}\nfixed = \"top\"\n[[contact]]\nsource = "
                                "\"bottom\"\ntarget = " +
                                target,
                            "s.toml", ".")
                    .scene)
        .notes;
  };
  const std::string bump =
      "{ kind = \"polyline\", points = [[-1, -0.1], [1.35, -0.1], [1.65, -0.08], [1.95, -0.1], [9, "
      "-0.1]] }";
  CHECK(tells(notes(6, bump), {"(1.33333, 0)", "(2, 0)", "no node sees that"}));
  CHECK_FALSE(tells(notes(40, bump), {"no node sees that"}));
  for (const Index cells : {2, 3, 7})
    for (const char* seen : {"{ kind = \"disc\", centre = [2.1, -3], radius = 3 }",
                             "{ kind = \"polyline\", points = [[-1, -3], [2.1, 0], [5, -3]] }",
                             "{ kind = \"half_plane\", point = [0, 0], normal = [0.1, 1] }"}) {
      CAPTURE(cells, seen);
      CHECK_FALSE(tells(notes(cells, seen), {"no node sees that"}));
    }
}

TEST_CASE("a disc whose centre lies on a side, where it cannot be looked at, is no bad input", "[warnings]") {
  const std::string scene =
      "[[body]]\nmesh = { kind = \"block\", size = [1, 1], cells = [4, 1] }\nmaterial = { "
      "youngs_modulus = 1000, poisson_ratio = 0.3 }\nfixed = \"top\"\n[[contact]]\nsource = "
      "\"bottom\"\ntarget = { kind = \"disc\", centre = [0.125, 0], radius = 0.1 }\n";
  CHECK_NOTHROW(static_cast<void>(plan(parse_scene(scene, "s.toml", ".").scene)));
}

TEST_CASE("a target of mortar that turns away is told, one that turns in and other operators are not",
          "[warnings]") {
  const auto notes = [](const std::string& lower, const std::string& source,
                        const std::string& target) {
    return plan(parse_scene("material = { youngs_modulus = 1000, poisson_ratio = 0.3 }\n" + lower +
                                "[[body]]\nname = \"up\"\nmesh = { kind = \"block\", corner = [-1, 1], "
                                "size = [4, 1], cells = [4, 2] }\nfixed = \"top\"\n[[contact]]\nsource = " +
                                source + "\ntarget = " + target + "\n",
                            "s.toml", ".")
                    .scene)
        .notes;
  };
  const std::string low =
      "[[body]]\nname = \"lo\"\nmesh = { kind = \"ring\", inner_radius = 0.5, outer_radius = 1, cells = [10, 1], "
      "turn = 18 }\nfixed = \"inner\"\n";
  CHECK(tells(notes(low, "\"up.bottom\"", "\"lo.outer\""),
              {"the target turns by 36 degrees", "at 10 nodes", "operator = \"gauss_points\""}));
  CHECK_FALSE(tells(notes(low, "\"up.bottom\"", "\"lo.outer\"\noperator = \"gauss_points\""),
                    {"the target turns"}));
  // A right angle is an end of the target to mortar.
  const std::string block =
      "[[body]]\nname = \"lo\"\nmesh = { kind = \"block\", size = [2, 1], cells = [5, 3] }\nfixed = \"bottom\"\n";
  CHECK_FALSE(tells(notes(block, "\"up.bottom\"", "[\"lo.top\", \"lo.right\"]"), {"the target turns"}));
}
