// Probes read what closed forms say, at any place of any mesh.
#include <cmath>

#include "addons/along/arc_length.hpp"
#include "addons/along/place_in_mesh.hpp"
#include "addons/along/probes.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "meshes/split.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/elements.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using signorini_test::problem_message;

namespace {

/// The values of a column.
Eigen::VectorXd column(const std::vector<PairColumn>& columns, const std::string& name) {
  for (const PairColumn& one : columns)
    if (one.name == name) return one.values;
  return {};
}

/// What the probes of a scene file read.
std::vector<std::vector<PairColumn>> read(const std::string& text) {
  const SceneFile file = parse_scene(text, "name", ".");
  const SolvedScene run = solved(file.scene, "name");
  return probed(run.model, run.solution, file.probes);
}

const std::string block =
    "material = { youngs_modulus = 1000, poisson_ratio = 0.25, state = \"plane stress\" }\n"
    "[[body]]\nname = \"block\"\nmesh = { kind = \"block\", size = [4, 1], cells = [4, 2] }\n";

}  // namespace

// Closed form: u = a + B x has the strain sym B everywhere, on any mesh and for any element.
TEST_CASE("a uniform strain is read exactly at points, along lines and along boundaries",
          "[probes][closed-form]") {
  const bool round = GENERATE(false, true);
  const bool quadratic = GENERATE(false, true);
  const bool triangles = GENERATE(false, true);
  CAPTURE(round, quadratic, triangles);
  DiscSpec disc_spec;
  disc_spec.radius = 2;
  if (quadratic) disc_spec.order = MeshOrder::Quadratic;
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = round ? make_disc(disc_spec)
                    : signorini::block("body", {-2, -2}, {4, 4}, 3, 5,
                                       quadratic ? MeshOrder::Quadratic : MeshOrder::Linear);
  if (triangles) body.mesh = split(body.mesh);
  body.material = {1000, 0.25, PlaneState::Stress};
  const auto u = [](const Vector2d& x) {
    return Vector2d(0.1 + 2e-3 * x.x() - 3e-3 * x.y(), -0.2 + 5e-3 * x.x() - 1e-3 * x.y());
  };
  for (const auto& named : body.mesh.boundaries)
    for (const Axis axis : {Axis::X, Axis::Y})
      body.supports.push_back(prescribed(named.first, axis, [u, axis](const Vector2d& x) {
        return u(x)(axis == Axis::X ? 0 : 1);
      }));
  Probe line{"line", "body"};
  line.points = points_between({-1.1, -0.7}, {1.3, 0.9}, 7);
  line.line = true;
  Probe edge{"edge", "body"};
  edge.along = body.mesh.boundaries.begin()->first;
  body.mesh.name = "body";
  const SolvedScene run = solved(scene, "patch");
  for (const auto& columns : probed(run.model, run.solution, {line, edge})) {
    const Eigen::VectorXd x = column(columns, "x");
    REQUIRE(x.size() >= 4);
    for (Index k = 0; k < x.size(); ++k) {
      const Vector2d at(x(k), column(columns, "y")(k));
      CHECK(column(columns, "displacement_x")(k) == Approx(u(at).x()).epsilon(1e-12));
      CHECK(column(columns, "displacement_y")(k) == Approx(u(at).y()).epsilon(1e-12));
      // E/(1-nu^2) (e_x + nu e_y), E/(1-nu^2) (e_y + nu e_x), G gamma; rounding of u over a cell, about 1e-15 / 0.5 of E.
      const double stiff = 1000 / (1 - 0.0625);
      CHECK(column(columns, "stress_xx")(k) == Approx(stiff * 1.75e-3).margin(1e-11));
      CHECK(column(columns, "stress_yy")(k) == Approx(stiff * -0.5e-3).margin(1e-11));
      CHECK(column(columns, "stress_xy")(k) == Approx(400 * 2e-3).margin(1e-11));
      CHECK(column(columns, "stress_zz")(k) == 0);
    }
  }
}

