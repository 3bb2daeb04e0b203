// Live figure of chapter 9: node 3 slides over a corner of the target.
#include <cmath>

#include "../contact_element.hpp"
#include "live/figure.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/pairing/target_search.hpp"

namespace live {
namespace {

using namespace ch09;
using namespace signorini;
using Eigen::Vector3d;

const double none = std::nan("");
// The edge from 1 to 2 of figure 9.1 goes on from 2 to 4, which lies higher or lower.
Mesh target(double height) {
  return mapped(block("target", {-4, -4}, {8, 4}, 2, 1), [height](const Vector2d& x) -> Vector2d {
    const double top = x.x() > 0 ? 3 - 0.75 * x.x() : 3 + (3 - height) * x.x() / 4;
    return {x.x(), -4 + (x.y() + 4) / 4 * (top + 4)};
  });
}

struct Facing {
  Projection at;
  Place place{};                               // as the chapter has it
  Nodes X = Nodes::Constant(none);             // the edge's two nodes, and node 3
  Vector3d shares = Vector3d::Constant(none);  // of the nodes 1, 2 and 4
  double turn = none;                          // of the normal, from upright to the right [degrees]
};

Facing facing(const TargetSearch& search, const Mesh& mesh, const Vector2d& node) {
  Facing found{search.closest(node, Vector2d(0, -1))};
  if (!found.at.found) return found;
  const SideCurve& edge = search.side(found.at.side);
  const double N2 = edge.shape(found.at.xi).value(1);
  const Vector2d n = found.at.normal;
  found.place = {1 - N2, N2, n, Vector2d(n.y(), -n.x()), found.at.gap};
  found.X << mesh.nodes.row(edge.nodes()[0]), mesh.nodes.row(edge.nodes()[1]), node.transpose();
  found.shares.setZero();
  found.shares.segment<2>(found.X(0, 0) > 2 ? 0 : 1) << 1 - N2, N2;
  found.turn = std::atan2(n.x(), n.y()) * 180 / pi;
  return found;
}

Panel picture_of(const Facing& here, const Vector2d& node, const Mesh& mesh) {
  Panel picture{"Node 3 and the target", "x [mm]", "y [mm]", true};
  picture.window = {-5.5, 5.5, -2, 6};
  picture.clips = true;
  picture.drag = {{"x", 1, 0}, {"y", 0, 1}};
  const NodeArray top = mesh.nodes.bottomRows(3);
  VectorXd outline_x(5), outline_y(5);
  outline_x << top.col(0), top(2, 0), top(0, 0);
  outline_y << top.col(1), -4, -4;
  picture.curve("target", Look::Solid, outline_x, outline_y);
  picture.curve("its nodes 1, 2, 4", Look::Open, top.col(0), top.col(1));
  picture.curve("node 3", Look::Here, node.head(1), node.tail(1));
  if (!here.at.found) return picture;
  const Vector2d foot = here.at.point.position();
  picture.curve("place 3\u2032", Look::Cross, foot.head(1), foot.tail(1));
  picture.curve("gap", Look::Dashed, Vector2d(foot.x(), node.x()), Vector2d(foot.y(), node.y()));
  const Nodes end = here.X + nodal_forces(here.place, 1.2, 0.5);
  VectorXd x(6), y(6);
  for (Index i = 0; i < 3; ++i) {
    x.segment<2>(2 * i) << here.X(i, 0), end(i, 0);
    y.segment<2>(2 * i) << here.X(i, 1), end(i, 1);
  }
  picture.curve("forces, 1 mm is 1 N", Look::Arrow, x, y);
  return picture;
}

Answer slide(const Request& now) {
  const Mesh mesh = target(now["height"]);
  const TargetSearch search(mesh, "top");
  const Vector2d node(now["x"], now["y"]);
  const Facing here = facing(search, mesh, node);
  const VectorXd x = VectorXd::LinSpaced(221, -5.5, 5.5);
  MatrixXd sweep(x.size(), 4);  // shares of the nodes and the turn of the normal
  for (Index k = 0; k < x.size(); ++k) {
    const Facing there = facing(search, mesh, {x(k), node.y()});
    sweep.row(k) << there.shares.transpose(), there.turn;
  }
  Panel shares{"Who bears its force, at this height", "x of node 3 [mm]", "part of its force"};
  shares.window = {-5.5, 5.5, -0.05, 1.05};
  const Look looks[] = {Look::Line, Look::Dashed, Look::Dotted};
  const char* nodes[] = {"1", "2", "4"};
  for (Index i = 0; i < 3; ++i) shares.curve(text("node ", nodes[i]), looks[i], x, sweep.col(i));
  shares.curve("here", Look::Closed, Vector3d::Constant(node.x()), here.shares);
  Panel turn{"Direction of the normal", "x of node 3 [mm]", "degrees from upright"};
  turn.window = {-5.5, 5.5, -90, 90};
  turn.curve("to the right is positive", Look::Line, x, sweep.col(3));
  turn.curve("here", Look::Closed, node.head(1), VectorXd::Constant(1, here.turn));
  Answer answer;
  answer.sets = {{"bears", {}}};
  for (Index i = 0; i < 3; ++i)
    if (here.shares(i) > 0) answer.sets[0].members.push_back(i == 2 ? 4 : i + 1);
  answer.says = !here.at.found ? "Node 3 faces nothing."
                : here.shares.maxCoeff() == 1
                    ? "Node 3 faces a corner: one node bears all of its force."
                    : "Node 3 faces an edge: two nodes share its force.";
  if (here.at.found) {
    if (here.place.gap < 0) answer.says += " It lies inside the target.";
    for (Index i = 0; i < 3; ++i)
      answer.number(text("share_", nodes[i]), text("part of node ", nodes[i]), here.shares(i));
    answer.number("gap", "gap", here.place.gap, "mm");
    answer.number("moment", "moment of 1 N of friction",
                  moment(here.X, nodal_forces(here.place, 0, 1)), "N mm");
  }
  answer.panels = {picture_of(here, node, mesh), shares, turn};
  return answer;
}

}  // namespace

Figure corner() {
  return {"corner",
          "A node slides over a corner",
          {slider("x", "x of node 3 [mm]", 3, -5.5, 5.5, 0.05),
           slider("y", "y of node 3 [mm]", 1.5, -2, 6, 0.05),
           slider("height", "height of node 4 [mm]", 1, -1, 9, 0.1)},
          slide};
}

}  // namespace live
