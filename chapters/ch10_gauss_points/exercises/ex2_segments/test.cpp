#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Integrals of the shape functions of all nodes: what a pressure of 1 puts on them.
VectorXd shares(const VectorXd& nodes) {
  VectorXd share = VectorXd::Zero(nodes.size());
  for (Index i = 0; i + 1 < nodes.size(); ++i)
    share.segment(i, 2).array() += 0.5 * (nodes(i + 1) - nodes(i));
  return share;
}

const VectorXd two_edges = VectorXd::LinSpaced(3, 0, 2);
const VectorXd three_edges = VectorXd::LinSpaced(4, 0, 2);

}  // namespace

TEST_CASE("ex10.2 nodes that meet see each other only", "[ex10.2]") {
  const Eigen::MatrixXd P = ex10_2::projection(three_edges, three_edges);
  CHECK(equal_within(P, Eigen::MatrixXd::Identity(4, 4), 1e-14));
}

TEST_CASE("ex10.2 two edges above three", "[ex10.2]") {
  const Eigen::MatrixXd P = ex10_2::projection(two_edges, three_edges);
  REQUIRE(P.rows() == 3);
  CHECK(equal_within(P.row(1), Eigen::RowVector4d(-2, 11, 11, -2) / 18, 1e-14));
}

TEST_CASE("ex10.2 the patch test: a uniform pressure puts on the target what it should",
          "[ex10.2][LinEtAl-36]") {
  VectorXd uneven(5);
  uneven << 0, 0.3, 0.5, 1.6, 2;
  for (const VectorXd& target : {two_edges, three_edges, uneven}) {
    const Eigen::MatrixXd P = ex10_2::projection(two_edges, target);
    CHECK(equal_within(P.transpose() * shares(two_edges), shares(target), 1e-14));
  }
}
