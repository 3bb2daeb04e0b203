// Chapter 7 - A rigid pin in an elastic plate (Xuan & Li 2002, sec. 4, example 3).
// Run:  make ch07     Reads: nothing     Writes: ch07.results, nodes.md, even.md, pressures.md, gaps.md,
//                                                disc.md, solvers.md, fig_7_1_*.csv, fig_7_2.csv,
//                                                fig_7_2_paper.csv, fig_7_3_*.csv, fig_7_4_*.csv,
//                                                fig_7_5.csv, ch07.vtu
#include <algorithm>
#include <cmath>
#include <tuple>

#include "signorini/closed_form/pin.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/mesh/plate_with_hole.hpp"
#include "signorini/mesh/ring.hpp"
#include "signorini/report/field_csv.hpp"
#include "signorini/report/printed_method.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/shown.hpp"
#include "signorini/report/vtu.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/solvers.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

const double degree = std::acos(-1.0) / 180;

// 1. What the paper gives and what we add, in cm and kN. Reading (T): q pulls on the right side and the
//    pin bears on the left of the hole; (C): q presses, the pin bears on the right.
// [data]
struct Pin {
  double q;                // paper; pressure on the right side: (T) < 0, (C) > 0 [kN/cm^2]
  double clearance;        // paper: epsilon, read as radius of the hole less radius of the pin [cm]
  bool linear_gap = true;  // or the exact distance from the pin
  [[nodiscard]] double side() const { return q > 0 ? 1 : -1; }  // of the hole that bears
};
const Pin tension{-25, 0.2};
const Pin compression{25, 0.2};
const double hole_radius = 5;                                     // ours
const double plate_size = 20;                                     // ours
const Material plate_material{1000, 0.3, PlaneState::Strain, 1};  // paper; thickness ours
// [data]

// 2. The upper half of the plate.
// [scene]
Scene pin_in_plate(const Pin& pin, Index cells_radius, const VectorXd& rays) {
  PlateWithHoleSpec plate;
  plate.hole_radius = hole_radius;
  plate.size = {plate_size, plate_size};
  plate.cells_angle = rays.size() - 1;
  plate.cells_radius = cells_radius;
  plate.rays = rays;
  plate.sector = Sector::Half;
  const Eigen::Vector2d pole(pin.side() * hole_radius, 0);
  const Eigen::Vector2d shift(pin.side() * pin.clearance, 0);  // the pin touches the pole
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = make_plate_with_hole(plate);
  body.element = "q4";
  body.material = plate_material;
  body.supports = {symmetric("symmetry"), prescribed_at("hole", pole, Axis::X)};
  body.loads.edges = {{"right", pin.q, {}}};
  scene.contacts = {{{"hole"},
                     pin.linear_gap ? pin_in_hole({0, 0}, pin.clearance, shift)
                                    : disc(shift, hole_radius - pin.clearance)}};
  return scene;
}
// [scene]

// What happens at the nodes of the half hole, counted from the pole that bears.
struct Bearing {
  SolvedScene run;
  VectorXd theta, force, pressure;  // [deg, kN, kN/cm^2]
  double resultant;                 // of both halves along x [kN/cm]
  double right;                     // u_x in the middle of the right side [cm]
};

// 3. Radial forces of the pairs, and of the support that stands for the pair at the pole.
// [bearing]
Bearing bearing(const Pin& pin, Index cells_radius, const VectorXd& rays) {
  const Scene scene = pin_in_plate(pin, cells_radius, rays);
  SolvedScene run = shown(scene, "the pin");
  const BoundaryForces hole = boundary_forces(run, {"hole"});  // from the left to the right
  VectorXd theta = (pin.side() * hole.position.col(0).array() / hole_radius).acos() / degree;
  VectorXd force = hole.force.cwiseProduct(hole.position).rowwise().sum() / hole_radius;
  VectorXd pressure = force.cwiseQuotient(hole.weight);
  if (pin.side() > 0)
    for (VectorXd* values : {&theta, &force, &pressure}) values->reverseInPlace();
  if (force(0) < 0) throw NotSolved("the pole pulls at its support: it must not be held");
  const double resultant = 2 * pin.side() * hole.force.col(0).sum();
  const Index right = boundary_nodes(scene.bodies[0].mesh, "right").front();
  const double moved = run.solution.displacements[0](right, 0);
  return {std::move(run), theta, force, pressure, resultant, moved};
}
// [bearing]

