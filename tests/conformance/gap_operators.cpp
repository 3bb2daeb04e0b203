// What every gap operator promises, whatever the two meshes and the place and size of the bodies.
#include "signorini/contact/gap_operators.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/fem/side_curve.hpp"
#include "support/chosen.hpp"
#include "support/interfaces.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Rounding of sums of a few hundred terms of size one.
constexpr double rounding = 1e-13;

const Extent coarse{0.31, 3.47, 5};
const Extent fine{0, 4, 11};

using Check = std::function<void(const GapOperator&, const TwoBodies&)>;

/// Calls `check` for every member, linear and quadratic sides, straight, inclined and curved
/// interfaces, and either mesh as the source.
void for_every_interface(double gap, const Check& check) {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic})
      for (const Form form : {Form::Flat, Form::Inclined, Form::Curved})
        for (const bool finer_source : {false, true}) {
          CAPTURE(member.name, static_cast<int>(order), static_cast<int>(form), finer_source);
          const Extent& source = finer_source ? fine : coarse;
          const Extent& target = finer_source ? coarse : fine;
          check(member, two_blocks(source, target, gap, form, order));
        }
}

TwoBodies moved(const TwoBodies& bodies, const std::function<Vector2d(const Vector2d&)>& map) {
  TwoBodies other = bodies;
  other.source = mapped(bodies.source, map);
  other.target = mapped(bodies.target, map);
  return other;
}

VectorXd some_forces(Index n) {
  Random random(5);
  VectorXd force(n);
  for (double& value : force) value = random.uniform(0.2, 1);
  return force;
}

Vector2d resultant(const NodeArray& nodes, const VectorXd& force, double& moment) {
  Vector2d sum = Vector2d::Zero();
  moment = 0;
  for (Index k = 0; k < nodes.rows(); ++k) {
    const Vector2d f = force.segment<2>(2 * k);
    sum += f;
    moment += nodes(k, 0) * f.y() - nodes(k, 1) * f.x();
  }
  return sum;
}

/// Largest change of the normal from a side of either body to the next, at their middles [-].
double largest_turn(const TwoBodies& bodies) {
  double largest = 0;
  for (const auto& [mesh, boundary] : {std::pair(&bodies.source, bodies.source_boundary),
                                       {&bodies.target, bodies.target_boundary}}) {
    const std::vector<SideCurve> sides = side_curves(*mesh, boundary);
    for (std::size_t k = 1; k < sides.size(); ++k)
      largest = std::max(largest, (sides[k].normal(0) - sides[k - 1].normal(0)).norm());
  }
  return largest;
}

/// Every pair of columns turned by an angle.
MatrixXd turned_rows(const NodalRows& rows, double angle) {
  MatrixXd other = MatrixXd(rows);
  for (Index k = 0; k < other.cols(); k += 2)
    for (Index row = 0; row < other.rows(); ++row)
      other.block<1, 2>(row, k) = turned(other.block<1, 2>(row, k).transpose(), angle).transpose();
  return other;
}

}  // namespace

TEST_CASE("every gap operator: where the bodies are and which way they are turned does not matter",
          "[conformance][gap_operators]") {
  for_every_interface(0.01, [](const GapOperator& member, const TwoBodies& bodies) {
    const double angle = 2.1;
    const Vector2d shift(3, -7);
    const Pairs here = pairs_of(member, bodies);
    const Pairs there = pairs_of(member, moved(bodies, [&](const Vector2d& x) -> Vector2d {
                                   return turned(x, angle) + shift;
                                 }));
    REQUIRE(there.opening.rows() == here.opening.rows());
    CHECK((there.initial_gap - here.initial_gap).norm() < rounding);
    CHECK((there.weight - here.weight).norm() < rounding);
    CHECK((MatrixXd(there.opening) - turned_rows(here.opening, angle)).norm() < 10 * rounding);
    CHECK((MatrixXd(there.sliding) - turned_rows(here.sliding, angle)).norm() < 10 * rounding);
    CHECK(there.node == here.node);
    CHECK(there.unpaired == here.unpaired);
    for (Index row = 0; row < here.normal.rows(); ++row) {
      const Vector2d n = here.normal.row(row).transpose();
      const Vector2d x = here.position.row(row).transpose();
      CHECK((there.normal.row(row).transpose() - turned(n, angle)).norm() < rounding);
      CHECK((there.position.row(row).transpose() - turned(x, angle) - shift).norm() < rounding);
    }
  });
}

