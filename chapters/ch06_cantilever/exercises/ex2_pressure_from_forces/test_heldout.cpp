#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/scene/scene.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex6_2::contact_line;
using ex6_2::ContactLine;
using signorini::MeshOrder;

namespace {

VectorXd list(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Index>(values.size()));
}

// x of the nodes of a boundary that runs to the right.
VectorXd positions(const signorini::Mesh& mesh, const std::string& name) {
  const std::vector<Index> nodes = signorini::boundary_nodes(mesh, name);
  return mesh.nodes(nodes, 0);
}

// The beam of Xuan & Li, sec. 4, example 2 (kN, cm), in coarse cells.
signorini::Scene cantilever(const std::string& element, MeshOrder order, Index cells) {
  signorini::Scene scene;
  signorini::Body& body = scene.bodies[0];
  body.mesh = signorini::block("block", {0, 0}, {50, 5}, cells, cells / 10, order);
  body.element = element;
  body.material = {2.1e4, 0.29, signorini::PlaneState::Stress, 1};
  body.supports = {signorini::fixed("left")};
  body.loads.edges = {{"top", 3.6, {}}};
  scene.contacts = {{{"bottom"}, signorini::half_plane({0, -1}, {0, 1})}};
  return scene;
}

}  // namespace

// The library's own loads, from a pressure of 2.5 on graded edges, 0.3 thick: up to both ends.
TEST_CASE("ex6.2 held out: a uniform pressure on uneven edges comes back", "[ex6.2]") {
  const MeshOrder order = GENERATE(MeshOrder::Linear, MeshOrder::Quadratic);
  signorini::BlockSpec block;
  block.size = {7, 1};
  block.cells_x = 6;
  block.grading_x = 9;
  block.order = order;
  const signorini::Mesh mesh = signorini::make_block(block);
  const signorini::Element& element =
      signorini::find_element(order == MeshOrder::Linear ? "q4" : "q8");
  const signorini::Material material{1, 0.3, signorini::PlaneState::Strain, 0.3};
  const signorini::NodeArray forces =
      signorini::nodal_loads(mesh, element, material, {{}, {{"bottom", 2.5, {}}}});
  const std::vector<Index> nodes = signorini::boundary_nodes(mesh, "bottom");
  const VectorXd upward = forces(nodes, 1);
  const ContactLine line = contact_line(positions(mesh, "bottom"), upward, order, 0.3);
  REQUIRE(line.pressure.size() == upward.size());
  CHECK((line.pressure.array() - 2.5).abs().maxCoeff() < 1e-13);
  CHECK(line.touchdown == 0);
}

// sqrt(x - 2.2) on quadratic edges of length 2, 1 and 4 that start at -1: weights by hand.
TEST_CASE("ex6.2 held out: touchdown on uneven quadratic edges", "[ex6.2]") {
  const VectorXd x = list({-1, 0, 1, 1.5, 2, 4, 6});
  const VectorXd weight = list({2, 8, 3, 4, 5, 16, 4}) / 6 * 0.5;
  const VectorXd p = 9 * (x.array() - 2.2).max(0).sqrt();
  const ContactLine line = contact_line(x, weight.cwiseProduct(p), MeshOrder::Quadratic, 0.5);
  REQUIRE(line.pressure.size() == 7);
  CHECK(equal_within(line.pressure, p, 1e-12));
  CHECK(line.touchdown == Approx(2.2).epsilon(1e-13));
}

TEST_CASE("ex6.2 held out: where the line through two squares says nothing", "[ex6.2]") {
  const VectorXd x = list({0, 1, 2, 3});
  const auto touchdown = [&x](const VectorXd& force) {
    return contact_line(x, force, MeshOrder::Linear, 1).touchdown;
  };
  CHECK(touchdown(list({0, 0, 0, 2})) == 3);                           // only the tip
  CHECK(touchdown(list({0, 4, 3, 1})) == 1);                           // the pressure falls
  CHECK(touchdown(list({0, 4, 4, 2})) == 1);                           // or stays
  CHECK(touchdown(list({1, 5, 6, 3})) == 0);                           // no node before
  CHECK(touchdown(list({0, 0, 4, 2.1})) == Approx(1).epsilon(1e-14));  // not before an open node
  CHECK(touchdown(list({0, 0, 1, 4})) == Approx(2 - 1.0 / 63).epsilon(1e-14));  // 64 against 1
}

// Whatever the mesh, the first closed node lies at x = 42.0; contact begins at 41.95 (own meshes of up
// to 400 x 40 cells).
TEST_CASE("ex6.2 held out: the touchdown of the cantilever", "[ex6.2]") {
  const auto [element, order] =
      GENERATE(table<std::string, MeshOrder>({std::make_tuple("q4_incompatible", MeshOrder::Linear),
                                              std::make_tuple("q8", MeshOrder::Quadratic)}));
  const signorini::Scene scene = cantilever(element, order, 50);
  const signorini::Solution solution = signorini::solve(scene);
  REQUIRE(solution.contact.report.status == signorini::SolveStatus::Solved);
  const VectorXd x = positions(scene.bodies[0].mesh, "bottom");
  VectorXd force = VectorXd::Zero(x.size());  // the clamped node at x = 0 has no pair
  force.tail(x.size() - 1) = solution.contact.force;
  const ContactLine line = contact_line(x, force, order, 1);
  REQUIRE(line.pressure.size() == x.size());
  CHECK(equal_within(line.pressure.tail(x.size() - 1), solution.pressure, 1e-10));
  CHECK(line.touchdown == Approx(41.95).margin(0.06));
}

TEST_CASE("ex6.2 held out: input that makes no boundary is refused", "[ex6.2]") {
  const VectorXd x = list({0, 1, 2, 3});
  const VectorXd zero = VectorXd::Zero(4);
  CHECK_THROWS_AS(contact_line(x, zero, MeshOrder::Quadratic, 1), std::invalid_argument);
  CHECK_THROWS_AS(contact_line(x, zero.head(3), MeshOrder::Linear, 1), std::invalid_argument);
  CHECK_THROWS_AS(contact_line(x.reverse(), zero, MeshOrder::Linear, 1), std::invalid_argument);
  CHECK_THROWS_AS(contact_line(x, zero, MeshOrder::Linear, 0), std::invalid_argument);
  CHECK_THROWS_AS(contact_line(x.head(1), zero.head(1), MeshOrder::Linear, 1),
                  std::invalid_argument);
}
