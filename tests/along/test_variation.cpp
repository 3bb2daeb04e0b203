// Loads that vary along a boundary: resultants and moments of closed forms, to rounding, wherever kinks and jumps are.
#include <cmath>

#include "addons/along/variation.hpp"
#include "addons/files/scene_file.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using signorini_test::problem_message;

namespace {

std::string block(const std::string& more = "", const std::string& state = "plane strain") {
  return "material = { youngs_modulus = 1000, poisson_ratio = 0.25, expansion = 1e-3, state = \"" +
         state + "\" }\n[[body]]\nname = \"block\"\n" +
         "mesh = { kind = \"block\", size = [4, 1], cells = [3, 2], grading = [2, 1]" + more +
         " }\n";
}

/// What the loads of the body of a text add up to: force, and moment about the origin.
Eigen::Vector3d sum_of(const std::string& text) {
  Ledger ledger;
  const Model model = build(parse_scene(text + "fixed = \"left\"\n", "name", ".").scene, ledger);
  const BodyModel& body = model.bodies[0];
  const NodeArray force = nodal_loads(body.mesh, body.element, body.material, body.loads);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index k = 0; k < force.rows(); ++k)
    sum +=
        Eigen::Vector3d(force(k, 0), force(k, 1),
                        body.mesh.nodes(k, 0) * force(k, 1) - body.mesh.nodes(k, 1) * force(k, 0));
  return sum;
}

/// Compares to a few roundings of the whole. \param size  of what is added up
void check_sum(const Eigen::Vector3d& sum, const Eigen::Vector3d& expected, double size) {
  CAPTURE(sum.transpose(), expected.transpose());
  CHECK((sum - expected).cwiseAbs().maxCoeff() <= 1e-14 * size);
}

std::string kind_of_cells() {
  return GENERATE(as<std::string>(), "", ", quadratic = true", ", triangles = true");
}

}  // namespace

// Closed form: the integrals of x^i and x^(i+1) over the top, from 0 to 4; a pressure pushes down.
TEST_CASE("a polynomial of any degree has its resultant and its moment",
          "[variation][closed-form]") {
  const std::string cells = kind_of_cells();
  const int degree = GENERATE(0, 1, 2, 3, 7, 13);
  CAPTURE(cells, degree);
  const double c = std::pow(4.0, -degree);
  const double force = 4.0 / (degree + 1);
  const double moment = 16.0 / (degree + 2);
  check_sum(sum_of(block(cells) + text("pressure = { top = { polynomial = [[", shortest(c), ", ",
                                       degree, ", 0]] } }\n")),
            {0, -force, -moment}, 16);
  check_sum(sum_of(block(cells) + text("traction = { top = { polynomial = [[", shortest(3 * c),
                                       ", ", shortest(-c), ", ", degree, ", 0]] } }\n")),
            {3 * force, -force, -moment - 3 * force}, 16);
}

// Closed form: a hat of height 2 from 0.7 to 3.1 with its tip at 1.3, all within sides, has the area 2.4 and its centre of mass
// at the mean of the three. A step of 5 between 0.9 and 2.2 has 6.5 at 1.55.
TEST_CASE("kinks and jumps of a table within sides are integrated piece by piece",
          "[variation][closed-form]") {
  const std::string cells = kind_of_cells();
  CAPTURE(cells);
  const double hat = (0.7 + 1.3 + 3.1) / 3;
  const std::string rows = "table = [[0.7, 0], [1.3, 2], [3.1, 0]] } }\n";
  check_sum(sum_of(block(cells) + "pressure = { top = { over = \"x\", " + rows),
            {0, -2.4, -2.4 * hat}, 16);
  // Along the bottom the length is x, along the top it is 4 - x.
  check_sum(sum_of(block(cells) + "pressure = { bottom = { over = \"length\", " + rows),
            {0, 2.4, 2.4 * hat}, 16);
  check_sum(sum_of(block(cells) + "pressure = { top = { over = \"length\", " + rows),
            {0, -2.4, -2.4 * (4 - hat)}, 16);
  check_sum(sum_of(block(cells) + "pressure = { top = { over = \"x\", table = [[0.9, 0], [0.9, 5], "
                                  "[2.2, 5], [2.2, 0]] } }\n"),
            {0, -6.5, -6.5 * 1.55}, 16);
  check_sum(sum_of(block(cells) + "traction = { right = { over = \"y\", table = [[0.3, 0, 0], "
                                  "[0.3, 1, 2], [0.8, 1, 2], [0.8, 0, 0]] } }\n"),
            {0.5, 1, 4 * 1 - 0.55 * 0.5}, 16);
}

