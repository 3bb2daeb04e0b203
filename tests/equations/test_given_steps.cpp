// What supports and equations hold in load steps, where not all of it is there at once.
#include <cmath>
#include <sstream>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/files/scene_file.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"
#include "support/paths.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

namespace {

Scene scene_of(const std::string& words) { return parse_scene(words, "name", ".").scene; }

std::string refusal(const std::string& words) {
  return problem_message([&] { static_cast<void>(plan(scene_of(words))); });
}

const std::string material = "material = { youngs_modulus = 1000, poisson_ratio = 0.3 }\n";

/// A block whose left side is moved down by 0.05 times a history, above a floor.
std::string lowered(const std::string& steps, const std::string& floor, const std::string& more = "") {
  return material +
         "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\n"
         "prescribed = { left = { x = 0, y = -0.05, history = \"h\" } }\n" +
         more + "[[contact]]\nsource = \"bottom\"\ntarget = { kind = \"half_plane\", point = [0, " + floor +
         "], normal = [0, 1] }\n" + steps;
}

/// Two blocks of which the lower one is dragged by one history and the upper one by another, pressed by 1.
std::string dragged_apart(const std::string& more) {
  return material +
         "[[body]]\nname = \"a\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\n"
         "prescribed = { bottom = { y = 0 }, top = { x = 0.1, history = \"h\" } }\n"
         "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2], corner = [0, 2] }\n"
         "prescribed = { bottom = { x = 0.1, history = \"g\" } }\npressure = { top = 1 }\n"
         "[[contact]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\nfriction = 0.3\n" +
         more + "[[steps]]\nvalues = { h = 0.5, g = 1 }\n[[steps]]\nvalues = { h = 0.5, g = 0 }\n";
}

}  // namespace

// At twice the displacement the corner at (0, 0) stands at -0.1, in the end at -0.025.
TEST_CASE("a node that supports take into an obstacle on the way is refused, with the time",
          "[steps][given][errors]") {
  const std::string steps = "[[steps]]\ncount = 2\nvalues = { h = 2 }\n[[steps]]\nvalues = { h = 0.5 }\n";
  CHECK_THAT(refusal(lowered(steps, "-0.07")),
             ContainsSubstring("the pair at (0, 0) is held by supports and overlaps by 0.03 at time 1"));
  CHECK(refusal(lowered(steps, "-0.11")).empty());
  // With the history at 1 the corner would stand at -0.05, but it never does.
  CHECK(refusal(lowered("[[steps]]\nvalues = { h = 0.3 }\n", "-0.02")).empty());
}

TEST_CASE("a side that a relation takes into an obstacle on the way is refused, with the time",
          "[steps][given][errors]") {
  const std::string follows =
      "point = [{ at = [0, 2], x = 0, y = -0.05, history = \"h\" }]\nsymmetric = \"left\"\n"
      "[[relation]]\nterms = [{ side = \"bottom\", along = [0, 1] }, "
      "{ side = \"top\", point = [0, 2], along = [0, 1], times = -1 }]\n";
  const auto scene = [&](const std::string& steps) {
    std::string words = lowered(steps, "-0.07", follows);
    const std::string held = "prescribed = { left = { x = 0, y = -0.05, history = \"h\" } }\n";
    return words.erase(words.find(held), held.size());
  };
  CHECK_THAT(refusal(scene("[[steps]]\ncount = 2\nvalues = { h = 2 }\n[[steps]]\nvalues = { h = 0.5 }\n")),
             ContainsSubstring("is held by supports, ties, relations or rigid sides and overlaps by 0.03 at time 1"));
  CHECK(refusal(scene("[[steps]]\ncount = 2\nvalues = { h = 1 }\n")).empty());
}

TEST_CASE("interference that grows takes a held pair into an obstacle when it is there",
          "[steps][given][errors]") {
  const auto scene = [](const std::string& value) {
    return material +
           "[[body]]\nmesh = { kind = \"block\", size = [1, 1], cells = [4, 4] }\nfixed = \"top\"\n"
           "[[contact]]\nsource = \"right\"\ntarget = { kind = \"half_plane\", point = [1.002, 0], normal = [-1, 0] }\n"
           "interference = { value = 0.001, history = \"p\" }\n[[steps]]\nvalues = { p = " +
           value + " }\n";
  };
  CHECK_THAT(refusal(scene("5")), ContainsSubstring("overlaps by 0.003 at time 1"));
  CHECK(refusal(scene("2")).empty());
}

