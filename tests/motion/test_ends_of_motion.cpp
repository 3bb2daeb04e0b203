// Bodies that move, where little is left: no load, no unknown, no pair, a vertex, a turn of a shaft.
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "addons/equations/equations.hpp"
#include "addons/files/scene_file.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/bodies.hpp"
#include "support/message.hpp"

using namespace signorini;
using signorini_test::problem_message;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// A path that was walked, and its last step.
struct Walked {
  PathEnd end;
  Step last;
  Model model;
};

Walked walked(const std::string& text) {
  Walked all;
  const Scene scene = parse_scene(text, "name", ".").scene;
  all.end = solve_steps(scene, [&](const Model& model, const Step& step) {
    all.last = step;
    all.model = model;
  });
  return all;
}

std::string block(const std::string& name, const std::string& mesh, const std::string& law) {
  return "[[body]]\nname = \"" + name + "\"\nelement = \"q4\"\nmesh = { kind = \"block\", " + mesh +
         " }\nmaterial = { youngs_modulus = 1000, poisson_ratio = 0.35" + law + " }\n";
}

const std::string rubber = ", law = \"neo_hooke\"";
const std::string ground =
    "[[contact]]\nsource = \"bottom\"\ntarget = { kind = \"half_plane\", point = [0, 0], normal = [0, 1] }\n";

double largest_force(const Walked& all) { return all.last.solution.contact.force.lpNorm<Eigen::Infinity>(); }

}  // namespace

TEST_CASE("bodies that are pressed and let go bear nothing, as if they had never moved", "[motion]") {
  const std::string law = GENERATE(as<std::string>(), "", rubber);
  const std::string friction = GENERATE(as<std::string>(), "", "friction = 0.3\n");
  CAPTURE(law, friction);
  const Walked all = walked("moves = true\n" + block("block", "size = [1.5, 1], cells = [3, 2]", law) +
                            "prescribed = { top = { x = 0, y = -0.002, history = \"press\" } }\n" + ground +
                            friction + "[[steps]]\ncount = 2\nvalues = { press = 1 }\n[[steps]]\ncount = 2\nvalues = { press = 0 }\n");
  CAPTURE(all.end.reason);
  REQUIRE(all.end.status == SolveStatus::Solved);
  CHECK(all.end.state.steps == 4);
  CHECK(all.last.solution.certificate.holds());
  CHECK(largest_force(all) < 1e-25);  // of 1000 times an area of .25
}

TEST_CASE("a body that is dragged along another one that it just touches is left alone", "[motion]") {
  const double way = GENERATE(0.25, 0.3, 0.5, 1.0);
  CAPTURE(way);
  const Walked all = walked(
      "moves = true\n" + block("base", "size = [3, 1], cells = [6, 2]", rubber) + "fixed = \"bottom\"\n" +
      block("block", "corner = [1.05, 1], size = [1.5, 1], cells = [3, 2]", rubber) +
      "prescribed = { top = { x = " + std::to_string(way) + ", y = 0, history = \"drag\" } }\n" +
      "[[contact]]\nsource = \"block.bottom\"\ntarget = \"base.top\"\n[[steps]]\nvalues = { drag = 1 }\n");
  CAPTURE(all.end.reason);
  REQUIRE(all.end.status == SolveStatus::Solved);
  CHECK(largest_force(all) < 1e-25);
}

TEST_CASE("a cell without a free unknown goes through all its steps", "[motion]") {
  const std::string state = GENERATE(as<std::string>(), "", ", state = \"plane stress\"");
  const Walked all = walked(block("block", "size = [1, 1], cells = [1, 1]", rubber + state) +
                            "prescribed = { top = { x = 0, y = 0.1, history = \"a\" } }\nfixed = \"bottom\"\n[[steps]]\ncount = 3\nvalues = { a = 1 }\n");
  REQUIRE(all.end.status == SolveStatus::Solved);
  CHECK(all.end.state.steps == 3);
  CHECK(all.last.solution.displacements[0].maxCoeff() == 0.1);
}