TEST_CASE("every gap operator: gaps grow with the bodies, weights with their square, N and S not",
          "[conformance][gap_operators]") {
  for_every_interface(0.01, [](const GapOperator& member, const TwoBodies& bodies) {
    for (const double scale : {1e-3, 1e3}) {
      const TwoBodies other = moved(bodies, [&](const Vector2d& x) { return Vector2d(scale * x); });
      GapOptions options = options_for(other);
      const Pairs small = pairs_of(member, bodies);
      options.depth.factor *= scale;
      const Pairs large = pairs_of(member, other, options);
      REQUIRE(large.opening.rows() == small.opening.rows());
      CHECK((large.initial_gap / scale - small.initial_gap).norm() < rounding);
      CHECK((large.weight / (scale * scale) - small.weight).norm() < rounding);
      CHECK((large.opening - small.opening).norm() < 10 * rounding);
      CHECK((large.sliding - small.sliding).norm() < 10 * rounding);
    }
  });
}

TEST_CASE("every gap operator: both bodies moved alike open and slide nothing",
          "[conformance][gap_operators]") {
  for_every_interface(0.01, [](const GapOperator& member, const TwoBodies& bodies) {
    const Pairs pairs = pairs_of(member, bodies);
    const Index n = bodies.source.n_nodes();
    NodeArray u = NodeArray::Zero(all_nodes(bodies).rows(), 2);
    u.rowwise() += Eigen::RowVector2d(0.6, -1.1);
    CHECK((pairs.opening * flat(u)).norm() < rounding);
    CHECK((pairs.sliding * flat(u)).norm() < rounding);
    u.bottomRows(u.rows() - n).setZero();
    const VectorXd opened = pairs.opening * flat(u);
    const VectorXd slid = pairs.sliding * flat(u);
    // A mean n = sum_k w_k n_k of unit normals with sum_k w_k = 1 has |n|^2 = 1 - sum_kl w_k w_l |n_k - n_l|^2 / 2: one where
    // all are the same. Where they turn once by delta, the sum is 2 w (1 - w) delta^2, and a part of an edge has -1/3 to 4/3 of
    // the integral of its linear dual function: |n|^2 is between 1 - delta^2/4 and 1 + 4 delta^2/9, so |n| may exceed one.
    const double turn = largest_turn(bodies);
    for (Index row = 0; row < opened.size(); ++row) {
      const Vector2d normal = pairs.normal.row(row).transpose();
      CHECK(normal.squaredNorm() >= 1 - turn * turn / 4 - rounding);
      CHECK(normal.squaredNorm() <= 1 + 4 * turn * turn / 9 + rounding);
      CHECK(std::abs(opened(row) - (0.6 * normal.x() - 1.1 * normal.y())) <= 10 * rounding);
      CHECK(std::abs(slid(row) - (0.6 * normal.y() + 1.1 * normal.x())) <= 10 * rounding);
    }
  });
}

