// Chapter 22 - Ironing at large strain: a die goes two fifths of its radius into a soft slab, and along it.
// Takes longer than 5 s: ./run.sh shows its committed results.
// Run:  make ch22     Reads: nothing     Writes: ch22_iron.results, iron.md, fig_22_7_die_0.csv, fig_22_7_die_1.csv, fig_22_7_die_2.csv,
//      fig_22_7_slab_0.csv, fig_22_7_slab_1.csv, fig_22_7_slab_2.csv, fig_22_7_arrows_0.csv, fig_22_7_arrows_1.csv,
//      fig_22_7_arrows_2.csv, fig_22_8.csv
#include <cmath>
#include <iostream>

#include "addons/frontal/frontal_factor.hpp"
#include "addons/motion/register.hpp"
#include "addons/steps/steps.hpp"
#include "papers/field_csv.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/pairing/interface.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

Body neo_hookean(Mesh mesh, double youngs_modulus) {
  Body body;
  body.mesh = std::move(mesh);
  body.element = "q4";
  body.material = {youngs_modulus, 0.32, PlaneState::Strain, 1};
  body.material.law = find_strain_law("neo_hooke");
  return body;
}

// A die of radius 1, ten times as stiff as the slab of 8 by 2: down by 0.4 in 8 steps, along by 4 in 60.
Scene ironing() {
  const double half = std::acos(0.5);  // of the arc
  const Mesh die = mapped(block("die", {-1, 0}, {2, 1}, 18, 10), [=](const Vector2d& x) -> Vector2d {
    const Vector2d arc(std::sin(half * x.x()), -std::cos(half * x.x()));
    const Vector2d top(std::sin(half) * x.x(), 0.3);
    return Vector2d(2, 3) + (1 - x.y()) * arc + x.y() * top;
  });
  Scene scene;
  scene.bodies = {neo_hookean(block("slab", {0, 0}, {8, 2}, 80, 16), 1), neo_hookean(die, 10)};
  scene.bodies[0].supports = {fixed("bottom")};
  scene.bodies[1].supports = {prescribed("top", Axis::X, 4), prescribed("top", Axis::Y, -0.4)};
  scene.bodies[1].supports[0].history = "drag";
  scene.bodies[1].supports[1].history = "press";
  scene.contacts = {{{"bottom", "die"}, Side{"top", "slab"}}};
  scene.contacts[0].friction = Friction{0.3};
  std::vector<double> times = equal_steps(8);
  for (const double time : equal_steps(60)) times.push_back(1 + time);
  scene.path = Path{times, {{"press", {0, 1}, {0, 1}}, {"drag", {1, 2}, {0, 1}}}};
  return scene;
}

void frame(const ProgramOptions& run, int number, const Model& model, const Solution& solution) {
  const char* names[] = {"slab", "die"};
  for (std::size_t b = 0; b < 2; ++b) {
    const Mesh& mesh = model.bodies[b].mesh;
    write_file(run.out / text("fig_22_7_", names[b], "_", number, ".csv"),
               deformed_cells_csv(mesh, solution.displacements[b], VectorXd::Zero(mesh.n_cells())));
  }
  write_file(run.out / text("fig_22_7_arrows_", number, ".csv"),
             pressure_arrows_csv(model.pairs.position, model.pairs.normal, solution.pressure));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_iron");
  Table path({"way", "press", "drag"}), table({"step", "way of the die", "press", "drag"});
  Index done = 0;
  double searches = 0;
  Vector2d sum(0, 0);  // of forces on the die while all of the contact slides, over whole waves
  const PathEnd end = solve_steps(ironing(), [&](const Model& model, const Step& step) {
    const Vector2d force = contact_forces(model, step.solution, 1).colwise().sum().transpose();
    const double way = 4 * std::max(0.0, step.state.time - 1);
    ++done;
    searches += double(step.solution.ledger.counted("pairs", "searches"));
    path.row({way, force.y(), -force.x()});
    if (way > 1 && way <= 3) sum += force;
    if (done == 8 || done == 20 || done == 38)
      table.row({number(double(done)), number(way, "%.2f"), number(force.y(), "%.4f"),
                 number(-force.x(), "%.4f")});
    if (done == 8 || done == 38 || done == 68) frame(run, int(done) / 30, model, step.solution);
    if (done == 38) results.add("press", force.y(), "-");
    if (done == 38) results.add("drag", -force.x(), "-");
  });
  std::cout << table.markdown();
  write_file(run.out / "iron.md", table.markdown());
  write_file(run.out / "fig_22_8.csv", path.csv("rel 1e-4 abs 1e-6"));
  results.add("drag_over_press", -sum.x() / sum.y(), "-");
  // Each force leans by atan(mu) from its normal.
  results.add("lean", (std::atan2(-sum.x(), sum.y()) - std::atan(0.3)) * 180 / pi, "degrees");
  results.add("steps", double(done), "-");
  results.add("halved", double(end.halvings), "-");
  results.add("searches", searches / double(done), "-", Repeats::No);
  results.print();
  results.write(run.out);
  return end.status;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22_iron", "Ironing at large strain", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