// Closed form: a bar of length 4, depth 1 and height 1 under 5 at its end. sigma = 5, u = sigma x / E; the wall bears -5 at
// the height 1/2. Springs of 10 per area at the other end would bear 10 u.
TEST_CASE("forces and moments of boundaries are those of equilibrium", "[probes][closed-form]") {
  const auto columns = read(block +
                            "symmetric = [\"left\", \"bottom\"]\ntraction = { right = [5, 0] }\n"
                            "spring = { right = [10, 0] }\n"
                            "[[probe]]\nof = \"left\"\n[[probe]]\nof = \"right\"\n"
                            "[[probe]]\nat = [1.3, 0.2]\n");
  const double stress = 5 / (1 + 10 * 4.0 / 1000);  // sigma + 10 u = 5, u = 4 sigma / E
  CHECK(column(columns[0], "support_force_x")(0) == Approx(-stress).epsilon(1e-12));
  CHECK(column(columns[0], "support_moment")(0) == Approx(stress / 2).epsilon(1e-12));
  CHECK(column(columns[0], "spring_force_x")(0) == 0);
  CHECK(column(columns[0], "contact_force_x").size() == 0);
  CHECK(column(columns[1], "spring_force_x")(0) == Approx(stress - 5).epsilon(1e-12));
  CHECK(column(columns[1], "spring_moment")(0) == Approx((5 - stress) / 2).epsilon(1e-12));
  CHECK(column(columns[1], "displacement_x")(0) == Approx(4 * stress / 1000).epsilon(1e-12));
  CHECK(column(columns[2], "displacement_x")(0) == Approx(1.3 * stress / 1000).epsilon(1e-12));
  CHECK(column(columns[2], "displacement_y")(0) ==
        Approx(-0.25 * 0.2 * stress / 1000).epsilon(1e-12));
  CHECK(column(columns[2], "von_mises")(0) == Approx(stress).epsilon(1e-12));
  CHECK(column(columns[2], "distance").size() == 0);
}

// Two such blocks, one glued on the other and pulled up by 5: the glue bears 5 everywhere, and pulls the lower one up as much.
TEST_CASE("forces of bonds are read on both sides", "[probes][closed-form]") {
  const auto columns = read(
      block +
      "symmetric = [\"left\", \"bottom\"]\n"
      "[[body]]\nname = \"upper\"\nmesh = { kind = \"block\", corner = [0, 1], size = [4, 1], cells = [4, 2] }\n"
      "symmetric = \"left\"\ntraction = { top = [0, 5] }\n"
      "[[tie]]\nsource = \"upper.bottom\"\ntarget = \"block.top\"\n"
      "[[probe]]\nbody = \"upper\"\nalong = \"bottom\"\n[[probe]]\nbody = \"block\"\nof = \"top\"\n");
  const Eigen::VectorXd pull = column(columns[0], "bond_force_y");
  REQUIRE(pull.size() == 5);
  for (Index k = 0; k < 5; ++k)
    CHECK(pull(k) == Approx(k == 0 || k == 4 ? -2.5 : -5).epsilon(1e-12));
  CHECK(column(columns[1], "bond_force_y")(0) == Approx(20).epsilon(1e-12));
  CHECK(column(columns[1], "bond_moment")(0) == Approx(40).epsilon(1e-12));
}

