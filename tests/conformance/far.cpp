// What every element and every gap operator promises far from the origin: where coordinates keep their digits,
// nothing changes, not in the last bit.
#include "support/far.hpp"

#include "catch_compat.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "support/chosen.hpp"
#include "support/interfaces.hpp"
#include "support/meshes.hpp"

using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

constexpr double grid = 0x1p-26;
const Vector2d shifts[] = {{0x1p20, 0}, {-1e6, 0.75e6}, {0, 123456.75}};

TwoBodies moved(const TwoBodies& bodies, const Vector2d& shift) {
  return {signorini::moved(bodies.source, shift), signorini::moved(bodies.target, shift)};
}

}  // namespace

TEST_CASE("every element: stiffness far from the origin is the same, bit for bit",
          "[conformance][far]") {
  const Material steel{21000, 0.29, PlaneState::Strain, 1};
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    CellNodes nodes = distorted_cell(element);
    for (Eigen::Index k = 0; k < nodes.rows(); ++k)
      nodes.row(k) = rounded(nodes.row(k).transpose(), grid).transpose();
    const auto stiffness = [&element, &steel](const CellNodes& at) {
      return cell_stiffness(element, cell_body(at, elasticity_matrix(steel), depth_of(steel)));
    };
    const CellMatrix K = stiffness(nodes);
    for (const Vector2d& shift : shifts) {
      const CellNodes there = nodes.rowwise() + shift.transpose();
      CHECK(stiffness(there) == K);
    }
  }
}

// Where a boundary recedes by less than a thousandth, a point that is close by has two nearest places that differ
// by less than rounding of coordinates so far away: gaps are large enough here to tell them apart.
TEST_CASE("every gap operator: pairs far from the origin are the same, bit for bit",
          "[conformance][far]") {
  for (const GapOperator& member : chosen(gap_operators()))
    for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic})
      for (const Form form : {Form::Flat, Form::Curved})
        for (const double gap : {0.25, -0.2}) {
          CAPTURE(member.name, static_cast<int>(order), static_cast<int>(form), gap);
          TwoBodies here = two_blocks({-0.4, 3.3, 6}, {0, 4, 9}, gap, form, order);
          here.source = on_grid(std::move(here.source), grid);
          here.target = on_grid(std::move(here.target), grid);
          const Pairs pairs = pairs_of(member, here);
          for (const Vector2d& shift : shifts) {
            const Pairs there = pairs_of(member, moved(here, shift));
            REQUIRE(there.initial_gap.size() == pairs.initial_gap.size());
            CHECK(there.initial_gap == pairs.initial_gap);
            CHECK(there.weight == pairs.weight);
            CHECK(there.normal == pairs.normal);
            CHECK((there.opening - pairs.opening).norm() == 0);
            CHECK((there.sliding - pairs.sliding).norm() == 0);
          }
        }
}