TEST_CASE("every gap operator: over a straight interface one body opens all gaps by its motion",
          "[conformance][gap_operators]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
      CAPTURE(member.name, static_cast<int>(order));
      const TwoBodies bodies = two_blocks(coarse, fine, 0.25, Form::Inclined, order);
      const Pairs pairs = pairs_of(member, bodies);
      const Vector2d n = turned({0, 1}, 0.7);
      const Vector2d t(n.y(), -n.x());
      CHECK((pairs.initial_gap.array() - 0.25).matrix().norm() < rounding);
      CHECK((pairs.normal.rowwise() - n.transpose()).norm() < rounding);
      CHECK(pairs.unpaired.empty());
      CHECK(pairs.weight.sum() == Approx(0.5 * 3.16).epsilon(rounding));
      for (const Vector2d& motion : {n, t}) {
        NodeArray u = NodeArray::Zero(all_nodes(bodies).rows(), 2);
        u.bottomRows(bodies.target.n_nodes()).rowwise() += motion.transpose();
        CHECK(((pairs.opening * flat(u)).array() + motion.dot(n)).matrix().norm() < rounding);
        CHECK(((pairs.sliding * flat(u)).array() + motion.dot(t)).matrix().norm() < rounding);
      }
    }
}

TEST_CASE("every gap operator: contact forces are in balance, and so are their moments",
          "[conformance][gap_operators]") {
  for_every_interface(0.05, [](const GapOperator& member, const TwoBodies& bodies) {
    const Pairs pairs = pairs_of(member, bodies);
    const VectorXd force = some_forces(pairs.opening.rows());
    double moment = 0;
    CHECK(resultant(all_nodes(bodies), pairs.opening.transpose() * force, moment).norm() <
          rounding * force.sum());
    CHECK(std::abs(moment) < 10 * rounding * force.sum());
    CHECK(resultant(all_nodes(bodies), pairs.sliding.transpose() * force, moment).norm() <
          rounding * force.sum());
  });
}

TEST_CASE(
    "every gap operator: the forces on the nodes of a side add up to what is told of the pair",
    "[conformance][gap_operators]") {
  for_every_interface(0.05, [](const GapOperator& member, const TwoBodies& bodies) {
    const Pairs pairs = pairs_of(member, bodies);
    const NodeArray nodes = all_nodes(bodies);
    const Index n = bodies.source.n_nodes();
    for (Index row = 0; row < pairs.opening.rows(); ++row)
      for (const bool normal : {true, false}) {
        const VectorXd entries = (normal ? pairs.opening : pairs.sliding).row(row).transpose();
        const Vector2d out = pairs.normal.row(row).transpose();
        const Vector2d direction = normal ? out : Vector2d(out.y(), -out.x());
        const Vector2d x = pairs.position.row(row).transpose();
        const double here = x.x() * direction.y() - x.y() * direction.x();
        double moment = 0;
        const Vector2d source = resultant(nodes.topRows(n), entries.head(2 * n), moment);
        CHECK((source - direction).norm() < 10 * rounding);
        CHECK(std::abs(moment - here - pairs.moment(row, normal ? 0 : 1)) < 10 * rounding);
        const Index m = nodes.rows() - n;
        const Vector2d target = resultant(nodes.bottomRows(m), entries.tail(2 * m), moment);
        CHECK((target + direction).norm() < 10 * rounding);
        CHECK(std::abs(moment + here - pairs.target_moment(row, normal ? 0 : 1)) < 10 * rounding);
      }
  });
}

TEST_CASE("every gap operator: friction has no moment where the bodies touch",
          "[conformance][gap_operators]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
      CAPTURE(member.name, static_cast<int>(order));
      const TwoBodies bodies = two_blocks(coarse, fine, 0, Form::Inclined, order);
      const Pairs pairs = pairs_of(member, bodies);
      const VectorXd force = some_forces(pairs.opening.rows());
      double moment = 0;
      static_cast<void>(resultant(all_nodes(bodies), pairs.sliding.transpose() * force, moment));
      CHECK(std::abs(moment) < 10 * rounding * force.sum());
    }
}

TEST_CASE("every gap operator: S is written only if it is asked for",
          "[conformance][gap_operators]") {
  for_every_interface(0.01, [](const GapOperator& member, const TwoBodies& bodies) {
    const Pairs pairs = pairs_of(member, bodies, options_for(bodies, false));
    CHECK(pairs.sliding.nonZeros() == 0);
    CHECK(pairs.sliding.rows() == pairs.opening.rows());
    CHECK(pairs.sliding.cols() == pairs.opening.cols());
  });
}
