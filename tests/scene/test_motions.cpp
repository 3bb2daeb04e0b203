// Which motions contact holds, whatever the motions are measured in.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "meshes/ring.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/rigid_modes.hpp"

using namespace signorini;

TEST_CASE("a motion is held or not in whatever unit it is written", "[scene][floating][units]") {
  // Three motions of three unknowns; the contacts feel the first two.
  const Eigen::SparseMatrix<double, Eigen::RowMajor> A =
      Eigen::MatrixXd(Eigen::MatrixXd::Identity(2, 3)).sparseView();
  for (const double unit : {1.0, 1e-20}) {
    std::vector<FreeMotion> modes(3);
    for (int k = 0; k < 3; ++k) {
      modes[static_cast<std::size_t>(k)].body = std::to_string(k);
      modes[static_cast<std::size_t>(k)].motion = Eigen::Vector3d::UnitX();
      modes[static_cast<std::size_t>(k)].shape =
          Eigen::VectorXd(Eigen::Vector3d::Unit(k)).sparseView();
    }
    modes[1].shape *= unit;
    CHECK(motions_without_contact(A, modes) ==
          std::vector<std::string>{"2 can move freely in direction x"});
  }
}

TEST_CASE("the motion that contact leaves is named, be it along no axis", "[scene][floating]") {
  const double c = 0.6, s = 0.8;  // of the plane that a block lies on
  for (const double away : {0.0, 1e6}) {
    CAPTURE(away);
    Scene scene;
    scene.bodies.resize(1);
    scene.bodies[0].mesh =
        mapped(block("block", {0, 0}, {2, 1}, 4, 2), [&](const Eigen::Vector2d& x) {
          return Eigen::Vector2d(away + c * x.x() - s * x.y(), s * x.x() + c * x.y());
        });
    scene.contacts = {{{"bottom"}, half_plane({away, 0}, {-s, c})}};
    CHECK_THROWS_WITH(plan(scene),
                      ContainsSubstring("can move freely in direction (0.6, 0.8), and"));
  }
  // Two motions of one body are one; a body that hardly moves is not named.
  std::vector<FreeMotion> modes(3);
  modes[0].body = modes[1].body = "one";
  modes[2].body = "other";
  modes[0].motion = Eigen::Vector3d(1, 0, 0);
  modes[1].motion = Eigen::Vector3d(0, 0, 1);
  modes[2].motion = Eigen::Vector3d(0, 1, 0);
  using Words = std::vector<std::string>;
  CHECK(in_words(modes, Eigen::Vector3d(2, 1, 1e-7)) == Words{"one can turn freely about (0, 2)"});
  CHECK(in_words(modes, Eigen::Vector3d(-3, 0, 3)) ==
        Words{"one can move freely in direction x", "other can move freely in direction y"});
}

namespace {

using Map = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// A ring of 8 cells in one of 20, which is held: four of their nodes meet.
Scene ring_in_ring(const Map& map) {
  const auto body = [&map](const std::string& name, double inner, double outer,
                           Eigen::Index cells) {
    AnnulusSpec spec;
    spec.name = name;
    spec.inner_radius = inner;
    spec.outer_radius = outer;
    spec.cells_radius = 1;
    spec.cells_angle = cells;
    Body ring;
    ring.mesh = mapped(make_annulus(spec), map);
    ring.material = {3e5, 0.3};
    return ring;
  };
  Scene scene;
  scene.bodies = {body("around", 1, 1.5, 20), body("inside", 0.4, 1, 8)};
  scene.bodies[0].supports = {fixed("outer")};
  scene.contacts = {{{"inner", "around"}, Side{"outer", "inside"}}};
  return scene;
}

/// Which pairs the turn of the inner ring moves.
std::vector<bool> moved_by_turn(const Scene& scene) {
  const Plan planned = plan(scene);
  REQUIRE(planned.modes.size() == 3);
  const Eigen::MatrixXd R =
      rigid_gaps(contact_rows(planned.gaps, planned.law), mode_entries(planned.modes),
                 direction_rounding(planned.modes));
  std::vector<bool> moved;
  for (Eigen::Index pair = 0; pair < R.rows(); ++pair) moved.push_back(R(pair, 2) != 0);
  return moved;
}

}  // namespace

TEST_CASE(
    "a turn moves the same pairs wherever the bodies are, however they lie and how large they are",
    "[scene][floating][far]") {
  const std::vector<bool> expected =
      moved_by_turn(ring_in_ring([](const Eigen::Vector2d& x) { return x; }));
  REQUIRE(std::count(expected.begin(), expected.end(), false) == 4);  // where nodes meet
  for (const double size : {1e-3, 1.0, 1e3})
    for (const double away : {0.0, 1e3, 1e6})
      for (const double angle : {0.0, pi / 2, 0.3, 2.0}) {
        CAPTURE(size, away, angle);
        const double c = std::cos(angle), s = std::sin(angle);
        const Map map = [&](const Eigen::Vector2d& x) {
          return Eigen::Vector2d(size * (c * x.x() - s * x.y() + 0.6 * away),
                                 size * (s * x.x() + c * x.y() - 0.8 * away));
        };
        CHECK(moved_by_turn(ring_in_ring(map)) == expected);
      }
}