// Friction between two sides that are held along it: 4 presses, 0.3 of it rubs, over slips of 0.1 and 0.05.
TEST_CASE("sides that two histories drag apart rub, also if both would move alike in full", "[steps][friction]") {
  const std::string relation =
      "[[relation]]\nterms = [{ side = \"b.top\", along = [0, 1], point = [0, 4] }, "
      "{ side = \"b.top\", along = [0, 1], times = -1, point = [4, 4] }]\n";
  const std::string more = GENERATE_COPY(std::string(), relation);
  CAPTURE(more);
  Step last;
  Resultants sums;
  const PathEnd end = solve_steps(scene_of(dragged_apart(more)), [&](const Model& model, const Step& step) {
    last = step;
    sums = resultants(model, step.solution, totals(&step.state));
  });
  REQUIRE(end.status == SolveStatus::Solved);
  REQUIRE(last.state.slip.size() == 5);
  CHECK(sums.slide == 5);
  CHECK(sums.force.x() == Approx(1.2).epsilon(1e-12));
  CHECK(sums.dissipated_total == Approx(0.18).epsilon(1e-12));
}

TEST_CASE("equations are compared with what supports give at each step", "[steps][equations][errors]") {
  const auto scene = [](const std::string& right, const std::string& values) {
    return material +
           "[[body]]\nmesh = { kind = \"block\", size = [2, 1], cells = [4, 2] }\n"
           "prescribed = { left = { x = 0.01, y = 0, history = \"a\" }, right = { x = " +
           right + ", history = \"b\" } }\n" +
           "[[relation]]\nterms = [{ side = \"left\", along = [1, 0] }, "
           "{ side = \"right\", along = [1, 0], times = -1 }]\n[[steps]]\nvalues = " +
           values + "\n";
  };
  // 0.01 a = 0.02 b at the end of the step, though not for a = b = 1.
  CHECK(refusal(scene("0.02", "{ a = 1, b = 0.5 }")).empty());
  CHECK_THAT(refusal(scene("0.01", "{ a = 1, b = 0.5 }")),
             ContainsSubstring("equations contradict others or supports at time 1, the first: relation 1"));
}

TEST_CASE("supports that move the sides of a tie apart are refused, whatever faces what", "[equations][errors]") {
  const std::string cells = GENERATE("4", "3", "8");
  CAPTURE(cells);
  const auto scene = [&](const std::string& moved, const std::string& steps) {
    return material +
           "[[body]]\nname = \"a\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\nfixed = \"bottom\"\n"
           "symmetric = \"left\"\n"
           "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", size = [4, 2], cells = [" +
           cells + ", 2], corner = [0, 2] }\nprescribed = { left = { x = " + moved +
           " } }\npressure = { top = 1 }\n[[tie]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\n" + steps;
  };
  CHECK(!refusal(scene("0.05", "")).empty());
  CHECK(!refusal(scene("0.05, history = \"h\"", "[[steps]]\nvalues = { h = 1 }\n")).empty());
  CHECK(refusal(scene("0", "")).empty());
}

// Normals of meshes that do not match are tilted at the ends, and closing a gap there has a part along the line of symmetry.
TEST_CASE("ties end on lines of symmetry, and at supports of other places", "[equations]") {
  const std::string quadratic = GENERATE(as<std::string>(), "false", "true");
  const std::string closes = GENERATE(as<std::string>(), "false", "true");
  CAPTURE(quadratic, closes);
  const auto ring = [&](const std::string& head, const std::string& cells, const std::string& more) {
    return "[[body]]\nmesh = { kind = \"ring\", sector = \"quarter\", quadratic = " + quadratic + ", cells = " + cells +
           ", " + head + " }\nsymmetric = [\"symmetry\", \"symmetry_y\"]\n" + more;
  };
  const std::string rings =
      material + ring("inner_radius = 1, outer_radius = 2", "[7, 3]", "name = \"in\"\npressure = { inner = 1 }\n") +
      ring("inner_radius = 2, outer_radius = 3", "[10, 3]", "name = \"out\"\n") +
      "[[tie]]\nsource = \"in.outer\"\ntarget = \"out.inner\"\ncloses = " + closes + "\n";
  CHECK(refusal(rings).empty());
  const std::string blocks =
      material +
      "[[body]]\nname = \"low\"\nmesh = { kind = \"block\", corner = [-1, 0], size = [10, 2], cells = [5, 2], quadratic = " +
      quadratic + " }\nfixed = \"left\"\n" +
      "[[body]]\nname = \"up\"\nmesh = { kind = \"block\", corner = [0, 2], size = [8, 2], cells = [16, 4], quadratic = " +
      quadratic + " }\nprescribed = { left = { x = 0.001, y = 0 } }\n" +
      "[[tie]]\nsource = \"up.bottom\"\ntarget = \"low.top\"\ncloses = " + closes + "\n";
  CHECK(refusal(blocks).empty());
}

// All of the pin is held; the ring is free to follow, as its other side is far away.
TEST_CASE("a sliding tie whose node is held in both components is no row between supports", "[equations]") {
  const Scene scene = scene_of(
      material +
      "[[body]]\nname = \"ring\"\nmesh = { kind = \"ring\", inner_radius = 1, outer_radius = 2, cells = [16, 2] }\nfixed = \"outer\"\n"
      "[[body]]\nname = \"pin\"\nmesh = { kind = \"ring\", inner_radius = 0.5, outer_radius = 1, cells = [16, 2] }\n"
      "prescribed = { outer = { x = 0.01, y = 0 } }\n"
      "[[tie]]\nsource = \"pin.outer\"\ntarget = \"ring.inner\"\nslides = true\n");
  const SolvedScene run = solved(scene, "the ring");
  CHECK(run.solution.certificate.holds());
  CHECK(bond_forces(run.model, run.solution)[0].force.x() < 0);
}

TEST_CASE("a history without values is refused before anybody looks at it", "[steps][given][errors]") {
  Scene scene = scene_of(lowered("[[steps]]\nvalues = { h = 1 }\n", "-0.07"));
  scene.path->histories[0].times.clear();
  scene.path->histories[0].values.clear();
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene)); }),
             ContainsSubstring("history 'h': expected as many values as times"));
}