// Closed form: a turned body with its table over the length is the same body, turned.
TEST_CASE("the length of a boundary turns with it", "[variation][closed-form]") {
  const double c = std::cos(std::acos(-1.0) / 6);
  const double s = std::sin(std::acos(-1.0) / 6);
  const Eigen::Vector3d sum = sum_of(
      block(", turn = 30") +
      "pressure = { bottom = { over = \"length\", table = [[0.7, 0], [1.3, 2], [3.1, 0]] } }\n");
  check_sum(sum, {-2.4 * s, 2.4 * c, 2.4 * (0.7 + 1.3 + 3.1) / 3}, 16);
}

// Closed form: on a body of revolution the pressure r from 0 to 4 pushes down with 2 pi 4^3 / 3; with a kink at 1, min(r, 1), with
// 2 pi (1/3 + 15/2).
TEST_CASE("in axial symmetry the radius is integrated with the load", "[variation][closed-form]") {
  const std::string cells = kind_of_cells();
  const double pi = std::acos(-1.0);
  const auto down = [&](const std::string& load) {
    return sum_of(block(cells, "axial symmetry") + "pressure = { top = " + load + " }\n").y();
  };
  CHECK(down("{ polynomial = [[1, 1, 0]] }") == Approx(-2 * pi * 64 / 3).epsilon(1e-14));
  CHECK(down("{ over = \"x\", table = [[0, 0], [1, 1]] }") ==
        Approx(-2 * pi * (1.0 / 3 + 7.5)).epsilon(1e-14));
}

// Closed form: the pressure x^2 on the parabola y = x^2 from 0 to 1, whose body lies above: the normal into it times ds is (-2x, 1) dx.
TEST_CASE("a curved side is integrated as the parabola that it is", "[variation][closed-form]") {
  Mesh mesh = signorini::block("body", {0, 0}, {1, 2}, 1, 1, MeshOrder::Quadratic);
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    if (mesh.nodes(node, 1) == 0) mesh.nodes(node, 1) = mesh.nodes(node, 0) * mesh.nodes(node, 0);
  Variation square;
  square.powers = {{2, 0}};
  square.values = Eigen::MatrixXd::Constant(1, 1, 1);
  Loads loads;
  loads.edges.push_back({"bottom", 1, {}, "", field_of(square), rule_of(square)});
  const Material material{1, 0.3};
  const NodeArray force = nodal_loads(mesh, element_for(mesh, "q8"), material, loads);
  CHECK(force.col(0).sum() == Approx(-0.5).epsilon(1e-14));
  CHECK(force.col(1).sum() == Approx(1.0 / 3).epsilon(1e-14));
}

// Closed form: on y = 2x^2/5 from 0 to 1, which turns by 39 degrees, the traction (1, x) times ds = sqrt(1 + 16x^2/25) dx, and the pressure
// y^13, whose upward part is the integral of (2x^2/5)^13. Eight points would not do for either.
TEST_CASE("a traction and a high power on a curved side are integrated to rounding",
          "[variation][closed-form]") {
  Mesh mesh = signorini::block("body", {0, 0}, {1, 2}, 1, 1, MeshOrder::Quadratic);
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    if (mesh.nodes(node, 1) == 0)
      mesh.nodes(node, 1) = 0.4 * mesh.nodes(node, 0) * mesh.nodes(node, 0);
  const auto sum = [&](const EdgeLoad& edge) -> Vector2d {
    Loads loads;
    loads.edges.push_back(edge);
    return nodal_loads(mesh, element_for(mesh, "q8"), Material{1, 0.3}, loads).colwise().sum();
  };
  Variation linear;
  linear.powers = {{1, 0}};
  linear.values = Eigen::MatrixXd::Constant(1, 1, 1);
  const auto traction = [&](const Vector2d& x) { return Vector2d(1, linear.at(x)(0)); };
  const Vector2d pulled = sum({"bottom", 0, traction, "", {}, rule_of(linear)});
  CHECK(pulled.x() == Approx(std::sqrt(1.64) / 2 + std::asinh(0.8) / 1.6).epsilon(1e-14));
  CHECK(pulled.y() == Approx((std::pow(1.64, 1.5) - 1) / 1.92).epsilon(1e-14));
  Variation high;
  high.powers = {{0, largest_degree}};
  high.values = Eigen::MatrixXd::Constant(1, 1, std::pow(2.5, largest_degree));
  const Vector2d pushed = sum({"bottom", 1, {}, "", field_of(high), rule_of(high)});
  CHECK(pushed.y() == Approx(1.0 / 27).epsilon(1e-14));
}