Bearing even(const Pin& pin, Index cells) {
  return bearing(pin, cells / 2, VectorXd::LinSpaced(cells + 1, 0, 180 * degree));
}

// 4. The method of the paper as it is printed; `x` counts from the middle of the hole to the pole.
void as_printed(const ProgramOptions& run, Results& results, const std::string& name,
                const SolvedScene& pin, const VectorXd& x) {
  const ContactProblem& problem = pin.condensed.problem;
  if (!solved_in_one_step(problem, pin.solution.contact))
    throw NotSolved("the printed method does not end at the solution after one step");
  const PrintedMethod printed = printed_method(problem);
  write_printed_method(run.out / ("fig_7_4_" + name), printed,
                       (x / hole_radius).array().acos() / degree);
  add_counts(results, printed, "_" + name);
  results.add("least_compliance_" + name,
              problem.compliance.minCoeff() / problem.compliance.maxCoeff(), "-");
}

// 5. The paper's 225 cells and 12 candidates: 11 cells over the quadrant that bears, 4 over the other.
void paper_mesh(const ProgramOptions& run, Results& results) {
  const Bearing t = bearing(tension, 15, rays_by_quadrant({4, 11}));
  const Bearing c = bearing(compression, 15, rays_by_quadrant({11, 4}));
  const auto first = Eigen::seqN(0, 12);
  const Table nodes = table_of({{"θ [deg]", t.theta(first), "%.2f"},
                                {"force (T) [kN]", t.force(first), "%.3f"},
                                {"pressure (T) [kN/cm²]", t.pressure(first), "%.2f"},
                                {"force (C) [kN]", c.force(first), "%.3f"},
                                {"pressure (C) [kN/cm²]", c.pressure(first), "%.2f"}});
  const Table curve =
      table_of({{"theta", t.theta(first)}, {"t", t.pressure(first)}, {"c", c.pressure(first)}});
  write_file(run.out / "nodes.md", nodes.markdown());
  write_file(run.out / "fig_7_2_paper.csv", curve.csv("rel 1e-6 abs 1e-8"));
  write_vtu(run.out / "ch07.vtu", t.run.model, t.run.solution);
  Table family({"solver", "iterations (T)", "iterations (C)"});
  // [family]
  for (const Solver& solver : solvers()) {
    if (solver.largest > 0 && solver.largest < t.run.model.programme.A.rows()) continue;
    std::vector<std::string> row = {solver.name};
    for (const Bearing* now : {&t, &c}) {
      const ContactState state = solver.solve(now->run.condensed.problem, {});
      row.push_back(std::to_string(state.report.iterations));
      if (state.report.status == Status::Solved && state.active != now->run.solution.contact.active)
        throw NotSolved(text(solver.name, " finds other closed pairs"));
    }
    if (row[0] == "quasi_active_set" || row[0] == "primal_dual_active_set") family.row(row);
  }
  // [family]
  write_file(run.out / "solvers.md", family.markdown());
  for (const auto& [name, now] : {std::pair("t", &t), std::pair("c", &c)}) {
    const auto& [model, condensed, solution] = now->run;
    const BodyModel& body = model.bodies[0];
    const NodeArray& u = solution.displacements[0];
    const VectorXd stress = cell_stress(body.mesh, body.element, body.material, u).col(0);
    write_file(run.out / text("fig_7_3_", name, ".csv"), deformed_cells_csv(body.mesh, u, stress));
    write_file(run.out / text("fig_7_3_", name, "_zero.csv"),
               deformed_zero_line_csv(
                   body.mesh, u, nodal_stress(body.mesh, body.element, body.material, u).col(0)));
    write_file(run.out / text("fig_7_1_", name, ".csv"),  // before loading
               deformed_cells_csv(body.mesh, u, stress, 0));
    as_printed(run, results, name, now->run,
               (now->run.model.pairs.position.col(0) * (now == &t ? -1 : 1)));
    if (std::abs(now->resultant - 500) > 500e-10) throw NotSolved("the pin does not bear the load");
    results.add(text("resultant_", name), now->resultant, "kN/cm");
    results.add(text("right_", name), now->right, "cm");
  }
  results.add("mesh_cells", static_cast<double>(t.run.model.bodies[0].mesh.n_cells()), "-");
  results.add("mesh_nodes", static_cast<double>(t.run.model.bodies[0].mesh.n_nodes()), "-");
}

