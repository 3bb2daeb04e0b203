// What every gap operator promises of the meshes: their numbering, their ends, and meshes that make no sense.
#include "catch_compat.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "support/chosen.hpp"
#include "support/interfaces.hpp"
#include "support/message.hpp"
#include "support/two_blocks.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

constexpr double rounding = 1e-13;
const MeshOrder orders[] = {MeshOrder::Linear, MeshOrder::Quadratic};
const Form forms[] = {Form::Flat, Form::Inclined, Form::Curved};

TwoBodies swapped(const TwoBodies& bodies) {
  return {bodies.target, bodies.source, bodies.target_boundary, bodies.source_boundary};
}

bool same(const NodalRows& a, const NodalRows& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a - b).norm() == 0;
}

/// What an operator says of bodies that cannot touch.
std::string complaint(const GapOperator& member, const TwoBodies& bodies) {
  return problem_message([&] { static_cast<void>(pairs_of(member, bodies)); });
}

}  // namespace

TEST_CASE("every gap operator: source and target of the same extent weigh the same",
          "[conformance][gap_operators]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : orders)
      for (const Form form : {Form::Flat, Form::Inclined}) {
        CAPTURE(member.name, static_cast<int>(order), static_cast<int>(form));
        const TwoBodies bodies = two_blocks({0, 4, 7}, {0, 4, 10}, 0.01, form, order);
        const Pairs one = pairs_of(member, bodies);
        const Pairs two = pairs_of(member, swapped(bodies));
        CHECK(one.weight.sum() == Approx(0.5 * 4).epsilon(rounding));
        CHECK(two.weight.sum() == Approx(one.weight.sum()).epsilon(rounding));
        CHECK(one.unpaired.empty());
        CHECK(two.unpaired.empty());
      }
}

TEST_CASE("every gap operator: numbers of nodes and cells mean nothing",
          "[conformance][gap_operators]") {
  Random random(11);
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : orders)
      for (const Form form : forms) {
        CAPTURE(member.name, static_cast<int>(order), static_cast<int>(form));
        const TwoBodies bodies = two_blocks({-0.4, 3.4, 6}, {0, 4, 9}, 0, form, order);
        const auto source = shuffled(bodies.source.n_nodes(), random);
        const auto target = shuffled(bodies.target.n_nodes(), random);
        TwoBodies other = bodies;
        other.source = renumbered(bodies.source, source, shuffled(bodies.source.n_cells(), random));
        other.target = renumbered(bodies.target, target, shuffled(bodies.target.n_cells(), random));
        const Pairs one = pairs_of(member, bodies);
        const Pairs two = pairs_of(member, other);
        REQUIRE(two.opening.rows() == one.opening.rows());
        CHECK((two.initial_gap - one.initial_gap).norm() < rounding);
        CHECK((two.weight - one.weight).norm() < rounding);
        NodeArray u(all_nodes(bodies).rows(), 2);
        NodeArray v(u.rows(), 2);
        for (Index k = 0; k < u.rows(); ++k) {
          u.row(k) << random.uniform(-1, 1), random.uniform(-1, 1);
          const Index n = bodies.source.n_nodes();
          v.row(k < n ? source[static_cast<std::size_t>(k)]
                      : n + target[static_cast<std::size_t>(k - n)]) = u.row(k);
        }
        CHECK((two.opening * flat(v) - one.opening * flat(u)).norm() < rounding);
        CHECK((two.sliding * flat(v) - one.sliding * flat(u)).norm() < rounding);
        REQUIRE(two.unpaired.size() == one.unpaired.size());
        for (std::size_t k = 0; k < one.unpaired.size(); ++k)
          CHECK(two.unpaired[k] == source[static_cast<std::size_t>(one.unpaired[k])]);
        for (std::size_t k = 0; k < one.node.size(); ++k)
          CHECK(two.node[k] ==
                (one.node[k] < 0 ? -1 : source[static_cast<std::size_t>(one.node[k])]));
      }
}

TEST_CASE("every gap operator: the same question has the same answer, bit for bit",
          "[conformance][gap_operators]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : orders)
      for (const Form form : forms) {
        CAPTURE(member.name, static_cast<int>(order), static_cast<int>(form));
        const TwoBodies bodies = two_blocks({-0.4, 3.4, 6}, {0, 4, 9}, 0, form, order);
        const Pairs one = pairs_of(member, bodies);
        const Pairs two = pairs_of(member, bodies);
        CHECK(same(one.opening, two.opening));
        CHECK(same(one.sliding, two.sliding));
        CHECK(one.initial_gap == two.initial_gap);
        CHECK(one.weight == two.weight);
        CHECK(one.normal == two.normal);
      }
}

