// Chapter 7 - A pin in a disc that could be an infinite plate, against the closed form of Persson.
// Run:  make ch07     Reads: nothing     Writes: ch07_infinite_plate.results, disc.md, fig_7_5.csv
#include <cmath>
#include <iostream>

#include "closed_form/pin.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/readings.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

const double degree = pi / 180;

// A pin that is pushed by `shift` into the edge of a hole of radius 1 in a disc of radius 60 and
//    modulus 1.
struct InDisc {
  PinInPlate pin;            // with the force that the pushing takes
  VectorXd theta, pressure;  // pressure over force: p a / P
  double last;               // angle of the last closed node
};

// [disc]
InDisc pin_in_disc(double poisson_ratio, double clearance, double shift) {
  AnnulusSpec disc;
  disc.outer_radius = 60;
  disc.cells_angle = 120;
  disc.cells_radius = 70;
  disc.grading = similar_cells(disc.outer_radius, disc.cells_radius);
  disc.sector = Sector::Half;
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = make_annulus(disc);
  body.element = "q4_bbar";
  body.material = {/*E*/ 1, poisson_ratio, PlaneState::Strain, /*thickness*/ 1};
  body.supports = {symmetric("symmetry"), prescribed("outer", Axis::X, 0.0)};
  scene.contacts = {{{"inner"}, pin_in_hole({0, 0}, clearance, {shift, 0})}};
  const auto [model, condensed, solution] = solved(scene, "the pin in the disc");
  const double force = 2 * contact_forces(model, solution).col(0).sum();
  const double modulus = 1 / (1 - poisson_ratio * poisson_ratio);  // the pin is rigid
  VectorXd theta(model.programme.A.rows());
  for (Index k = 0; k < theta.size(); ++k)
    theta(k) = std::atan2(model.pairs.position(k, 1), model.pairs.position(k, 0));
  const double last = theta(solution.contact.active().front());  // they run towards the pole
  return {{1, clearance, force, modulus, modulus}, theta, solution.pressure / force, last};
}
// [disc]

void infinite_plate(const ProgramOptions& run, Results& results) {
  Table table({"ν", "shift / clearance", "last closed node [deg]", "closed form [deg]", "p(0) a/P",
               "closed form"});
  Table curve({"theta", "fe", "closed"});
  for (const double nu : {0.4999, 0.3})
    for (const int shift : {2, 5}) {
      const InDisc now = pin_in_disc(nu, 0.01, 0.01 * shift);
      const Index pole = now.theta.size() - 1;
      const double angle = pin_contact_angle(now.pin) / degree;
      const double closed = pin_pressure(now.pin, 0) / now.pin.force;
      table.row({number(nu), std::to_string(shift), number(now.last / degree, "%.1f"),
                 number(angle, "%.2f"), number(now.pressure(pole), "%.4f"),
                 number(closed, "%.4f")});
      if (nu < 0.4) continue;
      for (Index k = pole; now.theta(k) < 90 * degree; --k)
        curve.row({now.theta(k) / degree, now.pressure(k),
                   pin_pressure(now.pin, now.theta(k)) / now.pin.force});
      curve.blank_line();
      if (shift == 2) continue;
      results.add("disc_angle", now.last / degree, "deg");
      results.add("disc_angle_closed_form", angle, "deg");
      results.add("disc_pressure", now.pressure(pole), "-");
      results.headline("disc_pressure", closed, "closed form, infinite plate");
    }
  std::cout << table.markdown();
  write_file(run.out / "disc.md", table.markdown());
  write_file(run.out / "fig_7_5.csv", curve.csv("rel 1e-6 abs 1e-8"));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch07_infinite_plate");
  infinite_plate(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch07_infinite_plate", "A pin in an infinite plate", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}
