#include <algorithm>

#include "addons/motion/moved_pairs.hpp"
#include "catch_compat.hpp"
#include "signorini/contact/kept_points.hpp"
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
    const Pairs plain = waves.at(places, false);
    const Pairs kept = waves.at(places, true);
    CHECK(plain.points.empty());
    CHECK(plain.jumps.empty());
    CHECK((plain.opening - kept.opening).norm() == 0);
    CHECK(plain.initial_gap == kept.initial_gap);
    // Points are all that a row knows.
    CHECK((held_rows(kept, places, places) - MatrixXd(kept.opening)).cwiseAbs().maxCoeff() <=
          1e-14);
    VectorXd gap = VectorXd::Zero(kept.weight.size());
    for (const KeptPoint& point : kept.points) gap(point.pair) += point.share * point.gap;
    CHECK((gap - kept.initial_gap).cwiseAbs().maxCoeff() <= 1e-15);
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
  CHECK(model.pairs.points.empty());
  place_bodies(scene, zero, zero, model, true);
  const Index first = std::count(model.contact_of.begin(), model.contact_of.end(), 0u);
  CHECK(first == 4);  // of five nodes the lowest is held
  MatrixXd N = MatrixXd::Zero(model.pairs.opening.rows(), model.pairs.opening.cols());
  Eigen::RowVectorXd row(N.cols());
  for (const KeptPoint& point : model.pairs.points) {
    row = N.row(point.pair);
    add_reading(point, point.share, row);
    N.row(point.pair) = row;
  }
  CHECK((N - MatrixXd(model.pairs.opening)).cwiseAbs().maxCoeff() <= 1e-14);
  CHECK(!model.pairs.jumps.empty());
  for (const KeptJump& jump : model.pairs.jumps) {
    CHECK(jump.before.pair >= first);
    CHECK(jump.behind.pair == jump.before.pair);
    // The node of the pair is one of those on whose edge the jump lies.
    const Index node = model.pairs.node[static_cast<std::size_t>(jump.before.pair)];
    CHECK(std::count(jump.before.source.node.begin(), jump.before.source.node.end(), node) == 1);
  }
}
