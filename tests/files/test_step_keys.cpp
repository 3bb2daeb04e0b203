// Load steps of scene files arrive in the scene, and are those of the same scene in C++.
#include "addons/files/scene_file.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Vector2d;
using signorini_test::problem_message;

namespace {

const std::string head = "material = { youngs_modulus = 10, poisson_ratio = 0.25 }\n";
const std::string block = "[[body]]\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\n";

Scene scene_of(const std::string& content) { return parse_scene(content, "name", ".").scene; }

/// A scene whose loads all follow the history `a`.
Scene scene_of_steps(const std::string& steps) {
  return scene_of(head + block + "pressure = { top = { value = 3, history = \"a\" } }\n" + steps);
}

using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("steps follow one another, and what they do not name stays", "[scene_file][steps]") {
  const Path path =
      *scene_of(head + block +
                "pressure = { top = { value = 3, history = \"a\" }, left = { value = 1, history = "
                "\"b\" } }\n"
                "[[steps]]\ncount = 2\nvalues = { a = 2 }\n"
                "[[steps]]\nuntil = 1.5\n"
                "[[steps]]\nuntil = 4\ncount = 5\nvalues = { b = -1 }\n"
                "[[steps]]\nvalues = { a = 0 }\n")
           .path;
  CHECK(path.times == Numbers{0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 5});
  REQUIRE(path.histories.size() == 2);
  CHECK(path.histories[0].name == "a");
  CHECK(path.histories[0].times == Numbers{0, 1, 1.5, 4, 5});
  CHECK(path.histories[0].values == Numbers{0, 2, 2, 2, 0});
  CHECK(path.histories[1].name == "b");
  CHECK(path.histories[1].times == Numbers{0, 1.5, 4, 5});
  CHECK(path.histories[1].values == Numbers{0, 0, -1, -1});
  CHECK(path.halvings == Path().halvings);
}

TEST_CASE("pairs of a body with a law move: to say that they do not is refused where it is said",
          "[scene_file][steps]") {
  const auto text = [](const std::string& moves, const std::string& law) {
    return moves + "[[body]]\nname = \"rubber\"\n" +
           "mesh = { kind = \"block\", size = [1, 1], cells = [1, 1] }\n" +
           "material = { youngs_modulus = 1, poisson_ratio = 0.3" + law + " }\n" +
           "fixed = \"left\"\n[[contact]]\nsource = \"bottom\"\n" +
           "target = { kind = \"half_plane\", point = [0, 0], normal = [0, 1] }\n" +
           "[[steps]]\ncount = 1\n";
  };
  const std::string law = ", law = \"neo_hooke\"";
  CHECK_THAT(problem_message([&] { static_cast<void>(scene_of(text("moves = false\n", law))); }),
             ContainsSubstring("moves: body 'rubber' has the law neo_hooke") &&
                 ContainsSubstring("leave out the key, or the law"));
  CHECK_NOTHROW(scene_of(text("moves = false\n", "")));
  CHECK_NOTHROW(scene_of(text("moves = true\n", law)));
  CHECK_NOTHROW(scene_of(text("", law)));
}

TEST_CASE("a history has a table or is proportional", "[scene_file][steps]") {
  const std::string steps = "[[steps]]\ncount = 3\n";
  const Path plain = *scene_of_steps("[[history]]\nname = \"a\"\n" + steps).path;
  REQUIRE(plain.histories.size() == 1);
  CHECK(plain.histories[0].times == proportional("a").times);
  CHECK(plain.histories[0].values == proportional("a").values);
  CHECK(plain.times == equal_steps(3));
  const Path table =
      *scene_of_steps("[[history]]\nname = \"a\"\ntimes = [0.5, 2, 3]\nvalues = [1, -1, 0]\n" +
                      steps)
           .path;
  CHECK(table.histories[0].times == Numbers{0.5, 2, 3});
  CHECK(table.histories[0].values == Numbers{1, -1, 0});
  const Path few = *scene_of("halvings = 2\n" + head + block +
                             "body_force = { value = [0, -1], history = \"a\" }\n[[steps]]\nvalues "
                             "= { a = 1 }\n")
                        .path;
  CHECK(few.halvings == 2);
  CHECK_FALSE(scene_of(head + block).path);
}

TEST_CASE("everything that may grow names its history", "[scene_file][steps]") {
  const Scene scene =
      scene_of(head + block +
               "pressure = { top = { value = 3, history = \"a\" }, left = 1 }\n"
               "traction = { top = { value = [1, 2], history = \"b\" }, bottom = [0, 1] }\n"
               "body_force = { value = [0, -7], history = \"c\" }\n"
               "prescribed = { right = { x = 0.5, y = 0.25, history = \"d\" } }\n"
               "temperature = { uniform = 4, history = \"e\" }\n"
               "point = [{ at = [2, 2], force = [1, 0], history = \"f\" },"
               " { at = [0, 0], x = 1, history = \"g\" }, { at = [0, 2], y = 1 }]\n"
               "[[contact]]\nsource = \"bottom\"\n"
               "target = { kind = \"half_plane\", point = [0, 0], normal = [0, 1] }\n"
               "interference = { value = 0.125, history = \"h\" }\n"
               "[[steps]]\nvalues = { a = 1, b = 1, c = 1, d = 1, e = 1, f = 1, g = 1, h = 1 }\n");
  const Body& body = scene.bodies[0];
  REQUIRE(body.loads.edges.size() == 4);
  CHECK(body.loads.edges[0].history == "a");
  CHECK(body.loads.edges[0].pressure == 3);
  CHECK(body.loads.edges[1].history.empty());
  CHECK(body.loads.edges[1].pressure == 1);
  CHECK(body.loads.edges[2].history == "b");
  CHECK(body.loads.edges[2].pressure == 0);
  CHECK(body.loads.edges[2].traction({0, 0}) == Vector2d(1, 2));
  CHECK(body.loads.edges[3].history.empty());
  CHECK(body.loads.body_force_history == "c");
  CHECK(body.loads.body_force({0, 0}) == Vector2d(0, -7));
  REQUIRE(body.supports.size() == 4);
  CHECK(body.supports[0].history == "d");
  CHECK(body.supports[1].history == "d");
  CHECK(body.supports[1].displacement({0, 0}).y() == 0.25);
  CHECK(body.supports[2].history == "g");
  CHECK(body.supports[3].history.empty());
  CHECK(body.temperature->history == "e");
  CHECK(body.temperature->uniform == 4);
  REQUIRE(body.loads.points.size() == 1);
  CHECK(body.loads.points[0].history == "f");
  CHECK(scene.contacts[0].interference_history == "h");
  CHECK(scene.contacts[0].interference == 0.125);
  CHECK(scene.path->histories.size() == 8);
}

TEST_CASE("a boundary is pressed by one history and dragged by another", "[scene_file][steps]") {
  const Scene scene = scene_of(
      head + block +
      "prescribed = { top = [{ y = -0.5, history = \"press\" }, { x = 2, history = \"drag\" }] }\n"
      "[[steps]]\nvalues = { press = 1 }\n[[steps]]\nvalues = { drag = 1 }\n");
  const std::vector<Support>& supports = scene.bodies[0].supports;
  REQUIRE(supports.size() == 2);
  CHECK(supports[0].history == "press");
  CHECK(supports[0].displacement({0, 0}).y() == -0.5);
  CHECK(supports[1].history == "drag");
  CHECK(supports[1].displacement({0, 0}).x() == 2);
  std::vector<NodeArray> all;
  const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) {
    all.push_back(step.solution.displacements[0]);
  });
  REQUIRE(end.status == SolveStatus::Solved);
  for (const Eigen::Index node : boundary_nodes(scene.bodies[0].mesh, "top")) {
    CHECK(all[0].row(node) == Eigen::RowVector2d(0, -0.5));
    CHECK(all[1].row(node) == Eigen::RowVector2d(2, -0.5));
  }
  const auto message = [](const std::string& top) {
    return problem_message(
        [&] { static_cast<void>(scene_of(head + block + "prescribed = { top = " + top + " }\n")); });
  };
  CHECK_THAT(message("[{ x = 1 }, { history = \"a\" }]"), ContainsSubstring("expected { x = ... }"));
  CHECK_THAT(problem_message([&] {
               static_cast<void>(plan(scene_of(head + block + "prescribed = { top = [{ x = 1 }, { x = 2 }] }\n")));
             }),
             ContainsSubstring("top"));
}