// By bisection of the stress across: mu (F - 1/F) + lambda ln(s^2 F) / F = 0 for the stretches s along both axes.
TEST_CASE("a sheet of rubber is stretched to three times its sides", "[motion][closed-form]") {
  const double nu = GENERATE(0.3, 0.45, 0.49, 0.499);
  const int count = GENERATE(1, 4, 10);
  CAPTURE(nu, count);
  std::string text = block("sheet", "size = [2, 1], cells = [4, 2]", rubber + ", state = \"plane stress\"");
  text.replace(text.find("0.35"), 4, std::to_string(nu));
  const Walked all = walked(text + "prescribed = { top = { y = 2, history = \"a\" }, right = { x = 4, history = \"a\" } }\n" +
                            "symmetric = [\"left\", \"bottom\"]\n[[steps]]\ncount = " + std::to_string(count) +
                            "\nvalues = { a = 1 }\n");
  CAPTURE(all.end.reason);
  REQUIRE(all.end.status == SolveStatus::Solved);
  const double ratio = 2 * nu / (1 - 2 * nu);  // lambda over mu
  double low = 0, high = 1;
  for (int k = 0; k < 200; ++k) {
    const double F = (low + high) / 2;
    (F * F - 1 + ratio * std::log(9 * F) > 0 ? high : low) = F;
  }
  // The true stress along the sheet: mu (s^2 - 1) / J + lambda ln J / J, and nothing across.
  const double J = 9 * low, mu = 1000 / (2 * (1 + nu));
  const double stress = mu * (8 + ratio * std::log(J)) / J;
  const NodeArray forces = support_forces(all.model, all.last.solution, 0);
  const Mesh& mesh = all.model.bodies[0].mesh;
  double top = 0;
  for (const Index node : boundary_nodes(mesh, "top")) top += forces(node, 1);
  CHECK(top == Approx(stress * 6 * low).epsilon(1e-9));
}

TEST_CASE("what a later step cannot do keeps the steps before it, and is no bad input", "[motion][errors]") {
  std::string text = block("sheet", "size = [2, 1], cells = [4, 2]",
                           ", law = \"st_venant_kirchhoff\", state = \"plane stress\"");
  const Walked all = walked(text + "prescribed = { top = { y = 2, history = \"a\" }, right = { x = 4, history = \"a\" } }\n" +
                            "symmetric = [\"left\", \"bottom\"]\n[[steps]]\ncount = 8\nvalues = { a = 1 }\n");
  CHECK(all.end.status != SolveStatus::Solved);
  CHECK(all.end.state.steps > 0);
  CHECK_THAT(all.end.reason, ContainsSubstring("no strain across"));
}

TEST_CASE("a body that nothing holds is not said to be unstable", "[motion][errors]") {
  const Walked all = walked("moves = true\n" + block("block", "size = [1.5, 1], cells = [3, 2]", rubber) +
                            "symmetric = \"left\"\npressure = { top = { value = -1, history = \"pull\" } }\n" + ground +
                            "[[steps]]\nvalues = { pull = 1 }\n");
  CHECK(all.end.status != SolveStatus::Solved);
  CHECK_THAT(all.end.reason, ContainsSubstring("can move freely in direction y"));
  CHECK_THAT(all.end.reason, !ContainsSubstring("stability"));
}

TEST_CASE("a body that is pressed until a cell inverts is told so, and not that nothing presses", "[motion][errors]") {
  const Walked all = walked("moves = true\nhalvings = 0\n" +
                            block("block", "size = [1.5, 1], cells = [3, 2]", ", law = \"st_venant_kirchhoff\"") +
                            "symmetric = \"left\"\npressure = { top = { value = 5000, history = \"press\" } }\n" + ground +
                            "[[steps]]\nvalues = { press = 1 }\n");
  CHECK(all.end.status != SolveStatus::Solved);
  CHECK_THAT(all.end.reason, !ContainsSubstring("Turn the load round"));
}

