#include <cmath>

#include "catch_compat.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/fem/element.hpp"
#include "signorini/pairing/gauss_points.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/interfaces.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

const GapOperator& member() { return find_gap_operator("gauss_points"); }

Pairs with_points(const TwoBodies& bodies, int points) {
  GapOptions options = options_for(bodies);
  options.points = points;
  return pairs_of(member(), bodies, options);
}

/// Vertical component of a row for a node.
double up(const NodalRows& rows, Index row, Index node) { return rows.coeff(row, 2 * node + 1); }
double along(const NodalRows& rows, Index row, Index node) { return rows.coeff(row, 2 * node); }

}  // namespace

TEST_CASE("Gauss points lie on the source where its shape functions put them",
          "[gap_operators][LinEtAl-32][LinEtAl-37]") {
  const TwoBodies bodies =
      two_blocks({0.5, 3.5, 1}, {0, 4, 1}, 0.25, Form::Flat, MeshOrder::Linear);
  const Pairs pairs = with_points(bodies, 0);
  const double place = 1.5 / std::sqrt(3.0);
  REQUIRE(pairs.position.rows() == 2);
  CHECK((pairs.position.row(0) - RowVector2d(2 - place, 0.25)).norm() < 1e-15);
  CHECK((pairs.position.row(1) - RowVector2d(2 + place, 0.25)).norm() < 1e-15);
  CHECK((pairs.initial_gap.array() - 0.25).matrix().norm() < 1e-15);
  CHECK(pairs.node == std::vector<Index>{-1, -1});
}

TEST_CASE("a pressure at a Gauss point acts on half a side of source and target",
          "[gap_operators][LinEtAl-33][LinEtAl-34][LinEtAl-35][LinEtAl-36]") {
  const TwoBodies bodies =
      two_blocks({0.5, 3.5, 1}, {0, 4, 1}, 0.25, Form::Flat, MeshOrder::Linear);
  const Pairs pairs = with_points(bodies, 2);
  const double pressure = 7;
  const double force = pressure * pairs.weight(0);
  CHECK(force == Approx(pressure * 1.5 * 0.5).epsilon(1e-15));  // times the thickness
  const double N1 = (1 + 1 / std::sqrt(3.0)) / 2;
  CHECK(force * up(pairs.opening, 0, 0) == Approx(force * N1).epsilon(1e-15));
  CHECK(force * up(pairs.opening, 0, 1) == Approx(force * (1 - N1)).epsilon(1e-15));
  const Index first = bodies.source.n_nodes() + 2;  // the top of the target's two rows of cells
  const double N3 = 1 - (2 - 1.5 / std::sqrt(3.0)) / 4;
  CHECK(force * up(pairs.opening, 0, first + 2) == Approx(-force * N3).epsilon(1e-14));
  CHECK(force * up(pairs.opening, 0, first + 3) == Approx(-force * (1 - N3)).epsilon(1e-14));
}

TEST_CASE("friction at a Gauss point acts on the same nodes along the tangent",
          "[gap_operators][LinEtAl-38][LinEtAl-39][LinEtAl-40][LinEtAl-41]") {
  const TwoBodies bodies =
      two_blocks({0.5, 3.5, 1}, {0, 4, 1}, 0.25, Form::Flat, MeshOrder::Linear);
  const Pairs pairs = with_points(bodies, 2);
  for (Index row = 0; row < 2; ++row)
    for (Index node = 0; node < pairs.opening.cols() / 2; ++node) {
      CHECK(along(pairs.sliding, row, node) == up(pairs.opening, row, node));
      CHECK(up(pairs.sliding, row, node) == 0);
    }
}