// Closed form: a block that is pressed by 3 rests with 3 on a floor that does not rub.
TEST_CASE("contact is read on the source and nowhere else", "[probes][contact]") {
  const auto columns =
      read(block +
           "symmetric = \"left\"\npressure = { top = 3 }\n"
           "[[contact]]\nsource = \"bottom\"\n"
           "target = { kind = \"half_plane\", point = [0, -0.01], normal = [0, 1] }\n"
           "[[probe]]\nalong = \"bottom\"\n[[probe]]\nfrom = [0.3, 0]\nto = [0.3, 1]\n"
           "points = 3\n[[probe]]\nof = \"bottom\"\n");
  const Eigen::VectorXd pressure = column(columns[0], "contact_pressure");
  REQUIRE(pressure.size() == 5);
  for (Index k = 0; k < 5; ++k) {
    CHECK(pressure(k) == Approx(3).epsilon(1e-12));
    CHECK(column(columns[0], "distance")(k) == Approx(k).epsilon(1e-15));
    CHECK(column(columns[0], "contact_force_y")(k) ==
          Approx(k == 0 || k == 4 ? 1.5 : 3).epsilon(1e-12));
  }
  const Eigen::VectorXd inside = column(columns[1], "contact_pressure");
  CHECK(inside(0) == Approx(3).epsilon(1e-12));
  CHECK(std::isnan(inside(1)));
  CHECK(std::isnan(inside(2)));
  CHECK(column(columns[1], "contact_gap")(0) == Approx(0).margin(1e-14));
  CHECK(column(columns[2], "contact_force_y")(0) == Approx(12).epsilon(1e-12));
  CHECK(column(columns[2], "contact_moment")(0) == Approx(24).epsilon(1e-12));
  CHECK(column(columns[2], "displacement_y")(0) == Approx(-0.01).epsilon(1e-12));
}

TEST_CASE("all probes are one table, empty where a probe reads nothing", "[probes]") {
  const std::string text = block +
                           "fixed = \"left\"\n[[probe]]\nname = \"tip\"\nat = [4, 1]\n"
                           "[[probe]]\nof = \"left\"\n";
  const SceneFile file = parse_scene(text, "name", ".");
  const SolvedScene run = solved(file.scene, "name");
  const auto table = table_of(file.probes, probed(run.model, run.solution, file.probes));
  CHECK(csv_head(table) ==
        "probe,x,y,displacement_x,displacement_y,stress_xx,stress_yy,stress_xy,stress_zz,von_mises,"
        "support_force_x,support_force_y,support_moment\n");
  CHECK(csv_lines(table) == "tip,4,1,0,0,0,0,0,0,0,,,\nprobe 2,,,0,0,,,,,,0,0,0\n");
}

TEST_CASE("a line through a hole has values where the body is, and none in the hole", "[probes]") {
  // A ring between 1 and 2, held outside, under pressure inside; three points are in the hole, one is beyond the ring.
  const SceneFile file = parse_scene(
      "[[body]]\nname = \"ring\"\nmaterial = { youngs_modulus = 1, poisson_ratio = 0 }\n"
      "mesh = { kind = \"ring\", inner_radius = 1, outer_radius = 2, cells = [64, 4] }\n"
      "fixed = \"outer\"\npressure = { inner = 1 }\n"
      "[[probe]]\nfrom = [-1.5, 0]\nto = [2.5, 0]\npoints = 9\n",
      "name", ".");
  const SolvedScene run = solved(file.scene, "ring");
  const auto columns = probed(run.model, run.solution, file.probes).front();
  const Eigen::VectorXd moved = column(columns, "displacement_x");
  const Eigen::VectorXd mises = column(columns, "von_mises");
  CHECK(column(columns, "x").isApprox(Eigen::VectorXd::LinSpaced(9, -1.5, 2.5)));
  CHECK(column(columns, "distance").isApprox(Eigen::VectorXd::LinSpaced(9, 0, 4)));
  for (const Eigen::Index row : {2, 3, 4, 8}) {
    CHECK(std::isnan(moved(row)));
    CHECK(std::isnan(mises(row)));
  }
  CHECK(moved(1) < 0);
  CHECK(moved(5) == Approx(-moved(1)));
  CHECK(moved(6) == Approx(-moved(0)));
  CHECK(moved(7) == 0);
  for (const Eigen::Index row : {0, 1, 5, 6, 7}) CHECK(mises(row) > 0);
  Probe close{"close", "ring"};
  close.points = points_between({0.95, 0}, {1.05, 0}, 3);
  close.line = true;
  const Eigen::VectorXd beside = column(probed(run.model, run.solution, {close}).front(), "displacement_x");
  CHECK(std::isnan(beside(0)));
  CHECK(beside(1) == Approx(moved(5)));
  // What the scene's mesh has, a finer one of a curved side may not have: that ends no run.
  Probe gone{"gone", "ring"};
  gone.points = Eigen::RowVector2d(0, 0);
  CHECK(std::isnan(column(probed(run.model, run.solution, {gone}).front(), "displacement_x")(0)));
}

