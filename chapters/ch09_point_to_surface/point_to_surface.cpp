// Chapter 9 - Point-to-surface contact (Lin et al., sec. 2.3, eqs. 20-31).
// Run:  make ch09     Reads: nothing     Writes: ch09.results, element.md, patch.md, corner.md,
//       printed.md, newton.md, units.md, fig_9_1.csv, fig_9_2.csv, fig_9_3.csv
#include <chrono>
#include <cmath>

#include "contact_element.hpp"
#include "curves.hpp"
#include "newton.hpp"
#include "scenes.hpp"
#include "signorini/as_printed/saddle_point_newton.hpp"
#include "signorini/contact/node_to_segment.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/assembly.hpp"
#include "signorini/report/program.hpp"

namespace {

using namespace ch09;
using namespace signorini;

std::string small(double x) { return x < 1e-12 ? "below 1e-12" : number(x, "%.0e"); }
std::string percent(double x) { return x < 1e-12 ? "below 1e-10" : number(100 * x, "%.2f"); }

const Nodes X = (Nodes() << 4, 0, 0, 3, 3, 1.5).finished();  // [mm]

// 1. One node over one edge: (20)-(27).
void one_element(const ProgramOptions& run, Results& results) {
  const Place at = projected(X);
  results.add("N1", at.N1, "-");
  results.add("N2", at.N2, "-");
  results.add("initial_gap", at.gap, "mm");
  Table table({"force on", "of f_n = 1", "of τ = 1", "at"});
  const Nodes fn = nodal_forces(at, 1, 0), ft = nodal_forces(at, 0, 1);
  const auto vector = [](double x, double y) {
    return text("(", number(x, "%.3f"), ", ", number(y, "%.3f"), ")");
  };
  for (Index i = 0; i < 3; ++i)
    table.row({text("node ", i + 1), vector(fn(i, 0), fn(i, 1)), vector(ft(i, 0), ft(i, 1)),
               vector(X(i, 0), X(i, 1))});
  write_file(run.out / "element.md", table.markdown());
  if (std::abs(moment(X, fn)) > 1e-14) throw NotSolved("the normal forces turn the bodies");
  results.add("moment_of_friction", moment(X, ft), "N mm");
  write_file(run.out / "fig_9_1.csv", sketch(X, 1.2, 0.5).csv());
}

// 2. The same for every pair of two meshes, by the library: forces and moments of N and S.
// [balance]
void balance(Results& results) {
  const Scene scene = round_block(20, {"mm"});
  const Mesh &lower = scene.bodies[0].mesh, &upper = scene.bodies[1].mesh;
  GapOptions options;
  options.n_nodes = lower.n_nodes() + upper.n_nodes();
  options.sliding = true;
  const Pairs pairs =
      node_to_segment({upper, "bottom", lower.n_nodes()}, {lower, "top", 0}, options);
  Eigen::MatrixXd motion(2 * options.n_nodes, 3);  // to the right, up, and a turn
  for (Index i = 0; i < options.n_nodes; ++i) {
    const auto x = i < lower.n_nodes() ? lower.nodes.row(i) : upper.nodes.row(i - lower.n_nodes());
    motion.row(2 * i) << 1, 0, -x(1);
    motion.row(2 * i + 1) << 0, 1, x(0);
  }
  const Eigen::MatrixXd pressing = pairs.opening * motion, dragging = pairs.sliding * motion;
  // [balance]
  if (pressing.cwiseAbs().maxCoeff() > 1e-13 || dragging.leftCols(2).cwiseAbs().maxCoeff() > 1e-13)
    throw NotSolved("forces of pairs are not in balance");
  if ((dragging.col(2) + pairs.initial_gap).cwiseAbs().maxCoeff() > 1e-13)
    throw NotSolved("friction across a gap has another moment than it should");
  results.add("n_balanced", static_cast<double>(pairs.initial_gap.size()), "-");
}

// 3. The patch test, both ways round, and finer.
void patch_test(const ProgramOptions& run, Results& results) {
  Table table({"edges above", "below", "source above: pressure", "overlap",
               "source below: pressure", "overlap ", "mortar: pressure"});
  Table curve({"x", "p"});
  for (const auto& [above, below] : {std::pair(8, 11), std::pair(11, 8), std::pair(7, 15),
                                     std::pair(7, 10), std::pair(16, 22), std::pair(32, 44)}) {
    const Pressed up = pressed(above, below, Source::Upper, "node_to_segment");
    const Pressed low = pressed(above, below, Source::Lower, "node_to_segment");
    table.row({std::to_string(above), std::to_string(below), percent(up.deviation),
               percent(up.overlap), percent(low.deviation), percent(low.overlap),
               percent(pressed(above, below, Source::Upper, "mortar").deviation)});
    const std::string name = text("_", above, "_", below);
    results.add("deviation" + name, 100 * up.deviation, "%");
    results.add("overlap" + name, 100 * up.overlap, "%");
    if (name != "_8_11" && name != "_7_15") continue;
    const Scene scene = patch(above, below, Source::Upper, "node_to_segment");
    const SolvedScene one = solved(scene, "patch test");
    for (Index i = 0; i < one.solution.pressure.size(); ++i)
      curve.row({one.model.pairs.position(i, 0), one.solution.pressure(i) / 0.01});
    curve.blank_line();
    const BoundaryForces under = boundary_forces(one, {"top", "lower"});
    for (Index i = 0; i < under.weight.size(); ++i)
      curve.row({under.position(i, 0), -under.force(i, 1) / under.weight(i) / 0.01});
    curve.blank_line();
  }
  write_file(run.out / "patch.md", table.markdown());
  write_file(run.out / "fig_9_2.csv", curve.csv());
}

// 4. A corner of the target between two nodes of the source.
void corners(const ProgramOptions& run, Results& results) {
  Table table({"cells of the wide block", "source wide: overlap", "force", "source narrow: overlap",
               "force ", "mortar, source wide: overlap", "force  "});
  double mortar_overlap = 0;
  for (const Index cells : {7, 10, 20, 40}) {
    std::vector<std::string> row = {std::to_string(cells)};
    for (const auto& [source, name] :
         {std::pair(Source::Upper, "node_to_segment"), std::pair(Source::Lower, "node_to_segment"),
          std::pair(Source::Upper, "mortar")}) {
      const Scene scene = corner(cells, source, name);
      const SolvedScene one = solved(scene, "corner");
      const double part = overlap(scene, one) / 0.01, force = one.solution.contact.force.sum();
      row.push_back(percent(part));
      row.push_back(number(1000 * force, "%.2f"));
      if (text(name) == "mortar") mortar_overlap = std::max(mortar_overlap, part);
      if (cells != 7 || text(name) == "mortar") continue;
      const std::string side = source == Source::Upper ? "wide" : "narrow";
      if (source == Source::Upper) results.add("overlap_wide", 100 * part, "%");
      results.add("force_" + side, 1000 * force, "-");
    }
    table.row(row);
  }
  results.add("overlap_mortar", 100 * mortar_overlap, "%");
  write_file(run.out / "corner.md", table.markdown());
}

// 5. The equations of one element as printed and repaired.
void as_printed(const ProgramOptions& run, Results& results) {
  const Place at = projected(X);
  ContactElement element{X, (Vector6d() << 10, 10, 10, 10, 5, 5).finished(), Vector6d::Zero(), 0.3,
                         0};
  Vector10d start = Vector10d::Zero();
  start(6) = 1;
  const Vector10d somewhere = Vector10d::LinSpaced(0.3, 0.93);
  Table table({"shear load", "c", "bound", "upper right block", "ends", "f_n", "τ", "u⁺", "u⁻"});
  for (const auto& [shear, cohesion] :
       {std::pair(0.5, 0.0), std::pair(4.0, 0.0), std::pair(4.0, 1.0)})
    for (const auto& [bound, reaction] : {std::pair(1, -1), std::pair(-1, -1), std::pair(1, 1)}) {
      element.load.tail(2) = -6 * at.n + shear * at.t;
      element.cohesion = cohesion;
      element.bound = bound;
      element.reaction = reaction;
      const End end = solved(element, start);
      std::vector<std::string> row = {number(shear), number(cohesion),
                                      bound > 0 ? "c + μ f_n" : "c - μ f_n",
                                      reaction < 0 ? "-a" : "a"};
      row.push_back(end.solved           ? text("after ", end.steps)
                    : end.residual > 1e6 ? "runs away"
                                         : text("never, residual ", number(end.residual, "%.1f")));
      for (Index i = 6; i < 10; ++i)
        row.push_back(end.solved ? number(std::abs(end.x(i)) < 1e-9 ? 0 : end.x(i), "%.3f") : "");
      table.row(row);
      const bool right = jacobian_error(element, somewhere) < 1e-8;
      if (right != (reaction < 0)) throw NotSolved("the Jacobian is not what it should be");
    }
  write_file(run.out / "printed.md", table.markdown());
  element.reaction = 1;
  results.add("jacobian_error_printed", jacobian_error(element, somewhere), "-");
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// 6. Condensed and uncondensed on the round block.
// [compare]
void compare(const ProgramOptions& run, Results& results) {
  Table table({"unknowns", "pairs", "closed", "condensed", "condensed, library", "uncondensed",
               "as printed", "forces, to 1e-11"});
  std::vector<Index> sizes = {16, 24, 40};
  if (run.full) sizes.insert(sizes.end(), {80, 132});  // the last has 20,000 nodes
  for (const Index n : sizes) {
    const double begin = seconds();
    const SolvedScene one = solved(round_block(n, {"mm"}), "round block");
    const double middle = seconds();
    const SaddlePointSolution two = saddle_point_newton(one.model.programme);
    const double end = seconds();
    // [compare]
    SaddlePointOptions printed;
    printed.form = SaddlePointForm::AsPrinted;
    const SaddlePointSolution three = saddle_point_newton(one.model.programme, printed);
    const Way way = condensed_newton(one.condensed.problem);
    const Eigen::VectorXd& force = one.solution.contact.force;
    if (two.report.status != Status::Solved) throw NotSolved("uncondensed Newton");
    for (const Eigen::VectorXd& other : {two.solution.force, way.force})
      if ((other - force).norm() > 1e-11 * force.norm()) throw NotSolved("forces differ");
    results.add(text("time_ratio_", n), (end - middle) / (middle - begin), "-", Repeats::No);
    if (n > 40) continue;
    table.row({number(static_cast<double>(one.model.unknowns.count)),
               number(static_cast<double>(force.size())),
               number(static_cast<double>(one.solution.contact.active.size())),
               std::to_string(way.residuals.size() - 1),
               std::to_string(one.solution.contact.report.iterations),
               std::to_string(two.report.iterations), std::to_string(three.report.iterations),
               "the same"});
    if (n != 40) continue;
    results.add("total_force", force.sum(), "N");
    results.headline("total_force", two.solution.force.sum(), "the uncondensed equations (30)");
    Ledger ledger;
    const Model in_metres = build(round_block(n, {"m, N", 1e-3, 1}), ledger);
    const SaddlePointSolution four = saddle_point_newton(in_metres.programme, printed);
    const Table curves = histories(way, {&two.report, &three.report, &four.report});
    write_file(run.out / "fig_9_3.csv", curves.csv("rel 1e-3 abs 1e-9"));
  }
  write_file(run.out / "newton.md", table.markdown());
}

// 7. The printed equations in other units.
void units(const ProgramOptions& run, Results& results) {
  const Eigen::VectorXd exact = solved(round_block(20, {"mm"}), "units").solution.contact.force;
  Table table({"units", "steps to 1e-6", "error of the forces", "steps to 1e-12", "error",
               "steps, scaled", "error "});
  double worst = 0;
  for (const Units& u : {Units{"mm, MN", 1, 1e-6}, Units{"mm, kN", 1, 1e-3}, Units{"mm, N", 1, 1},
                         Units{"m, kN", 1e-3, 1e-3}, Units{"m, N", 1e-3, 1}}) {
    Ledger ledger;
    const Model model = build(round_block(20, u), ledger);
    std::vector<std::string> row = {u.name};
    constexpr auto as_printed = SaddlePointForm::AsPrinted;
    for (const auto& [tolerance, form] :
         {std::pair(1e-6, as_printed), {1e-12, as_printed}, {1e-12, SaddlePointForm::OneUnit}}) {
      SaddlePointOptions options;
      options.tolerance = tolerance;
      options.form = form;
      const SaddlePointSolution end = saddle_point_newton(model.programme, options);
      const double error =
          (end.solution.force / u.force - exact).cwiseAbs().maxCoeff() / exact.maxCoeff();
      row.push_back(std::to_string(end.report.iterations));
      row.push_back(small(error));
      worst = std::max(worst, error);
    }
    table.row(row);
  }
  write_file(run.out / "units.md", table.markdown());
  results.add("worst_error", worst, "-");
}

Status chapter(const ProgramOptions& run) {
  Results results("ch09");
  one_element(run, results);
  balance(results);
  patch_test(run, results);
  corners(run, results);
  as_printed(run, results);
  compare(run, results);
  units(run, results);
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch09", "Point-to-surface contact", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