TEST_CASE("a boundary may be called history", "[scene_file][steps]") {
  const std::string message = problem_message(
      [] { static_cast<void>(scene_of_steps("prescribed = { history = { x = 1 } }\n")); });
  CHECK_THAT(message, ContainsSubstring("has no boundary 'history'"));
}

// The load of step k is value * history: without contact the answer is that of one linear solve.
TEST_CASE("the steps of a file are loaded as they say", "[scene_file][steps]") {
  const std::string body = "fixed = \"left\"\n";
  const Scene stepped = scene_of(head + block + body +
                                 "traction = { right = { value = [0, -0.01], history = \"a\" } }\n"
                                 "[[steps]]\ncount = 2\nvalues = { a = -3 }\n");
  const Scene plain = scene_of(head + block + body + "traction = { right = [0, 0.03] }\n");
  const Solution once = solve(plain);
  std::vector<NodeArray> all;
  const PathEnd end = solve_steps(stepped, [&](const Model&, const Step& step) {
    all.push_back(step.solution.displacements[0]);
  });
  CHECK(end.status == SolveStatus::Solved);
  REQUIRE(all.size() == 2);
  const double size = once.displacements[0].norm();
  CHECK((all[1] - once.displacements[0]).norm() <= 1e-12 * size);
  CHECK((2 * all[0] - once.displacements[0]).norm() <= 1e-12 * size);
}

TEST_CASE("what is wrong with the second of two histories has its line", "[scene_file][steps]") {
  const std::string scene =
      head + block +
      "pressure = { top = { value = 3, history = \"a\" }, left = { value = 1, history = \"b\" } }\n"
      "[[history]]\nname = \"a\"\n"
      "[[history]]\nname = \"b\"\n";  // in line 7
  CHECK_THAT(problem_message([&] { scene_of(scene + "[[steps]]\nvalues = { b = 2 }\n"); }),
             ContainsSubstring("the history 'b' has its values in line 7: leave one of them out"));
  CHECK_THAT(problem_message([&] { scene_of(scene + "[[history]]\nname = \"b\"\n[[steps]]\n"); }),
             ContainsSubstring("the history of line 7 is called 'b' too"));
}