TEST_CASE("one to six points on a side weigh the side", "[gap_operators]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic})
    for (int points = 1; points <= 6; ++points) {
      CAPTURE(static_cast<int>(order), points);
      const TwoBodies bodies = two_blocks({0.5, 3.5, 4}, {0, 4, 5}, 0.1, Form::Inclined, order);
      const Pairs pairs = with_points(bodies, points);
      CHECK(pairs.weight.size() == 4 * points);
      CHECK(pairs.weight.sum() == Approx(0.5 * 3).epsilon(1e-14));
      CHECK(pairs.unpaired.empty());
    }
  const TwoBodies bodies = two_blocks({0, 4, 4}, {0, 4, 5}, 0.1, Form::Flat, MeshOrder::Linear);
  for (const int points : {-1, 7})
    CHECK_THAT(problem_message([&] { static_cast<void>(with_points(bodies, points)); }),
               ContainsSubstring("1 to 6 points"));
}

TEST_CASE("more points than nodes say nothing new: 8 sides against 8 have rank 9",
          "[gap_operators]") {
  const TwoBodies bodies = two_blocks({0, 4, 8}, {0, 4, 8}, 0, Form::Flat, MeshOrder::Linear);
  for (int points = 2; points <= 6; ++points) {
    const Pairs pairs = with_points(bodies, points);
    CHECK(pairs.opening.rows() == 8 * points);
    CHECK(column_span(pairs.opening).rank == 9);
  }
}

// Two nodes on springs of compliance 1 overlap by 1 and are pulled apart by 0.2 each. Points at the ends
// can hold them, since they may carry all the pressure; a point in the middle cannot.
TEST_CASE("with friction, three points on a side have solutions that move the nodes differently",
          "[gap_operators][LinEtAl-42]") {
  const TwoBodies bodies = two_blocks({0.5, 3.5, 1}, {0, 4, 1}, 0, Form::Flat, MeshOrder::Linear);
  const Pairs pairs = with_points(bodies, 3);
  MatrixXd N(3, 2), S(3, 2);  // of the nodes of the source
  for (Index row = 0; row < 3; ++row)
    for (Index node = 0; node < 2; ++node) {
      N(row, node) = up(pairs.opening, row, node);
      S(row, node) = along(pairs.sliding, row, node);
    }
  ContactProblem problem;
  problem.compliance = MatrixXd::Zero(6, 6);
  problem.compliance.topLeftCorner(3, 3) = N * N.transpose();
  problem.compliance.bottomRightCorner(3, 3) = S * S.transpose();
  problem.free_gap = N * Eigen::Vector2d(-1, -1);
  problem.free_slip = S * Eigen::Vector2d(-0.2, 0.2);
  problem.law = law_of_all(Eigen::Vector3d(0.3, 0.3, 0.3), Eigen::Vector3d::Zero());
  const double held = 0.2 / std::sqrt(0.6);
  ContactState ends, middle;
  ends.force = Eigen::Vector3d(1, 0, 1);
  ends.friction = Eigen::Vector3d(held, 0, -held);
  middle.force = Eigen::Vector3d(0, 2, 0);
  middle.friction = Eigen::Vector3d::Zero();
  for (ContactState* state : {&ends, &middle}) {
    state->gap = problem.free_gap + N * (N.transpose() * state->force);
    state->slip = problem.free_slip + S * (S.transpose() * state->friction);
    CHECK(certify(problem, *state).worst() < 1e-14);
  }
  CHECK(ends.slip.norm() < 1e-15);
  CHECK(middle.slip(0) == Approx(-0.2 * std::sqrt(0.6)).epsilon(1e-14));
}

TEST_CASE("a side that hangs over in part keeps the points that face the target",
          "[gap_operators]") {
  const TwoBodies bodies = two_blocks({-1, 5, 3}, {0, 4, 5}, 0.1, Form::Flat, MeshOrder::Linear);
  const Pairs pairs = with_points(bodies, 2);
  CHECK(pairs.opening.rows() == 4);
  CHECK(pairs.unpaired.empty());
  const Pairs half =
      with_points(two_blocks({-4, 4, 4}, {0, 4, 5}, 0.1, Form::Flat, MeshOrder::Linear), 2);
  CHECK(half.unpaired == std::vector<Index>{0, 1});
}
