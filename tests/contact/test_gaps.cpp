// Pairs of several contacts, one below the other.
#include <cmath>
#include <utility>
#include <vector>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/contact/node_to_obstacle.hpp"
#include "signorini/core/rounding.hpp"

using Eigen::Index;
using namespace signorini;

namespace {

Gaps five_gaps() {
  const Mesh mesh = block("block", {0, 0}, {4, 1}, 4, 1);
  const Surface source{mesh, "bottom"};
  GapOptions options;
  options.n_nodes = mesh.n_nodes();
  return reduce(node_to_obstacle(source, half_plane({0, -0.5}, {0, 1}), options), source,
                number_unknowns(mesh, {}));
}

}  // namespace

TEST_CASE(
    "contacts below each other keep all pairs and all unpaired nodes, also of one without pairs",
    "[gaps]") {
  const Gaps full = five_gaps();
  Gaps none = full;
  none.pairs = {};
  none.pairs.position.resize(0, 2);
  none.pairs.normal.resize(0, 2);
  none.A.resize(0, full.A.cols());
  none.T.resize(0, full.A.cols());
  none.pairs.unpaired = {3, 7};
  Gaps other = full;
  other.pairs.unpaired = {9};
  for (const Gaps& both : {stacked(none, other), stacked(other, none)}) {
    CHECK(both.pairs.unpaired.size() == 3);
    CHECK(both.pairs.node == full.pairs.node);
    CHECK(both.pairs.position == full.pairs.position);
    CHECK(both.A.cols() == full.A.cols());
    CHECK(both.pairs.opening.cols() == full.pairs.opening.cols());
    CHECK((Eigen::MatrixXd(both.A) - Eigen::MatrixXd(full.A)).norm() == 0);
    CHECK((Eigen::MatrixXd(both.pairs.opening) - Eigen::MatrixXd(full.pairs.opening)).norm() == 0);
  }
  CHECK(stacked(none, other).pairs.unpaired == std::vector<Index>{3, 7, 9});
  const Gaps empty = stacked(none, none);
  CHECK(empty.A.rows() == 0);
  CHECK(empty.A.cols() == full.A.cols());
  const Gaps twice = stacked(full, full);
  CHECK(twice.pairs.initial_gap.size() == 10);
  CHECK(twice.A.bottomRows(5).isApprox(full.A));
}

TEST_CASE("any number of contacts is stacked in their order", "[gaps]") {
  const Gaps full = five_gaps();
  for (const int contacts : {1, 2, 3, 7}) {
    std::vector<Gaps> all;
    Gaps one_by_one = full;
    for (int k = 0; k < contacts; ++k) {
      all.push_back(full);
      all.back().pairs.initial_gap.array() += k;
      one_by_one = k == 0 ? all.back() : stacked(one_by_one, all.back());
    }
    const Gaps together = stacked(std::move(all));
    CAPTURE(contacts);
    CHECK(together.pairs.initial_gap == one_by_one.pairs.initial_gap);
    CHECK(together.pairs.node == one_by_one.pairs.node);
    CHECK((Eigen::MatrixXd(together.A) - Eigen::MatrixXd(one_by_one.A)).norm() == 0);
  }
}

TEST_CASE("rows are the same matrix in whatever order their entries come", "[gaps]") {
  using Entries = std::vector<Eigen::Triplet<double>>;
  const NodalRows rows = rows_of(Entries{{2, 1, 4}, {0, 3, 1}, {2, 0, 3}, {0, 3, 0.5}}, 4, 1000);
  CHECK(rows.rows() == 4);
  CHECK(rows.cols() == 1000);
  CHECK(rows.nonZeros() == 3);
  CHECK(rows.coeff(0, 3) == 1.5);
  CHECK(rows.coeff(2, 0) == 3);
  CHECK(rows.coeff(2, 1) == 4);
  CHECK(rows.isCompressed());
  CHECK(rows_of({}, 2, 5).nonZeros() == 0);
}

TEST_CASE(
    "what supports leave of a normal is rounding where coordinates are rounded, and no movement",
    "[gaps][far]") {
  const Mesh mesh = block("block", {0, 0}, {4, 1}, 4, 1);
  const Surface source{mesh, "bottom"};
  GapOptions options;
  options.n_nodes = mesh.n_nodes();
  const double tilt = 1e-10;
  const Pairs pairs =
      node_to_obstacle(source, half_plane({0, -0.5}, {tilt, std::sqrt(1 - tilt * tilt)}), options);
  const Unknowns unknowns = number_unknowns(mesh, {prescribed_at("bottom", {0, 0}, Axis::Y)});
  const auto count = [&](double directions) {
    return reduce(pairs, source, unknowns, directions).A.rows();
  };
  CHECK(count(0) == 5);
  CHECK(count(epsilon) == 5);
  CHECK(count(1e6 * epsilon) == 4);
}
