#include <algorithm>

#include "addons/motion/kept_points.hpp"
#include "addons/motion/moved_pairs.hpp"
#include "catch_compat.hpp"
#include "signorini/scene/bodies.hpp"
#include "support/moving_blocks.hpp"
#include "support/waves.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("pairs keep points if they are asked to, and are the same pairs", "[motion]") {
  for (const MeshOrder order : orders) {
    const Waves waves({9, 7, order, order, 0.01});
    const NodeArray places = waves.places();
    const Pairs plain = waves.at(places);
    KeptPoints kept;
    const Pairs pairs = waves.at(places, &kept);
    CHECK((plain.opening - pairs.opening).norm() == 0);
    CHECK(plain.initial_gap == pairs.initial_gap);
    // Points are all that a row knows.
    CHECK((held_rows(waves, places, places) - MatrixXd(pairs.opening)).cwiseAbs().maxCoeff() <=
          1e-14);
    VectorXd gap = VectorXd::Zero(pairs.weight.size());
    for (const KeptPoint& point : kept.points) gap(point.pair) += point.share * point.gap;
    CHECK((gap - pairs.initial_gap).cwiseAbs().maxCoeff() <= 1e-15);
    CHECK(!kept.jumps.empty());
  }
}

// Of the first contact a pair is dropped, and the pairs of the second come after those of the first.
TEST_CASE("points keep the numbers of their pairs among all of a scene", "[motion]") {
  Scene scene = moving_blocks();
  scene.contacts.insert(scene.contacts.begin(), {{"right", "base"}, disc({9, 0.5}, 2)});
  Ledger ledger;
  Model model = build(scene, ledger);
  const NodeArray zero = NodeArray::Zero(count_nodes(model.bodies), 2);
  model.loop->place(zero, zero, model);
  KeptPoints kept;
  place_bodies(scene, zero, zero, model, &kept);
  const Index first = std::count(model.contact_of.begin(), model.contact_of.end(), 0u);
  CHECK(first == 4);  // of five nodes the lowest is held
  MatrixXd N = MatrixXd::Zero(model.pairs.opening.rows(), model.pairs.opening.cols());
  Eigen::RowVectorXd row(N.cols());
  for (const KeptPoint& point : kept.points) {
    row = N.row(point.pair);
    add_reading(point, point.share, row);
    N.row(point.pair) = row;
  }
  CHECK((N - MatrixXd(model.pairs.opening)).cwiseAbs().maxCoeff() <= 1e-14);
  CHECK(!kept.jumps.empty());
  for (const KeptJump& jump : kept.jumps) {
    CHECK(jump.before.pair >= first);
    CHECK(jump.behind.pair == jump.before.pair);
    // The node of the pair is one of those on whose edge the jump lies.
    const Index node = model.pairs.node[static_cast<std::size_t>(jump.before.pair)];
    CHECK(std::count(jump.before.source.node.begin(), jump.before.source.node.end(), node) == 1);
  }
}
