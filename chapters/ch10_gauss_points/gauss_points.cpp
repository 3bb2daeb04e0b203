// Chapter 10 - One Gauss point and the forces on its four nodes (Lin et al., sec. 2.4, eqs. 32-41).
// Run:  make ch10     Reads: nothing     Writes: ch10.results, element.md, few.md,
//       fig_10_1.csv
#include "signorini/pairing/gauss_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "interfaces.hpp"
#include "one_point.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/element.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch10;
using Eigen::Index;
using Eigen::VectorXd;

std::string digits(double x) { return number(std::abs(x) < 5e-5 ? 0 : x, "%.4f"); }

// 1. A cell of width 1 rests on one of width 2.
/// What a pressure of 3 and a shear of 1 at the first point put on the nodes.
struct OnePoint {
  Pairs pairs;
  std::array<double, 4> x, normal, friction;
};

/// \PaperEq{LinEtAl, 32} to \PaperEq{LinEtAl, 36}, \PaperEq{LinEtAl, 38} to \PaperEq{LinEtAl, 41}
OnePoint press_one_point() {
  const Mesh source = block("source", {0.75, 1}, {1, 1}, 1, 1);
  const Mesh target = block("target", {0, 0}, {2, 1}, 1, 1);
  GapOptions options;
  options.n_nodes = source.n_nodes() + target.n_nodes();
  options.sliding = true;
  const Pairs pairs =
      gauss_points({source, "bottom", 0}, {target, "top", source.n_nodes()}, options);
  const double share = pairs.weight(0);                                      // l_12 / 2
  const VectorXd normal = pairs.opening.row(0).transpose() * (3 * share);    // (33)-(36)
  const VectorXd friction = pairs.sliding.row(0).transpose() * (1 * share);  // (38)-(41)

  OnePoint point{pairs, {}, {}, {}};
  const std::vector<Eigen::Index> on = boundary_nodes(source, "bottom");
  const std::vector<Eigen::Index> below = boundary_nodes(target, "top");
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Index own = k < 2 ? on[k] : below[k - 2];
    const Eigen::Index node = k < 2 ? own : source.n_nodes() + own;
    point.x[k] = (k < 2 ? source : target).nodes(own, 0);
    point.normal[k] = normal(2 * node + 1);
    point.friction[k] = friction(2 * node);
  }
  return point;
}

// 2. One Gauss point: the forces on its four nodes.
void one_point(const ProgramOptions& run, Results& results) {
  const OnePoint point = press_one_point();
  Table table({"node", "x", "normal force", "friction", "moment of the normal force"});
  Eigen::Vector3d sum(0, 0, 0);
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d row(point.normal[k], point.friction[k], point.x[k] * point.normal[k]);
    sum += row;
    table.row({std::to_string(k + 1), number(point.x[k], "%.2f"), digits(row(0)), digits(row(1)),
               digits(row(2))});
  }
  table.row({"sum", "", digits(sum(0)), digits(sum(1)), digits(sum(2))});
  std::cout << table.markdown();
  write_file(run.out / "element.md", table.markdown());
  results.add("share", point.pairs.weight(0), "-");
  results.add("point_x", point.pairs.position(0, 0), "-");
  results.add("force_1", point.normal[0], "-");
  for (const std::size_t k : {1, 2, 3}) results.add(text("force_", k + 1), point.normal[k], "-");
  results.headline("force_1", 0.75 * (1 + 1 / std::sqrt(3)), "(35) by hand");
}

// 3. Figure 10.1: two points of an edge, what they face, and the forces of a pressure at the first one.
/// \return a line from (x, y) to (x2, y2) per row
Table sketch() {
  const FourNodes X = (FourNodes() << 0.6, 1.3, 3.2, 1.8, 4.2, 0.25, 0, 0).finished();
  Table table({"x", "y", "x2", "y2"});
  const auto line = [&table](const Vector2d& from, const Vector2d& to) {
    table.row({from.x(), from.y(), to.x(), to.y()});
  };
  line(X.row(0).transpose(), X.row(1).transpose());
  line(X.row(2).transpose(), X.row(3).transpose());
  const double root = 1 / std::sqrt(3.0);
  const PointOverEdge first = point_over_edge(X, 0 * X, -root);
  const PointOverEdge second = point_over_edge(X, 0 * X, root);
  for (const PointOverEdge& at : {first, second}) line(at.x, at.place);
  const FourNodes forces = forces_of_point(first, 1, 0);
  for (Eigen::Index k = 0; k < 4; ++k)
    line(X.row(k).transpose(), (X.row(k) + forces.row(k)).transpose());
  line(first.place, first.place + 0.7 * first.n);
  line(first.place, first.place + 0.7 * first.t);
  return table;
}

// 4. One edge of length 2 over two of length 1, under a pressure of 1: what reaches the three nodes
//    below, which should be 1/2, 1, 1/2. No points: the two nodes of the edge press.
std::array<double, 3> reaches(int points) {
  if (points == 0) return {1, 0, 1};
  std::array<double, 3> share = {0, 0, 0};
  for (const GaussPoint& gauss : gauss_line(points)) {
    const double x = 1 + gauss.xi;
    const std::size_t edge = x < 1 ? 0 : 1;
    const double N = x - static_cast<double>(edge);
    share[edge] += gauss.weight * (1 - N);
    share[edge + 1] += gauss.weight * N;
  }
  return share;
}

// 5. The same for the blocks with 7 edges over 15 of chapter 9: largest error of a node's share below [%].
double worst_share(const Sampling& by) {
  const Index edges = 15;
  const SolvedScene run = solved(blocks(7, edges, by), "blocks");
  const NodeArray forces = contact_forces(run.model, run.solution, 1);
  const Mesh& lower = run.model.bodies[1].mesh;
  double worst = 0;
  for (const Index node : boundary_nodes(lower, "top")) {
    const double x = lower.nodes(node, 0), share = 2.0 / static_cast<double>(edges);
    const double due = x < 1e-9 || x > 2 - 1e-9 ? share / 2 : share;
    worst = std::max(worst, std::abs(-forces(node, 1) / due - 1));
  }
  return 100 * worst;
}

void few_points(const ProgramOptions& run, Results& results) {
  Table table(
      {"points on an edge", "left node", "middle node", "right node", "7 over 15: worst node"});
  for (const int points : {0, 1, 2, 3, 4}) {
    const std::array<double, 3> share = reaches(points);
    const double worst =
        worst_share({points == 0 ? "node_to_segment" : "gauss_points", std::max(points, 1)});
    table.row({points == 0 ? "none, nodes press" : std::to_string(points), digits(share[0]),
               digits(share[1]), digits(share[2]), number(worst, "%.0f") + " %"});
    results.add(text("middle_", points), share[1], "-");
    if (points < 3) results.add(text("worst_share_", points), worst, "%");
  }
  std::cout << table.markdown();
  write_file(run.out / "few.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch10");
  one_point(run, results);
  few_points(run, results);
  write_file(run.out / "fig_10_1.csv", sketch().csv());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch10", "Gauss-point surface contact", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
