// Live figure of chapter 2: drag the weights of the three candidates over their triangle.
#include "../three_candidates.hpp"
#include "live/figure.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/table.hpp"

namespace live {
namespace {

using namespace signorini;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Beyond the side where the first two weights are the whole, the point goes back to it.
Vector3d weights_of(const Request& now) {
  const double sum = std::max(1.0, now["first"] + now["second"]);
  return {now["first"] / sum, now["second"] / sum,
          std::max(0.0, 1 - (now["first"] + now["second"]) / sum)};
}

void mark(Panel& triangle, const char* label, Look look, const Vector3d& weights) {
  const Vector2d at = in_triangle(weights);
  triangle.curve(label, look, at.head(1), at.tail(1));
}

// The block under these forces; where it overlaps, it lies within the obstacle.
Panel picture_of(const ch02::Block& block, const VectorXd& force) {
  const Mesh mesh = ch02::two_cells();
  const VectorXd u =
      block.free_displacement - block.factor.solve(block.programme.A.transpose() * force);
  const NodeArray place = mesh.nodes + expand(ch02::pressed_down(mesh), u);
  Panel picture{"The block under these forces, to scale", "x [mm]", "y [mm]", true};
  picture.window = {-23, 23, -9, 21};
  const VectorXd x = VectorXd::LinSpaced(47, -23, 23);
  VectorXd outline_x(49), outline_y(49);
  outline_x << x, 23, -23;
  outline_y << ((400. * 400 - (x.array() - 5).square()).sqrt() - 400).matrix(), -9, -9;
  picture.curve("obstacle, rigid", Look::Solid, outline_x, outline_y);
  picture.cells("", place, mesh.cells, VectorXd::Zero(mesh.n_cells()), 1);
  const std::vector<Index> base = boundary_nodes(mesh, "bottom");
  NodeArray up(3, 2);
  up.rowwise() = Eigen::RowVector2d(0, 1);
  picture.arrows("forces", place(base, Eigen::all), up, force, 0.4);
  return picture;
}

Answer trade_off(const Request& now) {
  static const ch02::Block block = ch02::pressed_block();
  const ContactProblem& problem = block.problem;
  const VectorXd best = ch02::shares(block);
  const double best_value = ch02::trade(problem, best).energy;
  const Vector3d xi = weights_of(now);
  const ch02::Trade trade = ch02::trade(problem, xi);
  const VectorXd force = trade.force * xi;
  const VectorXd gap = problem.free_gap + problem.compliance * force;

  Panel triangle{"What the weights are worth, s", "all on the left pair, or on the middle one",
                 "above: all on the right pair"};
  triangle.triangle(
      "s [N mm]", [&](const Vector3d& at) { return ch02::trade(problem, at).energy; },
      {0.5, 1, 2, 3, 4, 5, 6, 7}, "0.5, 1, 2, \u2026 7", 7.1, "first", "second");
  mark(triangle, "largest s", Look::Cross, best);
  mark(triangle, "these weights", Look::Here, xi);
  const Vector3d x(-20, 0, 20);  // of the nodes of the base
  Panel forces{"Contact forces", "x [mm]", "force [N]"};
  forces.window = {-22, 22, 0, 12};
  forces.curve("solution", Look::Cross, x, block.force);
  forces.curve("these weights", Look::Closed, x, force);
  Panel gaps{"Gaps that are left", "x [mm]", "gap [mm], overlap < 0"};
  gaps.window = {-22, 22, -1.2, 0.8};
  gaps.curve("closed", Look::Dotted, Vector2d(x.minCoeff(), x.maxCoeff()), Vector2d(0, 0));
  gaps.curve("these weights", Look::Open, x, gap);

  Answer answer;
  answer.number("weight_1", "left", xi(0), "", "%.2f");
  answer.number("weight_2", "middle", xi(1), "", "%.2f");
  answer.number("weight_3", "right", xi(2), "", "%.2f");
  answer.number("force", "total force", trade.force, "N", "%.3f");
  answer.number("s", "s", trade.energy, "N mm", "%.4f");
  answer.number("best_s", "largest s", best_value, "N mm", "%.4f");
  answer.number("share", "share of it", 100 * trade.energy / best_value, "%", "%.1f");
  Set overlapping{"overlapping", {}};
  for (Index k = 0; k < 3; ++k)
    if (gap(k) < -1e-12 * problem.free_gap.cwiseAbs().maxCoeff()) overlapping.members.push_back(k);
  const std::size_t overlaps = overlapping.members.size();
  answer.number("overlaps", "pairs that still overlap", static_cast<double>(overlaps), "", "%.0f");
  answer.says = text(overlaps == 0   ? "No pair overlaps"
                     : overlaps == 1 ? "One pair still overlaps"
                                     : "Two pairs still overlap",
                     " under ", number(100 * trade.force / block.force.sum(), "%.0f"),
                     " % of the force of the solution.");
  answer.sets = {overlapping};
  answer.panels = {triangle, picture_of(block, force), forces, gaps};
  return answer;
}

}  // namespace

Figure weights() {
  return {"weights",
          "One weighted gap in the place of three",
          {slider("first", "weight of the left pair", 0.33, 0, 1, 0.01),
           slider("second", "weight of the middle pair", 0.33, 0, 1, 0.01)},
          trade_off};
}

}  // namespace live
