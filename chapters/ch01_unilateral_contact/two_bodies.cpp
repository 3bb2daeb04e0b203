// Chapter 1 - The relative displacements of two bodies (Xuan & Li 2002, after eq. 12).
// Run:  make ch01     Reads: nothing     Writes: ch01_two_bodies.results, fig_1_3.csv,
//      fig_1_3_nodes.csv, fig_1_3_arrows.csv
#include <cmath>

#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "meshes/block.hpp"
#include "signorini/pairing/node_to_segment.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;

// 1. One block above another, a gap of 1 between them, turned by theta.
const double theta = 25 * pi / 180;
const Vector2d t(std::cos(theta), std::sin(theta));
const Vector2d n(-std::sin(theta), std::cos(theta));  // out of the lower body, (A 1)

Mesh turned_block(double low, double height) {
  return mapped(block("block", {-4, low}, {8, height}, 8, 3),
                [](const Vector2d& at) -> Vector2d { return at.x() * t + at.y() * n; });
}

/// \PaperEq{XuanLi2002, 13}: a u = (u' - u) sin(theta) - (v' - v) cos(theta), a row a of A.
void row_of_a_pair(const Mesh& upper, const Mesh& lower, Results& results) {
  const Index first = upper.n_nodes();  // node i of the lower body has the number first + i
  GapOptions options;
  options.n_nodes = first + lower.n_nodes();
  const Pairs pairs = node_to_segment({upper, "bottom", 0}, {lower, "top", first}, options);
  const NodalRows A = -pairs.opening;                           // gap = g - A u
  const Index above = boundary_nodes(upper, "bottom")[4];       // i', in the middle
  const Index below = first + boundary_nodes(lower, "top")[4];  // i, which faces it
  results.add("row_u", A.coeff(4, 2 * above), "-");             // sin(theta)
  results.add("row_v", A.coeff(4, 2 * above + 1), "-");         // -cos(theta)
  results.add("row_u_below", A.coeff(4, 2 * below), "-");       // -sin(theta)
  results.add("row_v_below", A.coeff(4, 2 * below + 1), "-");   // cos(theta)
}

// 2. The picture: both bodies, the nodes that face each other, and the motions of the middle pair.
void draw(const std::filesystem::path& out, const Mesh& upper, const Mesh& lower) {
  Table outlines({"x", "y"});
  for (const Mesh* body : {&upper, &lower}) {
    for (const char* side : {"bottom", "right", "top", "left"})
      for (const Index node : boundary_nodes(*body, side))
        outlines.row({body->nodes(node, 0), body->nodes(node, 1)});
    outlines.blank_line();
  }
  write_file(out / "fig_1_3.csv", outlines.csv());
  Table nodes({"x", "y"});
  for (int place = -4; place <= 4; ++place)
    for (const double height : {0.0, -1.0}) {
      const Vector2d at = place * t + height * n;
      nodes.row({at.x(), at.y()});
    }
  write_file(out / "fig_1_3_nodes.csv", nodes.csv());
  Table arrows({"x", "y", "dx", "dy"});
  const auto arrow = [&](const Vector2d& from, const Vector2d& way) {
    arrows.row({from.x(), from.y(), way.x(), way.y()});
  };
  arrow(-0.6 * n, 1.6 * t);          // of i' relative to i: its part along t
  arrow({0, 0}, -0.6 * n);           // its part against n, a u
  arrow({0, 0}, 1.6 * t - 0.6 * n);  // all of it
  arrow(-3 * t - n, 1.0 * n);
  arrow(-3 * t - n, 1.5 * t);
  write_file(out / "fig_1_3_arrows.csv", arrows.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch01_two_bodies");
  const Mesh upper = turned_block(0, 2);
  const Mesh lower = turned_block(-3, 2);
  row_of_a_pair(upper, lower, results);
  draw(run.out, upper, lower);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch01_two_bodies", "The relative displacements of two bodies",
                     SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