// Far away from a block that slides by three of its cells, a tie joins the sides of another contact.
TEST_CASE("pairs that a tie holds elsewhere do not end the look at how far others slide", "[given][sliding]") {
  const std::string block = material +
                            "[[body]]\nname = \"track\"\nmesh = { kind = \"block\", size = [10, 2], cells = [10, 2] }\n"
                            "fixed = \"bottom\"\n"
                            "[[body]]\nname = \"block\"\nmesh = { kind = \"block\", size = [4, 2], corner = [0.5, 2], cells = [4, 2] }\n"
                            "prescribed = { top = { x = 3.0, y = -0.02 } }\n"
                            "[[contact]]\nsource = \"block.bottom\"\ntarget = \"track.top\"\nfriction = 0.2\n";
  const std::string post =
      "[[body]]\nname = \"post\"\nmesh = { kind = \"block\", size = [1, 2], corner = [20, 0], cells = [2, 2] }\nfixed = \"bottom\"\n"
      "[[body]]\nname = \"cap\"\nmesh = { kind = \"block\", size = [1, 2], corner = [20, 2], cells = [2, 2] }\npressure = { top = 1 }\n";
  const std::string sides = "source = \"cap.bottom\"\ntarget = \"post.top\"\n";
  for (const std::string& more : {std::string(), post + "[[contact]]\n" + sides + "[[tie]]\n" + sides,
                                  post + "[[tie]]\n" + sides + "slides = true\nfriction = 0.3\n"}) {
    CAPTURE(more);
    CHECK(solve(scene_of(block + more)).contact.report.status == SolveStatus::SlidTooFar);
  }
}

// Pulled up on a rail by 1 and along it by less than 0.3 of that, in two steps.
TEST_CASE("a rail in tension goes on from its own state", "[steps][two-sided]") {
  const Scene scene = scene_of(
      material +
      "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\n"
      "traction = { bottom = { value = [1, 0], history = \"d\" } }\npressure = { top = -1 }\n"
      "[[tie]]\nsource = \"bottom\"\ntarget = { kind = \"half_plane\", point = [0, 0], normal = [0, 1] }\n"
      "slides = true\nfriction = 0.3\n[[steps]]\nvalues = { d = 0.2 }\n[[steps]]\nvalues = { d = 0.1 }\n");
  const std::vector<Step> all = steps_of(scene);
  REQUIRE(all.size() == 2);
  CHECK(all[0].solution.contact.force.maxCoeff() < 0);
  const std::vector<Step> rest = steps_of(scene, read_state(written(all[0].state), "saved"));
  REQUIRE(rest.size() == 1);
  CHECK(rest[0].state.solution.force == all[1].state.solution.force);
  PathState changed = all[0].state;
  changed.solution.force(0) *= 1 + 1e-6;
  CHECK_THAT(problem_message([&] { static_cast<void>(steps_of(scene, changed)); }),
             ContainsSubstring("is of another scene"));
}