// Closed form: the arc length of the parabola y = x^2 from 0 to 1 is sqrt(5)/2 + asinh(2)/4.
TEST_CASE("the length of a curved side is that of its parabola", "[probes][closed-form]") {
  Mesh mesh = signorini::block("body", {0, 0}, {1, 2}, 1, 1, MeshOrder::Quadratic);
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    if (mesh.nodes(node, 1) == 0) mesh.nodes(node, 1) = mesh.nodes(node, 0) * mesh.nodes(node, 0);
  const ArcLength length(mesh, "bottom");
  const double whole = std::sqrt(5) / 2 + std::asinh(2) / 4;
  CHECK(length.whole() == Approx(whole).epsilon(1e-12));
  const double half = std::sqrt(2) / 4 + std::asinh(1) / 4;  // to x = 1/2, where the slope is 1
  CHECK(length.at(Vector2d(0.5, 0.25)) == Approx(half).epsilon(1e-12));
}

TEST_CASE("a probe that says nothing, too much or a place that is not there is refused",
          "[probes]") {
  const auto told = [](const std::string& probe) {
    return problem_message(
        [&] { static_cast<void>(parse_scene(block + "fixed = \"left\"\n" + probe, "name", ".")); });
  };
  CHECK_THAT(
      told("[[probe]]\nat = [4.1, 1]\n"),
      ContainsSubstring("name:6: probe: the point (4.1, 1) is not in 'block': give one within its "
                        "mesh, such as the nearest node (4, 1)"));
  CHECK_THAT(told("[[probe]]\nat = [4.000001, 1]\n"),
             ContainsSubstring("the point (4.000001, 1) is not in"));
  CHECK_THAT(told("[[probe]]\nat = [40, 1]\n"), ContainsSubstring("is not in 'block'"));
  CHECK_THAT(told("[[probe]]\nfrom = [5, 0]\nto = [5, 1]\n"), ContainsSubstring("the point (5, 0) is not in 'block'"));
  CHECK_THAT(told("[[probe]]\nname = \"a\"\n"), ContainsSubstring("expected one place, got 0"));
  CHECK_THAT(told("[[probe]]\nat = [1, 1]\nof = \"left\"\n"),
             ContainsSubstring("expected one place, got 2"));
  CHECK_THAT(told("[[probe]]\nfrom = [1, 1]\n"), ContainsSubstring("needs both from and to"));
  CHECK_THAT(told("[[probe]]\nat = [1, 1]\npoints = 3\n"),
             ContainsSubstring("no meaning but for a line"));
  CHECK_THAT(told("[[probe]]\nfrom = [0, 0]\nto = [1, 1]\npoints = 1\n"),
             ContainsSubstring("a line has 2 points or more, got 1"));
  CHECK_THAT(told("[[probe]]\nalong = \"botom\"\n"), ContainsSubstring("botom"));
  CHECK_THAT(told("[[probe]]\nbody = \"blok\"\nat = [1, 1]\n"),
             ContainsSubstring("no body is called 'blok'; did you mean 'block'?"));
  CHECK_THAT(told("[[probe]]\nname = \"a\"\nat = [1, 1]\n[[probe]]\nname = \"a\"\nat = [1, 1]\n"),
             ContainsSubstring("another probe is called 'a' too"));
}
