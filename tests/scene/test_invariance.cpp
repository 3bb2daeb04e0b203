// What must not matter between two bodies: where they lie, how nodes are numbered, which one comes first.
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "support/facing_blocks.hpp"
#include "support/same_scenes.hpp"
#include "support/two_bodies.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Two blocks held at their far sides that overlap by 0.03 in the middle and not at the ends: no direction, no
/// side and no load is special.
Scene press_fit(MeshOrder order, const char* gap_operator) {
  Scene scene =
      two_blocks(named_block("lower", {-1.3, -1}, {2.5, 1}, 11, 4, order),
                 mapped(named_block("upper", {-1, 0}, {2.2, 1}, 8, 3, order),
                        [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
                          return {x.x(), x.y() + (1 - x.y()) * (0.05 * x.x() * x.x() - 0.03)};
                        }));
  scene.bodies[1].supports = {fixed("top")};
  scene.contacts[0].gap_operator = gap_operator;
  return scene;
}

/// Forces of contact on the nodes of both bodies.
std::vector<NodeArray> forces(const Scene& scene) {
  const SolvedScene run = solved(scene, "the blocks");
  REQUIRE(run.solution.contact.report.iterations > 1);
  std::vector<NodeArray> both;
  for (std::size_t body = 0; body < 2; ++body)
    both.push_back(contact_forces(run.model, run.solution, body));
  return both;
}

void compare(const std::vector<NodeArray>& now, const std::vector<NodeArray>& before,
             double margin) {
  for (std::size_t body = 0; body < 2; ++body)
    CHECK((now[body] - before[body]).cwiseAbs().maxCoeff() <=
          margin * before[body].cwiseAbs().maxCoeff());
}

}  // namespace

TEST_CASE("forces between two bodies turn with them, and are mirrored with them", "[invariance]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic})
    for (const char* gap_operator : {"mortar", "node_to_segment", "gauss_points"}) {
      CAPTURE(gap_operator);
      const Scene scene = press_fit(order, gap_operator);
      const std::vector<NodeArray> before = forces(scene);
      for (const double degrees : {30.0, 90.0, 137.0}) {
        CAPTURE(degrees);
        const double angle = degrees * pi / 180;
        Scene rotated = scene;
        for (Body& body : rotated.bodies) body.mesh = turned(body.mesh, angle);
        std::vector<NodeArray> back = forces(rotated);
        const Eigen::Rotation2D<double> turn(-angle);
        for (NodeArray& force : back) force = force * turn.toRotationMatrix().transpose();
        compare(back, before, 1e-12);
      }
      Scene image = scene;
      for (Body& body : image.bodies) body.mesh = mirrored(body.mesh, MirrorLine::Upright, 0.7);
      std::vector<NodeArray> back = forces(image);
      for (NodeArray& force : back) force.col(0) *= -1;
      compare(back, before, 1e-12);
      Scene far = scene;
      for (Body& body : far.bodies) body.mesh = moved(body.mesh, {1000, -300});
      compare(forces(far), before,
              1e-9);  // positions are rounded to the distance, over an overlap of 0.03
    }
}

TEST_CASE("forces between two bodies do not depend on numbers", "[invariance]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic})
    for (const char* gap_operator : {"mortar", "node_to_segment", "gauss_points"}) {
      CAPTURE(gap_operator);
      const Scene scene = press_fit(order, gap_operator);
      const std::vector<NodeArray> before = forces(scene);
      const Renumbered other = renumbered(scene, 7);
      std::vector<NodeArray> back = forces(other.scene);
      for (std::size_t b = 0; b < 2; ++b) back[b] = back[b](other.place[b], Eigen::all).eval();
      compare(back, before, 1e-12);

      Scene swapped = scene;
      std::swap(swapped.bodies[0], swapped.bodies[1]);
      back = forces(swapped);
      std::swap(back[0], back[1]);
      compare(back, before, 1e-12);
    }
}

// On a flat interface in a uniform state both choices of the source are exact with segments; in another state they
// are two discretisations of one problem, and differ by what the mesh does.
TEST_CASE("source and target may change places", "[invariance]") {
  const auto sum = [](Scene scene, bool swap) {
    if (swap) scene.contacts = {{{"top", "lower"}, Side{"bottom", "upper"}}};
    const SolvedScene run = solved(scene, "the blocks");
    return std::make_pair(run.solution.contact.force.sum(), run.solution.displacements[1]);
  };
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    Scene scene = two_blocks(named_block("lower", {0, -1}, {2, 1}, 11, 4, order),
                             named_block("upper", {0, 0}, {2, 1}, 8, 3, order));
    scene.bodies[0].supports = {prescribed("bottom", Axis::Y, 0), symmetric("left")};
    scene.bodies[1].supports = {prescribed("top", Axis::Y, -0.01), symmetric("left")};
    const auto uniform = sum(scene, false);
    CHECK((sum(scene, true).second - uniform.second).cwiseAbs().maxCoeff() <= 1e-15);
    CHECK(sum(scene, true).first == Approx(uniform.first).epsilon(1e-13));
    scene.bodies[0].supports = {fixed("bottom")};
    CHECK(sum(scene, true).first == Approx(sum(scene, false).first).epsilon(1e-3));
    CHECK(sum(scene, true).first != Approx(sum(scene, false).first).epsilon(1e-9));
  }
}
