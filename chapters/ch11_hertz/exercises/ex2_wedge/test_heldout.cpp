#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/indentation.hpp"
#include "closed_form/moduli.hpp"
#include "exercise.hpp"
#include "signorini/scene/readings.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex11_2::Wedge;
using signorini::Indenter;

namespace {

struct Reading {
  VectorXd x, force, pressure;
};

Reading read(const Wedge& wedge) {
  const signorini::SolvedScene run = signorini::solved(ex11_2::wedge_on_plate(wedge), "the wedge");
  Reading out{run.model.pairs.position.col(0), run.solution.contact.force, run.solution.pressure};
  if (out.x(0) > out.x(out.x.size() - 1))
    for (VectorXd* values : {&out.x, &out.force, &out.pressure}) values->reverseInPlace();
  return out;
}

double contact_modulus(const Wedge& wedge) {
  return signorini::plane_strain_modulus(wedge.modulus, wedge.ratio) / 2;
}

}  // namespace

TEST_CASE("ex11.2 held out: the half-width follows the load, the slope and the material",
          "[ex11.2]") {
  const Wedge wedge = GENERATE(Wedge{0.01, 4000, 0.35, 41.76, 2.4, 95, 16},
                               Wedge{0.02, 4000, 0.35, 41.76, 1.2, 95, 16},
                               Wedge{0.01, 4000, 0.1, 20, 1.3, 95, 16});
  const double a = wedge.load / (contact_modulus(wedge) * wedge.slope);
  const Reading out = read(wedge);
  CAPTURE(a);
  CHECK(out.force.sum() == Approx(wedge.load / 2).epsilon(1e-9));
  CHECK(ex11_2::wedge_half_width(out.x, out.force) == Approx(a).epsilon(0.006));
}

// The pressure is infinite at the tip but only as a logarithm: from the third node on the mesh follows it.
TEST_CASE("ex11.2 held out: the pressure is the closed form", "[ex11.2]") {
  const Wedge wedge{0.01, 4000, 0.35, 20.88, 1.3, 95, 48};
  const double a = wedge.load / (contact_modulus(wedge) * wedge.slope);
  const Indenter indenter{signorini::IndenterShape::Wedge, contact_modulus(wedge), wedge.slope};
  const Reading out = read(wedge);
  for (Index k = 3; out.x(k) < 0.9 * a; ++k) {
    CAPTURE(out.x(k) / a);
    CHECK(out.pressure(k) ==
          Approx(signorini::indentation_pressure(indenter, a, out.x(k))).epsilon(0.02));
  }
}

TEST_CASE("ex11.2 held out: nothing holds the wedge but the axis and the contact", "[ex11.2]") {
  const signorini::Scene scene = ex11_2::wedge_on_plate({0.01, 4000, 0.35, 41.76, 2.4, 95, 16});
  const std::vector<Index> top = signorini::boundary_nodes(scene.bodies[0].mesh, "base");
  for (const Index node : top) CHECK(scene.bodies[0].mesh.nodes(node, 1) == Approx(95));
  CHECK(signorini::plan(scene).modes.size() == 1);
  const signorini::Solution solution = signorini::solve(scene);
  const signorini::NodeArray& down = solution.displacements.at(1);
  for (const Index node : signorini::boundary_nodes(scene.bodies[1].mesh, "base"))
    CHECK(down.row(node).isZero());
  for (std::size_t body = 0; body < 2; ++body)
    for (const Index node : signorini::boundary_nodes(scene.bodies[body].mesh, "axis"))
      CHECK(solution.displacements.at(body)(node, 0) == 0);
}
