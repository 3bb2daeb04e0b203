// Everything a user can get wrong is named before anything is computed.
#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/scene/scene.hpp"
#include "support/cantilever.hpp"
#include "support/message.hpp"

using Eigen::Vector2d;
using namespace signorini;

namespace {

/// What planning and solving say about the cantilever after `change`; both must say the same.
template <typename Change>
std::string complaint(Change&& change) {
  Scene scene = signorini_test::cantilever("q4_incompatible", 10, 2);
  change(scene);
  const std::string planned =
      signorini_test::problem_message([&] { static_cast<void>(plan(scene)); });
  const std::string solved =
      signorini_test::problem_message([&] { static_cast<void>(solve(scene)); });
  CHECK(planned == solved);
  return solved;
}

}  // namespace

TEST_CASE("the scene that the bad ones are made from is sound", "[input]") {
  CHECK(complaint([](Scene&) {}).empty());
}

TEST_CASE("bad input: an inverted cell", "[input]") {
  CHECK_THAT(complaint([](Scene& s) {
               s.bodies[0].mesh.cells.row(7) = s.bodies[0].mesh.cells.row(7).reverse().eval();
             }),
             ContainsSubstring("mesh 'beam': cell 7 is inverted"));
}

TEST_CASE("bad input: a boundary side of zero length", "[input]") {
  CHECK_THAT(complaint([](Scene& s) {
               const auto nodes =
                   s.bodies[0].mesh.side_nodes(s.bodies[0].mesh.boundaries.at("top")[3]);
               s.bodies[0].mesh.nodes.row(nodes[0]) = s.bodies[0].mesh.nodes.row(nodes[1]);
             }),
             ContainsSubstring("side 3 of the boundary 'top'") && ContainsSubstring("zero length"));
}

TEST_CASE("bad input: Poisson's ratio one half in plane strain", "[input]") {
  CHECK_THAT(complaint([](Scene& s) {
               s.bodies[0].material.poisson_ratio = 0.5;
               s.bodies[0].material.state = PlaneState::Strain;
             }),
             ContainsSubstring("Poisson's ratio 0.5") && ContainsSubstring("q4_bbar"));
}

TEST_CASE("bad input: a negative Young's modulus", "[input]") {
  CHECK_THAT(complaint([](Scene& s) { s.bodies[0].material.youngs_modulus = -21000; }),
             ContainsSubstring("body 'beam'") &&
                 ContainsSubstring("Young's modulus must be positive, got -21000"));
}

TEST_CASE("bad input: a layer without its region, even one of the same material", "[input]") {
  CHECK_THAT(complaint([](Scene& s) {
               s.bodies[0].layers = {{"coat", s.bodies[0].material}};
             }),
             ContainsSubstring("mesh 'beam' has no region 'coat'"));
}

TEST_CASE("bad input: numbers of scales that no solver takes are the fault of the scene",
          "[input]") {
  Scene scene = signorini_test::cantilever("q4", 10, 2);
  scene.bodies[0].material.youngs_modulus = 1e200;
  CHECK_THAT(signorini_test::problem_message([&] { static_cast<void>(solve(scene)); }),
             ContainsSubstring("in these units: contact problem: pair 1") &&
                 ContainsSubstring("look for a modulus"));
}

TEST_CASE("bad input: a free body, with its direction", "[input]") {
  CHECK_THAT(complaint([](Scene& s) {
               s.contacts.clear();
               s.bodies[0].supports = {symmetric("left")};
             }),
             ContainsSubstring("body 'beam'") && ContainsSubstring("freely in direction y") &&
                 !ContainsSubstring("direction x") && ContainsSubstring("add a support"));
  CHECK_THAT(complaint([](Scene& s) {
               s.contacts.clear();
               s.bodies[0].supports.clear();
             }),
             ContainsSubstring("direction x") && ContainsSubstring("direction y") &&
                 ContainsSubstring("turn freely"));
}