TEST_CASE("forces and moments of a tie that has moved are those of its supports", "[motion][ties]") {
  const std::string cells = GENERATE(as<std::string>(), "[1, 2]", "[3, 2]", "[4, 2]");
  CAPTURE(cells);
  const Walked all = walked(block("low", "size = [2, 1], cells = [4, 2]", rubber) + "fixed = \"bottom\"\n" +
                            block("up", "corner = [0, 1], size = [2, 1], cells = " + cells, rubber) +
                            "prescribed = { top = { x = 0.8, y = -0.4, history = \"a\" } }\n" +
                            "[[tie]]\nsource = \"up.bottom\"\ntarget = \"low.top\"\n[[steps]]\ncount = 8\nvalues = { a = 1 }\n");
  CAPTURE(all.end.reason);
  REQUIRE(all.end.status == SolveStatus::Solved);
  const NodeArray forces = support_forces(all.model, all.last.solution, 0);
  const Mesh& mesh = all.model.bodies[0].mesh;
  Eigen::Vector2d force(0, 0);
  double moment = 0;
  for (const Index node : boundary_nodes(mesh, "bottom")) {
    const Eigen::RowVector2d x = mesh.nodes.row(node), f = forces.row(node);
    force += f.transpose();
    moment += x.x() * f.y() - x.y() * f.x();
  }
  const BondForces tie = bond_forces(all.model, all.last.solution).front();
  CHECK((tie.force - force).norm() < 1e-10 * force.norm());
  CHECK(tie.moment == Approx(moment).epsilon(1e-10));
}

namespace {

/// A rubber pad over the tip of a wedge, pressed and then dragged.
Walked over_a_tip(double drag, int cells) {
  const std::string of = ", law = \"neo_hooke\" }\n";
  return walked("moves = true\n[[body]]\nname = \"wedge\"\nelement = \"q4\"\nmesh = { kind = \"block\", size = [1, 1], cells = [4, 4], corner = [-1, -1], turn = 45 }\n"
                "material = { youngs_modulus = 10, poisson_ratio = 0.3" + of + "fixed = [\"left\", \"bottom\"]\n"
                "[[body]]\nname = \"pad\"\nelement = \"q4\"\nmesh = { kind = \"block\", corner = [-1, 0.01], size = [2, 1], cells = [" +
                std::to_string(cells) + ", 4] }\nmaterial = { youngs_modulus = 1, poisson_ratio = 0.3" + of +
                "prescribed = { top = [{ x = " + std::to_string(drag) + ", history = \"drag\" }, { y = -0.15, history = \"press\" }] }\n"
                "[[contact]]\nsource = \"pad.bottom\"\ntarget = [\"wedge.right\", \"wedge.top\"]\nfriction = 0.8\n"
                "[[steps]]\ncount = 2\nvalues = { press = 1 }\n[[steps]]\nvalues = { drag = 1 }\n[[steps]]\nvalues = { drag = 1, press = 1.5 }\n");
}

/// What friction bears in all.
double dragged(const Walked& all) {
  const VectorXd& friction = all.last.solution.contact.friction;
  double sum = 0;
  for (Index k = 0; k < friction.size(); ++k) {
    const Index pair = all.model.law.pair[static_cast<std::size_t>(k)];
    sum += friction(k) * all.model.pairs.normal(pair, 1) +
           all.last.solution.contact.force(pair) * all.model.pairs.normal(pair, 0);
  }
  return sum;
}

}  // namespace

TEST_CASE("a pad over the tip of a wedge is the mirror of itself", "[motion][symmetry]") {
  const int cells = GENERATE(8, 9);
  CAPTURE(cells);
  const Walked right = over_a_tip(0.02, cells), left = over_a_tip(-0.02, cells);
  REQUIRE(right.end.status == SolveStatus::Solved);
  REQUIRE(left.end.status == SolveStatus::Solved);
  REQUIRE(dragged(right) != 0);
  CHECK(dragged(right) == Approx(-dragged(left)).epsilon(1e-11));
  CHECK(right.last.state.dissipation.sum() == Approx(left.last.state.dissipation.sum()).epsilon(1e-10).margin(1e-15));
  const VectorXd& one = right.last.state.slip;
  const VectorXd& other = left.last.state.slip;
  CHECK((one + other.reverse()).lpNorm<Eigen::Infinity>() < 1e-11);
}