// Closed form: u_x = x y, u_y = -x^2/2 is pure bending with the stress E y in plane stress, without Poisson's ratio.
TEST_CASE("displacements that are given may vary, and grow", "[variation][closed-form]") {
  std::string given;
  for (const char* side : {"left", "right", "bottom", "top"})
    given += text(given.empty() ? "" : ", ", side,
                  " = { x = { polynomial = [[1e-3, 1, 1]] }, y = { polynomial = [[-5e-4, 2, 0]] }, "
                  "history = \"bend\" }");
  const std::string body =
      "[[body]]\nmaterial = { youngs_modulus = 1000, poisson_ratio = 0, state = \"plane stress\" "
      "}\n"
      "mesh = { kind = \"block\", size = [4, 1], cells = [3, 2], quadratic = true }\n"
      "prescribed = { " +
      given + " }\n[[steps]]\nvalues = { bend = 2 }\n";
  const SceneFile file = parse_scene(body, "name", ".");
  const PathEnd end = solve_steps(file.scene, [](const Model& model, const Step& step) {
    const NodeArray& x = model.bodies[0].mesh.nodes;
    const NodeArray& u = step.solution.displacements[0];
    for (Index k = 0; k < x.rows(); ++k) {
      CHECK(u(k, 0) == Approx(2e-3 * x(k, 0) * x(k, 1)).margin(1e-16));
      CHECK(u(k, 1) == Approx(-1e-3 * x(k, 0) * x(k, 0)).margin(1e-16));
    }
  });
  CHECK(end.status == SolveStatus::Solved);
}

// Closed form: a free body that is warmer by y bends without stress: u_x = a x y, u_y = a (y^2 - x^2) / 2 in plane stress.
TEST_CASE("a temperature may vary as a table and as a polynomial", "[variation][closed-form]") {
  const std::string form = GENERATE(as<std::string>(), "{ over = \"y\", table = [[0, 0], [1, 1]] }",
                                    "{ polynomial = [[1, 0, 1]] }");
  const Scene scene =
      parse_scene(block(", quadratic = true", "plane stress") + "symmetric = \"left\"\n" +
                      "point = { at = [0, 0], y = 0 }\ntemperature = { varying = " + form + " }\n",
                  "name", ".")
          .scene;
  const SolvedScene run = solved(scene, "warm");
  const NodeArray& x = run.model.bodies[0].mesh.nodes;
  const NodeArray& u = run.solution.displacements[0];
  for (Index k = 0; k < x.rows(); ++k) {
    CHECK(u(k, 0) == Approx(1e-3 * x(k, 0) * x(k, 1)).margin(1e-15));
    CHECK(u(k, 1) == Approx(5e-4 * (x(k, 1) * x(k, 1) - x(k, 0) * x(k, 0))).margin(1e-14));
  }
}

// Closed form: half of the hat above at half of the way, and of a traction the same along both axes.
TEST_CASE("a load that varies grows with its history", "[variation][closed-form]") {
  Ledger ledger;
  Model model = build(
      parse_scene(
          block() +
              "fixed = \"left\"\npressure = { top = { value = { over = \"x\", table = [[0.7, 0], "
              "[1.3, 2], [3.1, 0]] }, history = \"rise\" } }\n"
              "traction = { bottom = { value = { over = \"x\", table = [[0.9, 0, 0], "
              "[0.9, 1, 3], [2.9, 1, 3], [2.9, 0, 0]] }, history = \"rise\" } }\n"
              "[[steps]]\nvalues = { rise = 1 }\n",
          "name", ".")
          .scene,
      ledger);
  set_time(0.5, model);
  const BodyModel& body = model.bodies[0];
  const NodeArray force = nodal_loads(body.mesh, body.element, body.material, body.loads);
  CHECK(force.col(0).sum() == Approx(1).epsilon(1e-14));
  CHECK(force.col(1).sum() == Approx(3 - 1.2).epsilon(1e-14));
}