// 6. Even cells along the half hole: 15 to compare programs digit by digit, then finer ones.
void even_meshes(const ProgramOptions& run, Results& results) {
  std::vector<Column> exact = {{"θ [deg]", VectorXd::LinSpaced(8, 0, 84), "%.0f"}};
  std::vector<Column> fine = {{"θ [deg]", VectorXd::LinSpaced(9, 0, 80), "%.0f"}};
  std::vector<Column> curve;
  for (const auto& [name, title, pin] :
       {std::tuple("t", "(T) ", tension), std::tuple("c", "(C) ", compression)}) {
    const Bearing coarse = bearing(pin, 15, VectorXd::LinSpaced(16, 0, 180 * degree));
    exact.push_back({text(title, "[kN]"), coarse.force.head(8), "%.7f"});
    results.add(text("even_right_", name), coarse.right, "cm");
    for (const Index cells : {36, 72, 144}) {
      const Bearing now = even(pin, cells);
      fine.push_back({text(title, cells), now.pressure(Eigen::seqN(0, 9, cells / 18)), "%.2f"});
      if (cells < 144) continue;
      if (curve.empty()) curve.push_back({"theta", now.theta.head(73)});
      curve.push_back({name, now.pressure.head(73)});
      Index peak = 0;
      results.add(text("peak_", name), now.pressure.maxCoeff(&peak), "kN/cm^2");
      results.add(text("peak_angle_", name), now.theta(peak), "deg");
      const Index closed = (now.force.array() > 0).count();
      results.add(text("end_", name), now.theta(closed - 1), "deg");
      results.add(text("fine_right_", name), now.right, "cm");
    }
  }
  write_file(run.out / "even.md", table_of(exact).markdown());
  write_file(run.out / "pressures.md", table_of(fine).markdown());
  write_file(run.out / "fig_7_2.csv", table_of(curve).csv("rel 1e-6 abs 1e-8"));
}

// 7. How linear is it? The exact gap instead of the linear one; a twenty-fifth of load and clearance.
void linearity(const ProgramOptions& run, Results& results) {
  Table table({"gap", "(T) peak [kN/cm²]", "(C) peak [kN/cm²]"});
  for (const bool linear : {true, false}) {
    std::vector<std::string> row = {linear ? "linear" : "distance from the pin"};
    for (const Pin& pin : {tension, compression})
      row.push_back(number(even({pin.q, pin.clearance, linear}, 72).pressure.maxCoeff(), "%.2f"));
    table.row(row);
  }
  write_file(run.out / "gaps.md", table.markdown());
  // [small]
  const VectorXd whole = even(tension, 36).pressure;
  const VectorXd part = even({tension.q / 25, tension.clearance / 25}, 36).pressure;
  const double deviation = (25 * part - whole).norm() / whole.norm();
  if (deviation > 1e-10) throw NotSolved("pressures are not proportional to load and clearance");
  // [small]
  results.add("small_deviation", deviation, "-", Repeats::No);
}

// 8. A pin that is pushed by `shift` into the edge of a hole of radius 1 in a disc of radius 60 and
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
  const double last = theta(solution.contact.active.front());  // they run towards the pole
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
  write_file(run.out / "disc.md", table.markdown());
  write_file(run.out / "fig_7_5.csv", curve.csv("rel 1e-6 abs 1e-8"));
}

Status chapter(const ProgramOptions& run) {
  Results results("ch07");
  paper_mesh(run, results);
  even_meshes(run, results);
  linearity(run, results);
  infinite_plate(run, results);
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch07", "A rigid pin in an elastic plate", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}