// Closed form: the inner side of a ring that is shrunk on a shaft stands on its circle before and after a turn.
TEST_CASE("a ring slides along its shaft by the arc, and not by the sine of it", "[motion][friction][closed-form]") {
  Step shrunk, turned;
  const Scene scene = parse_scene(
      "[[body]]\nname = \"ring\"\nmesh = { kind = \"ring\", inner_radius = 0.97, outer_radius = 1.5, cells = [24, 3] }\n"
      "element = \"q4\"\nmaterial = { youngs_modulus = 1, poisson_ratio = 0.3, law = \"neo_hooke\" }\n"
      "prescribed = { outer = { x = { polynomial = [[-0.45969769413186023, 1, 0], [-0.8414709848078965, 0, 1]] }, "
      "y = { polynomial = [[0.8414709848078965, 1, 0], [-0.45969769413186023, 0, 1]] }, history = \"turn\" } }\n"
      "[[contact]]\nsource = \"inner\"\ntarget = { kind = \"disc\", radius = 1.0 }\nfriction = 0.1\n"
      "[[steps]]\nvalues = { turn = 0 }\n[[steps]]\nvalues = { turn = 1 }\n",
      "name", ".").scene;
  const PathEnd end = solve_steps(scene, [&](const Model&, const Step& step) { (step.state.steps == 1 ? shrunk : turned) = step; });
  CAPTURE(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  const Mesh& mesh = scene.bodies[0].mesh;
  const std::vector<Index> nodes = boundary_nodes(mesh, "inner");
  const VectorXd& slip = turned.state.slip;
  REQUIRE(slip.size() == static_cast<Index>(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Eigen::RowVector2d a = mesh.nodes.row(nodes[k]) + shrunk.solution.displacements[0].row(nodes[k]);
    const Eigen::RowVector2d b = mesh.nodes.row(nodes[k]) + turned.solution.displacements[0].row(nodes[k]);
    const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    CHECK(angle > 0.9);
    CHECK(-slip(static_cast<Index>(k)) == Approx(angle).epsilon(1e-12));
  }
}

// A block that hardly moves: its gaps are 1e-12 of what it moves by, so they are far less than the rounding of its sides.
TEST_CASE("a stiff block rests on a slope, and bears its weight there", "[motion][friction]") {
  const double modulus = GENERATE(1e3, 1e5, 1e7, 1e9, 1e11);
  const std::string target = GENERATE(as<std::string>(), "\"ramp.top\"",
                                      "{ kind = \"polyline\", points = [[-2, -0.35], [2, 0.35]] }");
  CAPTURE(modulus, target);
  const double slope = std::atan2(0.35, 2.0);
  std::ostringstream scene;
  scene << std::setprecision(17) << "moves = true\nmaterial = { youngs_modulus = " << modulus
        << ", poisson_ratio = 0.3 }\n[[body]]\nname = \"ramp\"\nmesh = { kind = \"block\", corner = [-2, -0.5], "
        << "size = [4, 0.5], cells = [16, 2], turn = " << slope * 180 / pi
        << " }\nfixed = \"bottom\"\n[[body]]\nname = \"block\"\nmesh = { kind = \"block\", corner = [-0.5, 0], "
        << "size = [1, 0.5], cells = [4, 1], turn = " << slope * 180 / pi
        << " }\nbody_force = { value = [0, -1], history = \"weight\" }\n[[contact]]\nsource = \"block.bottom\"\n"
        << "target = " << target << "\nfriction = 0.7\n[[steps]]\nvalues = { weight = 1 }\n";
  const Walked all = walked(scene.str());
  INFO(all.end.reason);
  REQUIRE(all.end.status == SolveStatus::Solved);
  CHECK(all.end.halvings == 0);
  CHECK(all.last.solution.certificate.holds());
  const Resultants sum = resultants(all.model, all.last.solution, {});
  CHECK(sum.force.x() == Approx(0).margin(1e-12));
  CHECK(sum.force.y() == Approx(0.5).epsilon(1e-12));
}

// Lifted off, a body slips by less in every step that holds it still: by 1e-20, 1e-40, and so on.
TEST_CASE("a body that was lifted off is held still for as long as one likes", "[motion][friction]") {
  const std::string law = GENERATE(as<std::string>(), rubber, ", law = \"st_venant_kirchhoff\"");
  CAPTURE(law);
  const Walked all = walked(block("block", "size = [0.5, 0.5], cells = [3, 3]", law) +
                            "prescribed = { top = { x = 0, y = -0.015, history = \"press\" } }\n" + ground +
                            "friction = { law = \"tresca\", cohesion = 0.02 }\n[[steps]]\ncount = 2\nvalues = { press = 1 }\n"
                            "[[steps]]\nvalues = { press = -0.3 }\n[[steps]]\ncount = 8\nvalues = { press = -0.3 }\n");
  INFO(all.end.reason);
  REQUIRE(all.end.status == SolveStatus::Solved);
  CHECK(all.end.halvings == 0);
  CHECK(largest_force(all) == 0);
}

TEST_CASE("small strain that turns a cell inside out is refused", "[motion][errors]") {
  const Walked all = walked("moves = true\n" + block("block", "size = [2, 1], cells = [4, 2]", "") +
                            "prescribed = { top = { x = 0, y = -1.5, history = \"press\" } }\n" + ground +
                            "[[steps]]\ncount = 4\nvalues = { press = 1 }\n");
  CHECK(all.end.status == SolveStatus::TurnedTooFar);
  CHECK_THAT(all.end.reason, ContainsSubstring("is turned inside out"));
  CHECK(all.end.state.time == 0.5);
}

// The gap of a pin is that of a place in the mesh, which a body that moves leaves.
TEST_CASE("a pin in a hole is no obstacle for bodies that move, and a disc in its place is",
          "[motion][errors]") {
  const auto pushed = [](const std::string& moves, const std::string& target) {
    return moves +
           "[[body]]\nmesh = { kind = \"plate_with_hole\", hole_radius = 5, size = [20, 20], cells = [24, 6] }\n"
           "material = { youngs_modulus = 1000, poisson_ratio = 0.3 }\n"
           "prescribed = { left = { x = 0.03, y = 0, history = \"p\" }, right = { x = 0.03, y = 0, history = \"p\" } }\n"
           "[[contact]]\nsource = \"hole\"\ntarget = { " +
           target + " }\n[[steps]]\nvalues = { p = 1 }\n";
  };
  const std::string pin = "kind = \"pin_in_hole\", clearance = 0.01";
  CHECK_THAT(problem_message([&] { walked(pushed("moves = true\n", pin)); }),
             ContainsSubstring("made for small movements") && ContainsSubstring("kind = \"disc\""));
  const Walked still = walked(pushed("", pin));
  const Walked disc = walked(pushed("moves = true\n", "kind = \"disc\", radius = 4.99"));
  const double force = resultants(still.model, still.last.solution, {}).force.x();
  CHECK(force == Approx(-36.9).epsilon(1e-3));
  CHECK(resultants(disc.model, disc.last.solution, {}).force.x() == Approx(force).epsilon(3e-3));
}

// Back at rest the nodes of a relation are where they were, but for the last digits of two doubles, and so are its sides.
TEST_CASE("what a relation holds comes back to rest, and stays there", "[motion]") {
  const std::string law = GENERATE(as<std::string>(), rubber, ", law = \"st_venant_kirchhoff\"");
  CAPTURE(law);
  const Walked all = walked(block("up", "size = [1, 0.8], cells = [4, 3]", law) +
                            "fixed = \"bottom\"\nprescribed = { top = { y = -0.05, x = 0.02, history = \"p\" } }\n"
                            "[[relation]]\nterms = { side = \"right\", point = [1, 0.26666666666666666], along = [0.6, 0.8] }\n"
                            "[[steps]]\ncount = 2\nvalues = { p = 1 }\n[[steps]]\ncount = 4\nvalues = { p = 0 }\n"
                            "[[steps]]\ncount = 2\n");
  INFO(all.end.reason);
  REQUIRE(all.end.status == SolveStatus::Solved);
  CHECK(all.end.halvings == 0);
  CHECK(all.last.solution.displacements[0].cwiseAbs().maxCoeff() <= 1e-20);
}