TEST_CASE("every gap operator: what overhangs the target has no pair and bears no force",
          "[conformance][gap_operators]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : orders) {
      CAPTURE(member.name, static_cast<int>(order));
      // Nodes of the source stand at both ends of the target, so that its sides are in or out.
      const TwoBodies bodies = two_blocks({-2, 3, 10}, {-1, 2, 7}, 0.1, Form::Inclined, order);
      const Pairs pairs = pairs_of(member, bodies);
      std::vector<Index> outside;
      for (const Index node : boundary_nodes(bodies.source, "bottom")) {
        const double x = turned(bodies.source.nodes.row(node).transpose(), -0.7).x();
        if (x < -1 - 1e-9 || x > 2 + 1e-9) outside.push_back(node);
      }
      CHECK(pairs.unpaired == outside);
      const VectorXd pressed = pairs.opening.transpose() * VectorXd::Ones(pairs.opening.rows());
      for (const Index node : outside) CHECK(pressed.segment<2>(2 * node).norm() == 0);
      for (Index row = 0; row < pairs.position.rows(); ++row) {
        const double x = turned(pairs.position.row(row).transpose(), -0.7).x();
        CHECK((x > -1 - 1e-9 && x < 2 + 1e-9));
      }
    }
}

TEST_CASE("every gap operator: bodies that cannot touch are refused by name",
          "[conformance][gap_operators]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : orders)
      for (const Form form : forms) {
        CAPTURE(member.name, static_cast<int>(order), static_cast<int>(form));
        const TwoBodies good = two_blocks({0, 4, 5}, {0, 4, 7}, 0.1, form, order);
        TwoBodies bad = good;
        bad.target_boundary = "bottom";
        CHECK_THAT(complaint(member, bad),
                   ContainsSubstring("both face the same way") && ContainsSubstring("'upper'") &&
                       ContainsSubstring("'lower'") && ContainsSubstring("'bottom'"));
        bad.source_boundary = "top";
        CHECK_THAT(complaint(member, bad), ContainsSubstring("no point of the first faces"));
        bad = two_blocks({6, 9, 5}, {0, 4, 7}, 0.1, form, order);
        CHECK_THAT(complaint(member, bad), ContainsSubstring("no point of the first faces"));
        bad = two_blocks({0, 4, 5}, {0, 4, 7}, -0.8, form, order);
        CHECK_THAT(complaint(member, bad), ContainsSubstring("lies inside 'lower'"));
        bad = good;
        bad.target_boundary = "lid";
        CHECK_THAT(complaint(member, bad), ContainsSubstring("has no boundary 'lid'"));
      }
}

TEST_CASE("every gap operator: an overlap that is smaller than the cells is a negative gap",
          "[conformance][gap_operators]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : orders) {
      CAPTURE(member.name, static_cast<int>(order));
      const Pairs pairs =
          pairs_of(member, two_blocks({0, 4, 5}, {0, 4, 7}, -0.3, Form::Inclined, order));
      CHECK((pairs.initial_gap.array() + 0.3).matrix().norm() < rounding);
    }
}

TEST_CASE("a gap operator is found by its name, an unknown one is answered with the family",
          "[gap_operators]") {
  for (const GapOperator& member : chosen(gap_operators()))
    CHECK(find_gap_operator(member.name).pair == member.pair);
  CHECK_THAT(problem_message([] { static_cast<void>(find_gap_operator("glue")); }),
             ContainsSubstring("'glue'") && ContainsSubstring("node_to_segment, gauss_points"));
}

// What node_to_segment and gauss_points say of themselves; pressures of Gauss points are not even unique.
TEST_CASE("every gap operator: a uniform pressure passes between two meshes, or else it says so",
          "[conformance][gap_operators][patch]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const char* element : {"q4", "q8"})
      for (const auto& [source, target] : {std::pair(8, 11), {11, 8}, {7, 15}, {7, 10}}) {
        CAPTURE(member.name, element, source, target);
        const double deviation = patch_test(member, {}, source, target, 0, 1, element);
        CHECK((member.passes_patch_test ? deviation <= 3e-13 : deviation > 0.02));
      }
}
