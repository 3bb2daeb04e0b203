// Live figure of chapter 14: load, gap, operator and element of two rings. One factor serves all loads.
#include <cmath>

#include "../readings.hpp"
#include "../rings.hpp"
#include "live/figure.hpp"
#include "signorini/core/table.hpp"

namespace live {
namespace {

using namespace signorini;
using namespace ch14;
using Eigen::Vector2d;

Rings rings_of(const Request& now) {
  Rings rings;
  rings.radii[2] = rings.radii[1] + now["gap"];
  rings.radii[3] = rings.radii[2] + 8;
  rings.pressure = now["load"];
  rings.turn = now.on("meet") ? 0 : 0.5;
  rings.gap_operator = now.chosen("operator");
  rings.element = now.chosen("element");
  return rings;
}

// The scene of the chapter, unloaded at time 1, with 1 MPa more in every unit of time.
Loaded loaded(Rings rings) {
  rings.pressure = 1;
  Scene scene = scene_of(rings);
  scene.bodies[0].loads.edges[0].history = "load";
  scene.path = Path{{1}, {{"load", {1, 1001}, {0, 1000}}}};
  return Loaded(scene);
}

// The same in closed form: the gap that is left [cm].
double gap_left(const NestedRings& rings) {
  const NestedPressure on = nested_pressure(rings);
  const double closed = ring_displacement(rings.inner, on.inner, rings.inner.outer_radius) -
                        ring_displacement(rings.outer, on.outer, rings.outer.inner_radius);
  return std::max(ring_clearance(rings) - closed, 0.);
}

Answer widen(const Request& now) {
  const Rings rings = rings_of(now);
  Loaded& both = kept(now.key({"load"}), [&rings] { return loaded(rings); });
  const SolvedScene run = both.scene_at(1 + rings.pressure);
  const Solution& solution = run.solution;
  const NestedRings theory = closed_form(rings);
  const double exact = nested_pressure(theory).inner.outside, left = gap_left(theory);
  const NodeArray& place = run.model.pairs.position;
  VectorXd degrees(place.rows());
  for (Index k = 0; k < place.rows(); ++k)
    degrees(k) = std::atan2(place(k, 1), place(k, 0)) * 90 / quarter_turn;

  Panel bodies{"The rings, gap and displacements 20 times as large", "x [cm]", "y [cm]", true};
  bodies.window = {0, 92, 0, 92};
  for (std::size_t b = 0; b < 2; ++b) {
    const BodyModel& body = run.model.bodies[b];
    const NodeArray& u = solution.displacements[b];
    bodies.body(body, u, drawn(body.mesh, now["gap"]).nodes + magnified * u, 1200);
  }
  bodies.pressure(run.model, solution, 0.08, magnified);
  const Vector2d arc(0, 90);
  Panel pressure{"Contact pressure along the rim", "angle [degrees]", "pressure [MPa]"};
  pressure.curve("closed form", Look::Dashed, arc, Vector2d(exact, exact));
  pressure.points("pairs", degrees, solution.pressure, solution.contact.force);
  pressure.window = {-2, 92, 0, 110};
  pressure.clips = true;
  Panel gap{"Gap along the rim", "angle [degrees]", "gap [cm]"};
  gap.window = {-2, 92, -0.06, 0.36};
  gap.curve("closed form", Look::Dashed, arc, Vector2d(left, left));
  gap.curve("before loading", Look::Cross, degrees, run.model.pairs.initial_gap);
  gap.points("pairs", degrees, solution.contact.gap, solution.contact.force);

  Answer answer;
  const Index press = (solution.pressure.array() > 1e-9 * paper.pressure).count();  // no rounding
  answer.says = press == 0               ? "The rings do not press on each other."
                : press < degrees.size() ? "The rings press on each other in places."
                                         : "The gap is closed all round.";
  answer.number("p", "contact pressure, mean of the pairs", solution.pressure.mean(), "MPa",
                "%.3f");
  answer.number("least", "least", solution.pressure.minCoeff(), "MPa", "%.3f");
  answer.number("most", "largest", solution.pressure.maxCoeff(), "MPa", "%.3f");
  answer.number("exact", "closed form", exact, "MPa", "%.3f");
  answer.number("u", "inner rim moves by, mean", inner_rim(run).mean(), "cm", "%.5f");
  answer.number("u_exact", "closed form", inner_rim(theory), "cm", "%.5f");
  answer.solution(solution, press > 0 || now["gap"] > 0);
  Panel closing{"Pressure over load", "load p [MPa]", "contact pressure, mean [MPa]"};
  closing.window = {0, 180, 0, 100};
  const VectorXd loads = VectorXd::LinSpaced(181, 0, 180);
  closing.curve("closed form", Look::Dashed, loads, loads.unaryExpr([&theory](double load) {
    NestedRings then = theory;
    then.pressure_inside = load;
    return nested_pressure(then).inner.outside;
  }));
  closing.trail("loads so far", text(now["gap"], " cm"), now["load"], solution.pressure.mean());
  answer.panels = {bodies, pressure, closing, gap};
  return answer;
}

}  // namespace

Figure lining() {
  return {
      "lining",
      "Load until the ring closes",
      {playing(slider("load", "load p [MPa]", paper.pressure, 0, 180, 1)),
       slider("gap", "gap between the rings [cm]", 0.15, -0.05, 0.3, 0.01),
       toggle("meet", "nodes of both rings meet", true),
       choice("operator", "gaps by", "mortar", {"mortar", "node_to_segment", "gauss_points"}),
       choice("element", "element", "q4_incompatible", {"q4", "q4_bbar", "q4_incompatible", "q8"})},
      widen};
}

}  // namespace live
