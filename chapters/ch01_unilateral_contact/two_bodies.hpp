// Chapter 1 - the relative displacements of two bodies (Xuan & Li 2002, after eq. 12).
#pragma once
#include <cmath>

#include "signorini/contact/node_to_segment.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/report/program.hpp"

namespace ch01 {

using Eigen::Index;
using Eigen::Vector2d;

/// One block above another, a gap of 1 between them, turned by theta.
struct TwoBodies {
  double theta = 25 * std::acos(-1.0) / 180;
  signorini::Mesh upper = block(0, 2);
  signorini::Mesh lower = block(-3, 2);

  [[nodiscard]] Vector2d t() const { return {std::cos(theta), std::sin(theta)}; }
  [[nodiscard]] Vector2d n() const { return {std::sin(theta), -std::cos(theta)}; }  // as in (1)
  [[nodiscard]] signorini::Mesh block(double low, double height) const {
    signorini::BlockSpec spec;
    spec.corner = {-4, low};
    spec.size = {8, height};
    spec.cells_x = 8;
    spec.cells_y = 3;
    return signorini::mapped(signorini::make_block(spec), [this](const Vector2d& at) -> Vector2d {
      return at.x() * t() - at.y() * n();
    });
  }
};

/// \PaperEq{XuanLi2002, 13}: d = (u' - u) sin(theta) - (v' - v) cos(theta) of every pair is a row
/// of A, as the gap operator of the library has it.
inline void check_kinematics(const TwoBodies& bodies, signorini::Results& results) {
  const Index first = bodies.upper.n_nodes();  // node i of the lower body has the number first + i
  signorini::GapOptions options;
  options.n_nodes = first + bodies.lower.n_nodes();
  options.sliding = true;
  const signorini::Pairs pairs = signorini::node_to_segment({bodies.upper, "bottom", 0},
                                                            {bodies.lower, "top", first}, options);
  const signorini::NodalRows A = -pairs.opening;  // gap = g - A u
  const std::vector<Index> upper = signorini::boundary_nodes(bodies.upper, "bottom");
  const std::vector<Index> lower = signorini::boundary_nodes(bodies.lower, "top");
  signorini::Random random(1);
  Eigen::VectorXd u(2 * options.n_nodes);
  for (double& entry : u) entry = random.uniform(-1, 1);
  for (std::size_t k = 0; k < upper.size(); ++k) {
    const Index above = upper[k];  // i'
    const Index below =
        first + lower[lower.size() - 1 - k];  // i: the two sides run in opposite ways
    const Vector2d relative = u.segment<2>(2 * above) - u.segment<2>(2 * below);
    const double d = relative.x() * std::sin(bodies.theta) - relative.y() * std::cos(bodies.theta);
    const auto pair = static_cast<Index>(k);
    if (std::abs(A.row(pair).dot(u) - d) > 1e-14 ||
        std::abs(pairs.sliding.row(pair).dot(u) - relative.dot(bodies.t())) > 1e-14)
      throw signorini::NotSolved("the relative displacements differ from those of the paper");
  }
  results.add("row_u", A.coeff(4, 2 * upper[4]), "-");
  results.add("row_v", A.coeff(4, 2 * upper[4] + 1), "-");
}

/// The picture: outlines of both bodies, the nodes that face each other, and the pair in the middle.
inline void draw_two_bodies(const std::filesystem::path& out, const TwoBodies& bodies) {
  signorini::Table outlines({"x", "y"});
  for (const signorini::Mesh* body : {&bodies.upper, &bodies.lower}) {
    for (const char* side : {"bottom", "right", "top", "left"})
      for (const Index node : signorini::boundary_nodes(*body, side))
        outlines.row({body->nodes(node, 0), body->nodes(node, 1)});
    outlines.blank_line();
  }
  signorini::write_file(out / "fig_1_3.csv", outlines.csv());
  signorini::Table nodes({"x", "y"});
  for (int place = -4; place <= 4; ++place)
    for (const double height : {0.0, 1.0}) {
      const Vector2d at = place * bodies.t() + height * bodies.n();
      nodes.row({at.x(), at.y()});
    }
  signorini::write_file(out / "fig_1_3_nodes.csv", nodes.csv());
  signorini::Table arrows({"x", "y", "dx", "dy"});
  const auto arrow = [&](const Vector2d& from, const Vector2d& way) {
    arrows.row({from.x(), from.y(), way.x(), way.y()});
  };
  const Vector2d moved = 1.6 * bodies.t() + 0.6 * bodies.n();  // of i' relative to i
  arrow(0.6 * bodies.n(), 1.6 * bodies.t());                   // its part along t
  arrow({0, 0}, 0.6 * bodies.n());                             // its part along n: d
  arrow({0, 0}, moved);
  arrow(-3 * bodies.t(), 1.0 * bodies.n());
  arrow(-3 * bodies.t(), 1.5 * bodies.t());
  signorini::write_file(out / "fig_1_3_arrows.csv", arrows.csv());
}

}  // namespace ch01
