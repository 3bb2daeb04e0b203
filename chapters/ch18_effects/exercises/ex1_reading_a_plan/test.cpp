#include "../chapters/ch18_effects/scenes.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex18_1::Needs;
using ex18_1::needs_of;
using ex18_1::Step;
using ex18_1::step;
using signorini::Scene;
using Names = std::vector<std::string>;
using Counts = std::vector<Eigen::Index>;

// Two per node less what the supports of a body give.
static Eigen::Index free_of(const signorini::Body& body) {
  Eigen::Index count = 2 * body.mesh.n_nodes();
  for (const signorini::Support& support : body.supports) {
    const auto nodes =
        static_cast<Eigen::Index>(boundary_nodes(body.mesh, support.boundary).size());
    count -= support.normal_only || !support.holds_x || !support.holds_y ? nodes : 2 * nodes;
  }
  return count;
}

// The rim has 61 nodes. The highest is held where it is pushed and cannot go down; the lowest is held by symmetry
// and cannot slide.
TEST_CASE("ex18.1 the first rung has unknowns and gaps, the last one everything", "[ex18.1]") {
  const Scene pushed = signorini::on_rock(0.025);
  const Needs first = needs_of(pushed);
  CHECK(first.unknowns == free_of(pushed.bodies[0]));
  CHECK(first.gaps == 60);
  CHECK(first.slips == 0);
  CHECK(first.amplitudes == 0);
  CHECK(first.gaps_of == Counts{60});
  CHECK(first.slips_of == Counts{0});
  CHECK(first.on == Names{"contact"});

  const Scene top = heated(with_friction(floating(with_plate(pushed))));
  const Needs last = needs_of(top);
  // The corner of the plate, where axis and base meet, does not move along x: both supports say so.
  CHECK(last.unknowns == free_of(top.bodies[0]) + free_of(top.bodies[1]) + 1);
  CHECK(last.gaps == 61);
  CHECK(last.slips == 60);
  CHECK(last.amplitudes == 1);
  CHECK(last.on == Names{"edge loads", "temperature", "contact", "friction", "rigid motions"});
}

TEST_CASE("ex18.1 every rung changes one thing", "[ex18.1]") {
  const Scene plate = with_plate(signorini::on_rock(0.025));
  const Scene free = floating(plate);
  const Step held = step(plate, free);
  CHECK(held.unknowns > 0);
  CHECK(held.amplitudes == 1);
  CHECK(held.switched_on == Names{"edge loads", "rigid motions"});

  const Step rough = step(free, with_friction(free));
  CHECK(rough.unknowns == 0);
  CHECK(rough.rows == needs_of(with_friction(free)).slips);
  CHECK(rough.switched_on == Names{"friction"});
  CHECK(rough.switched_off == decltype(rough.switched_off){});

  const Step heat = step(free, heated(free));  // a load: numbers, and nothing to store them in
  CHECK(heat.unknowns == 0);
  CHECK(heat.rows == 0);
  CHECK(heat.amplitudes == 0);
  CHECK(heat.switched_on == Names{"temperature"});

  const Step back = step(with_friction(free), free);
  CHECK(back.rows == -rough.rows);
  CHECK(back.switched_on == decltype(back.switched_on){});
  CHECK(back.switched_off == Names{"friction"});
}

TEST_CASE("ex18.1 a block of zeros is none", "[ex18.1]") {
  const Scene free = floating(with_plate(signorini::on_rock(0)));
  Scene zeros = free;
  zeros.contacts[0].friction = signorini::Friction{0, 0};
  zeros.contacts[0].interference = 0;
  zeros.contacts[0].adjust = 0;
  zeros.bodies[0].temperature = signorini::Temperature{};
  zeros.bodies[0].loads.points = {{{0, 50}, {0, 0}}};
  zeros.bodies[1].springs = {{"base", {0, 0}}};
  const Needs one = needs_of(free);
  const Needs two = needs_of(zeros);
  CHECK(two.slips == 0);
  CHECK(two.on == one.on);
  const Step none = step(free, zeros);
  CHECK(none.rows == 0);
  CHECK(none.switched_on == decltype(none.switched_on){});
  CHECK(none.switched_off == decltype(none.switched_off){});
}
