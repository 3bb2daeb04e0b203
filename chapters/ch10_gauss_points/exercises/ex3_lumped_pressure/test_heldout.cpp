#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/random.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/readings.hpp"

using Eigen::Index;
using Eigen::VectorXd;

TEST_CASE("ex10.3 held out: points in any order, and no force is lost", "[ex10.3]") {
  signorini::Random random(1);
  const VectorXd nodes = VectorXd::LinSpaced(6, 0, 2);
  for (int sample = 0; sample < 50; ++sample) {
    VectorXd points(30), weight(30), force(30);
    for (Index k = 0; k < 30; ++k) {
      points(k) = random.uniform(0, 2);
      weight(k) = random.uniform(0.1, 1);
      force(k) = random.uniform(0, 1);
    }
    CAPTURE(sample);
    const VectorXd p = ex10_3::lumped_pressure(nodes, points, weight, force);
    // The shares are the pressures' factors: those of unit forces on nodes alone.
    VectorXd share = VectorXd::Zero(6);
    for (Index k = 0; k < 30; ++k)
      for (Index i = 0; i < 6; ++i)
        share(i) += weight(k) * std::max(0.0, 1 - std::abs(points(k) - nodes(i)) / 0.4);
    CHECK(std::abs(share.dot(p) - force.sum()) < 1e-12);
  }
}

TEST_CASE("ex10.3 held out: bang-bang pressures of two blocks become the uniform one",
          "[ex10.3][LinEtAl-37]") {
  using namespace signorini;
  for (const int points : {2, 3, 4, 6}) {
    BlockSpec spec;
    spec.cells_x = 6;
    spec.cells_y = 2;
    Scene scene;
    scene.bodies.resize(2);
    spec.name = "lower";
    scene.bodies[0].mesh = make_block(spec);
    scene.bodies[0].supports = {prescribed("bottom", Axis::Y, 0),
                                prescribed_at("bottom", {0, 0}, Axis::X)};
    spec.name = "upper";
    scene.bodies[1].mesh = moved(make_block(spec), {0, 1});
    scene.bodies[1].supports = {prescribed_at("top", {0, 2}, Axis::X)};
    scene.bodies[1].loads.edges = {{"top", 1, {}}};
    for (Body& body : scene.bodies) body.material = {1000, 0.3, PlaneState::Strain, 1};
    ContactSpec contact;
    contact.source = {"bottom", "upper"};
    contact.target = Side{"top", "lower"};
    contact.gap_operator = "gauss_points";
    contact.points = points;
    scene.contacts = {contact};
    scene.solver = find_solver("quasi_active_set");
    const SolvedScene run = solved(scene, "two blocks");
    const Pairs& pairs = run.model.pairs;
    const VectorXd p = ex10_3::lumped_pressure(VectorXd::LinSpaced(7, 0, 1), pairs.position.col(0),
                                               pairs.weight, run.solution.contact.force);
    CAPTURE(points);
    CHECK((p - VectorXd::Ones(7)).cwiseAbs().maxCoeff() < 1e-10);  // displacements round
  }
}