TEST_CASE("bad input: a support, a load or contact on an unknown boundary", "[input]") {
  CHECK_THAT(complaint([](Scene& s) { s.bodies[0].supports.push_back(fixed("clamp")); }),
             ContainsSubstring("no boundary 'clamp'") && ContainsSubstring("bottom, left"));
  CHECK_THAT(complaint([](Scene& s) {
               s.bodies[0].loads.edges.push_back({"roof", 1, {}});
             }),
             ContainsSubstring("no boundary 'roof'"));
  CHECK_THAT(complaint([](Scene& s) { s.contacts[0].source.boundary = "belly"; }),
             ContainsSubstring("no boundary 'belly'"));
}

TEST_CASE("bad input: a profile that is not finite", "[input]") {
  CHECK_THAT(complaint([](Scene& s) {
               s.contacts[0].target =
                   profile([](double x) { return -1 - 1 / (x - 25); }, [](double) { return 0.0; });
             }),
             ContainsSubstring("'profile'") && ContainsSubstring("x = 25"));
}

TEST_CASE("bad input: a contact boundary that is also fixed", "[input]") {
  CHECK_THAT(complaint([](Scene& s) { s.bodies[0].supports.push_back(fixed("bottom")); }),
             ContainsSubstring("contact boundary 'bottom' is also held"));
}

TEST_CASE("bad input: a held node inside the obstacle", "[input]") {
  CHECK_THAT(complaint([](Scene& s) {
               s.contacts[0].target = half_plane({0, 0.5}, {0, 1});
             }),
             ContainsSubstring("is held by supports and overlaps by 0.5"));
}

TEST_CASE("bad input: a node that is moved into the obstacle, or to it", "[input]") {
  const auto said = [](double floor, double down) {
    return complaint([&](Scene& s) {
      s.bodies[0].supports = {prescribed("left", Axis::Y, down), prescribed("left", Axis::X, 0)};
      s.contacts[0].target = half_plane({0, floor}, {0, 1});
    });
  };
  CHECK_THAT(said(-0.25, -0.5), ContainsSubstring("a rigid half plane: the pair at (0, 0)") &&
                                    ContainsSubstring("overlaps by 0.25"));
  CHECK(said(-0.5, -0.5).empty());  // just touches
}

TEST_CASE("bad input: unknown names", "[input]") {
  CHECK_THAT(complaint([](Scene& s) { s.bodies[0].element = "q9"; }),
             ContainsSubstring("unknown element 'q9'") && ContainsSubstring("q8"));
  CHECK_THAT(
      complaint([](Scene& s) { s.solver = {}; }),
      ContainsSubstring("members of their families") && ContainsSubstring("find_solver(name)"));
}

TEST_CASE("bad input: supports that contradict each other", "[input]") {
  CHECK_THAT(
      complaint([](Scene& s) { s.bodies[0].supports.push_back(prescribed("top", Axis::Y, -1.0)); }),
      ContainsSubstring("support on 'top'") && ContainsSubstring("another support gives it 0"));
}

TEST_CASE("bad input: an element that does not fit the cells", "[input]") {
  CHECK_THAT(complaint([](Scene& s) { s.bodies[0].element = "q8"; }),
             ContainsSubstring("cells of 4 nodes") && ContainsSubstring("q8 needs 8"));
}

TEST_CASE("bad input: a load that is not finite", "[input]") {
  Scene scene = signorini_test::cantilever("q4", 10, 2);
  scene.bodies[0].loads.edges[0].pressure = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(signorini_test::problem_message([&] { static_cast<void>(solve(scene)); }),
             ContainsSubstring("load on 'top'") && ContainsSubstring("not finite"));
}

TEST_CASE("bad input: more pairs than the solver accepts", "[input]") {
  Scene scene = signorini_test::cantilever("q4", 20, 2);
  scene.solver = find_solver("enumerate");
  const std::string said = signorini_test::problem_message([&] { static_cast<void>(plan(scene)); });
  CHECK_THAT(said, ContainsSubstring("solver 'enumerate' takes at most 12 pairs, here are 20") &&
                       ContainsSubstring("take the default, 'primal_dual_active_set'"));
}