TEST_CASE("an interference may vary, in one go and in load steps", "[variation]") {
  const std::string contact =
      "fixed = \"top\"\n[[contact]]\nsource = \"bottom\"\n"
      "target = { kind = \"half_plane\", point = [0, 0], normal = [0, 1] }\n";
  const std::string wedge = "{ over = \"x\", table = [[0, 0.001], [4, 0.003]] }";
  Ledger ledger;
  const Model once =
      build(parse_scene(block() + contact + "interference = " + wedge, "name", ".").scene, ledger);
  Model grown =
      build(parse_scene(block() + contact + "interference = { value = " + wedge +
                            ", history = \"drive\" }\n[[steps]]\nvalues = { drive = 2 }\n",
                        "name", ".")
                .scene,
            ledger);
  set_time(0.5, grown);
  REQUIRE(once.pairs.weight.size() == 4);
  for (Index k = 0; k < 4; ++k) {
    const double closer = 0.001 + 0.0005 * once.pairs.position(k, 0);
    CHECK(once.programme.initial_gap(k) == Approx(-closer).epsilon(1e-14));
    CHECK(grown.programme.initial_gap(k) == Approx(-closer).epsilon(1e-14));
  }
}

TEST_CASE("a value that varies in a way that means nothing is refused where it stands",
          "[variation]") {
  const auto told = [](const std::string& load) {
    return problem_message([&] { static_cast<void>(parse_scene(block() + load, "name", ".")); });
  };
  const auto pressure = [&](const std::string& value) {
    return told("pressure = { top = " + value + " }\n");
  };
  CHECK_THAT(pressure("{ over = \"x\" }"),
             ContainsSubstring("expected either over and table, or polynomial"));
  CHECK_THAT(pressure("{ table = [[0, 1]] }"), ContainsSubstring("expected either over and table"));
  CHECK_THAT(pressure("{ over = \"z\", table = [[0, 1]] }"), ContainsSubstring("unknown word 'z'"));
  CHECK_THAT(pressure("{ over = \"x\", table = [[0, 1], [1]] }"),
             ContainsSubstring("expected a row [place, value], got a list of 1"));
  CHECK_THAT(pressure("{ over = \"x\", table = [[1, 1], [0, 1]] }"),
             ContainsSubstring("places must increase, but 0 follows 1"));
  CHECK_THAT(pressure("{ over = \"x\", table = [[1, 1], [1, 2], [1, 3]] }"),
             ContainsSubstring("stands there three times"));
  CHECK_THAT(pressure("{ over = \"x\", table = [[100, 1], [110, 2]] }"),
             ContainsSubstring("its rows go from 100 to 110, but 'top' goes from 0 to") &&
                 ContainsSubstring("it would be one number there"));
  CHECK_THAT(pressure("{ over = \"length\", table = [[-2, 1], [-1, 2]] }"),
             ContainsSubstring("its rows go from -2 to -1, but 'top' goes from 0 to"));
  CHECK_THAT(told("temperature = { varying = { over = \"y\", table = [[-9, 1], [-8, 2]] } }\n"),
             ContainsSubstring("its rows go from -9 to -8, but "));
  CHECK(pressure("{ over = \"y\", table = [[0, 1], [100, 2]] }").empty());  // of a level side
  CHECK_THAT(pressure("{ polynomial = [[1, 0.5, 0]] }"),
             ContainsSubstring("powers must be whole numbers"));
  CHECK_THAT(pressure("{ polynomial = [[1, 7, 7]] }"),
             ContainsSubstring("a sum of at most 13, got 7 and 7"));
  CHECK_THAT(pressure("{ polynomial = [[1, 2]] }"), ContainsSubstring("[c, i, j], for c x^i y^j"));
  CHECK_THAT(told("temperature = { varying = { over = \"length\", table = [[0, 1]] } }\n"),
             ContainsSubstring("a body has no length, only a boundary has"));
  CHECK_THAT(
      told("fixed = \"left\"\n[[contact]]\nsource = \"bottom\"\ntarget = { kind = \"half_plane\", "
           "point = [0, 0], normal = [0, 1] }\ninterference = { polynomial = [[-1, 1, 0]] }\n"),
      ContainsSubstring("expected a length >= 0 all along the source, got -"));
}
