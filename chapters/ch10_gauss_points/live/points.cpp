// Live figure of chapter 10: pressures of Gauss points, and how they may change while no node feels it.
#include "../interfaces.hpp"
#include "../possible_pressures.hpp"
#include "live/figure.hpp"
#include "signorini/core/table.hpp"

namespace live {
namespace {

using namespace ch10;
using Eigen::Vector2d;

// Pressures are counted in the largest true one, places in half of the contact's width.
const double q0 = hertz_peak_pressure(hertz_contact);
const double half_width = hertz_half_width(hertz_contact);

struct Points {
  SolvedScene run;
  ClosedPoints closed;
  Bounds possible;
};

Index cells_of(const Request& now) { return now.on("apart") ? 21 : 16; }  // of the plate

Points points_of(const Request& now) {
  SolvedScene run =
      solved(hertz(cells_of(now), {"gauss_points", static_cast<int>(now.whole("points"))}), "disc");
  ClosedPoints closed = closed_points(run);
  Bounds possible = possible_pressures(closed);
  return {std::move(run), std::move(closed), std::move(possible)};
}

// One point gets another pressure; the others follow so that no node feels it and none is negative.
VectorXd pushed(const ClosedPoints& closed, Index point, double wish) {
  if (closed.free.cols() == 0) return closed.pressure;
  const double way = wish - closed.pressure(point);
  const double far = (way > 0 ? 1e4 : -1e4) * closed.root.norm();
  const VectorXd corner = pulled(closed, far * closed.free.row(point).transpose().normalized());
  const double room = corner(point) - closed.pressure(point);
  return closed.pressure +
         (std::abs(way) < std::abs(room) ? way / room : 1) * (corner - closed.pressure);
}

Panel points_panel(const Points& all, const VectorXd& x, const VectorXd& pressure, Index point) {
  Panel panel{"Pressures of points", "x / b", "pressure / q\u2080"};
  panel.drag = {{"place", 1, 0}, {"wish", 0, 1}};
  const VectorXd lowest = all.possible.lowest / q0, highest = all.possible.highest / q0;
  panel.window = {-0.02, 1.15, -0.1, 5.8};
  panel.clips = true;
  for (Index k = 0; k < x.size(); ++k)
    panel.curve(k == 0 ? "possible" : "", Look::Dotted, Vector2d(x(k), x(k)),
                Vector2d(lowest(k), highest(k)));
  panel.points("points", x, pressure / q0, pressure);
  panel.curve("this point", Look::Here, x.segment(point, 1), pressure.segment(point, 1) / q0);
  return panel;
}

Answer push(const Request& now) {
  const Points& all = kept(now.key({"place", "wish"}), [&now] { return points_of(now); });
  const SolvedScene& nodal = kept(text(cells_of(now)), [&now] {
    return solved(hertz(cells_of(now), {"mortar", 0, Quadrature::Segments}), "disc");
  });
  const ClosedPoints& closed = all.closed;
  const Pairs& pairs = all.run.model.pairs;
  const VectorXd x = pairs.position(closed.points, 0) / half_width;
  Index point = 0;
  (x.array() - now["place"]).abs().minCoeff(&point);
  const VectorXd pressure = pushed(closed, point, now["wish"] * q0);
  const VectorXd change = pressure - closed.pressure;
  VectorXd force = VectorXd::Zero(pairs.position.rows());
  force(closed.points) = change.cwiseProduct(closed.root.cwiseAbs2());

  Panel unfelt{"The part that no node feels", "x / b", "change of pressure / q\u2080"};
  unfelt.window = {-0.02, 1.15, -2.5, 4.5};
  unfelt.clips = true;
  unfelt.curve("none", Look::Dotted, Vector2d(0, 1.15), Vector2d(0, 0));
  unfelt.curve("points", Look::Closed, x, change / q0);
  Panel nodes{"Pressures of nodes", "x / b", "pressure / q\u2080"};
  nodes.window = {-0.02, 1.15, -0.1, 1.5};
  const BoundaryForces rim = boundary_forces(all.run, {"rim", "disc"});
  const VectorXd lumped = rim.force.col(1).cwiseQuotient(rim.weight);
  nodes.curve("forces of the points, lumped", Look::Open, rim.position.col(0) / half_width,
              lumped / q0);
  nodes.curve("weighted gaps", Look::Cross, nodal.model.pairs.position.col(0) / half_width,
              nodal.solution.pressure / q0);
  Answer answer;
  answer.panels = {points_panel(all, x, pressure, point), unfelt, nodes};
  for (const std::size_t k : {0, 1})  // another solver, other pressures
    for (Layer& layer : answer.panels[k].layers) layer.varies = closed.free.cols() > 0;
  const VectorXd fine = VectorXd::LinSpaced(161, 0, 1.15);
  const auto exact = [](double at) { return hertz_pressure(hertz_contact, at * half_width) / q0; };
  for (const std::size_t k : {0, 2})
    answer.panels[k].curve("closed form", Look::Dashed, fine, fine.unaryExpr(exact));

  const bool free = (all.possible.highest - all.possible.lowest)(point) > 1e-9 * q0;
  answer.says = free ? "This point may have other pressures, and no node feels which."
                     : "The pressure of this point is determined.";
  answer.number("closed", "closed points", static_cast<double>(x.size()), "", "%.0f");
  answer.number("rank", "determined", static_cast<double>(closed.rank), "", "%.0f");
  answer.number("highest", "highest here", all.possible.highest(point) / q0, "q\u2080");
  answer.rounding("felt", "largest force that a node feels",
                  (all.run.model.programme.A.transpose() * force).cwiseAbs().maxCoeff(), "N");
  const PressureError error =
      against_hertz(pairs.position, pairs.weight, all.run.solution.pressure);
  answer.number("rms", "error of the solver's pressures", 100 * error.rms, "%");
  answer.numbers.back().varies = closed.free.cols() > 0;
  answer.number("lumped", "error of lumped ones",
                100 * against_hertz(rim.position, rim.weight, lumped).rms, "%");
  answer.sets = {{"closed", closed.points}};
  return answer;
}

}  // namespace

Figure points() {
  return {
      "points",
      "Pressures that no node feels",
      {slider("points", "Gauss points an edge", 2, 1, 4, 1), toggle("apart", "nodes apart", false),
       slider("place", "place of a point x / b", 0.5, 0, 1.1, 0.01),
       slider("wish", "pressure wished for there [q\u2080]", 2, 0, 9, 0.05)},
      push};
}

}  // namespace live
