// Chapter 10 - Gauss-point surface contact (Lin et al., sec. 2.4, eqs. 32-42).
// Run:  make ch10     Reads: nothing     Writes: ch10.results, element.md, rank.md, possible.md,
//       hertz.md, quadrature.md, compliance.md, friction.md, fig_10_2*.csv, fig_10_3*.csv, fig_10_1*.csv
#include <ctime>

#include "interfaces.hpp"
#include "nodal.hpp"
#include "one_point.hpp"
#include "possible.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/shown.hpp"
#include "signorini/solvers/solvers.hpp"
#include "soft.hpp"
#include "three_points.hpp"

namespace {

using namespace ch10;
using Eigen::Index;
using Eigen::VectorXd;

std::string digits(double x) { return number(std::abs(x) < 5e-5 ? 0 : x, "%.4f"); }
std::string percent(double x) { return number(100 * x, x < 0.995 ? "%.2g" : "%.0f"); }
const char* tolerance = "rel 1e-4 abs 1e-6";  // of the curves
const double q0 = hertz_peak_pressure(hertz_contact);
const double b = hertz_half_width(hertz_contact);

// 1. One Gauss point: the forces on its four nodes.
void one_point(const ProgramOptions& run, Results& results) {
  const OnePoint point = press_one_point();
  Table table({"node", "x", "normal force", "friction", "moment of the normal force"});
  Eigen::Vector3d sum(0, 0, 0);
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d row(point.normal[k], point.friction[k], point.x[k] * point.normal[k]);
    sum += row;
    table.row({std::to_string(k + 1), number(point.x[k], "%.2f"), digits(row(0)), digits(row(1)),
               digits(row(2))});
  }
  table.row({"sum", "", digits(sum(0)), digits(sum(1)), digits(sum(2))});
  write_file(run.out / "element.md", table.markdown());
  results.add("share", point.pairs.weight(0), "-");
  results.add("point_x", point.pairs.position(0, 0), "-");
}

// 2. Two blocks: how many pressures the nodes can tell apart, and what each of them may be.
void two_blocks(const ProgramOptions& run, Results& results) {
  const std::vector<std::pair<Index, Index>> meshes = {{8, 8}, {8, 11}, {11, 8}, {7, 15}};
  Table ranks({"points", "8/8", "8/11", "11/8", "7/15"});
  Table bounds({"points", "8/8", "in closed form", "8/11", "11/8", "7/15", "disc, nodes on nodes",
                "its least pressures, rms error %"});
  for (int points = 1; points <= 6; ++points) {
    std::vector<std::string> rank = {std::to_string(points)}, highest = rank;
    for (const auto& [source, target] : meshes) {
      const ClosedPoints closed =
          closed_points(solved(blocks(source, target, {"gauss_points", points}), "blocks"));
      rank.push_back(text(closed.rank, " of ", closed.points.size()));
      const double most = possible_pressures(closed).highest.maxCoeff();
      highest.push_back(number(most, "%.3f"));
      const std::string key = text(points, "_", source, "_", target);
      results.add("rank_" + key, static_cast<double>(closed.rank), "-");
      results.add("highest_" + key, most, "-");
      if (&source != &meshes.front().first) continue;
      double alone = 0;  // one point carries a node: f = h = (h/2) weight N p
      for (const GaussPoint& gauss : gauss_line(points))
        alone = std::max(alone, 4 / (gauss.weight * (1 + std::abs(gauss.xi))));
      highest.push_back(points == 1 ? "" : number(alone, "%.3f"));
    }
    const SolvedScene disc = solved(hertz(16, {"gauss_points", points}), "disc");
    const ClosedPoints closed = closed_points(disc);
    const Bounds possible = possible_pressures(closed);
    const NodeArray at = disc.model.pairs.position(closed.points, Eigen::all);
    const PressureError least = against_hertz(at, closed.root.cwiseAbs2(), least_pressures(closed));
    highest.push_back(number(possible.highest.maxCoeff() / q0, "%.3f"));
    highest.push_back(percent(least.rms));
    ranks.row(rank);
    bounds.row(highest);
    if (points == 2 || points == 3)
      write_file(run.out / text("fig_10_1", points == 2 ? "" : "_three", ".csv"),
                 table_of({{"x", at.col(0) / b},
                           {"lowest", possible.lowest / q0},
                           {"highest", possible.highest / q0}})
                     .csv(tolerance));
  }
  write_file(run.out / "rank.md", ranks.markdown());
  write_file(run.out / "possible.md", bounds.markdown());
}

// 3. The same pressures as several solvers return them: which ones depends on rounding.
/// \PaperEq{LinEtAl, 37}
void several_solvers(Results& results) {
  const Scene scene = hertz(16, {"gauss_points", 3});
  const SolvedScene first = shown(scene, "the disc");
  const NodeArray nodal = contact_forces(first.model, first.solution);
  for (const char* name : {"quasi_active_set", "goldfarb_idnani", "lemke", "fischer_burmeister",
                           "projected_gauss_seidel", "primal_dual_active_set"}) {
    const Solution other = solve(first.model, first.condensed, name, {});
    const bool found = other.contact.report.status == Status::Solved;  // and certified
    const double peak = found ? other.pressure.maxCoeff() / q0 : 0;
    results.add(text("peak_", name), peak, "-", Repeats::No);  // 0: it gave up
    if (found && (contact_forces(first.model, other) - nodal).norm() > 1e-9 * nodal.norm())
      throw NotSolved(text(name, ": other nodal forces"));
  }
}

// 4. A disc whose nodes do not meet those of the plate: pressures that are determined, and wrong.
void disc(const ProgramOptions& run, Results& results) {
  Table table({"points", "determined", "peak / q0", "rms error %", "lumped, rms error %",
               "finer: determined", "peak / q0", "rms error %", "lumped, rms error %"});
  for (int points = 1; points <= 4; ++points) {
    std::vector<std::string> row = {std::to_string(points)};
    for (const Index finer : {1, 2}) {
      const Scene scene = hertz(21, {"gauss_points", points}, finer);
      const SolvedScene now = solved(scene, "disc");
      const ClosedPoints closed = closed_points(now);
      const bool unique = closed.free.cols() == 0;
      const Pairs& pairs = now.model.pairs;
      const VectorXd p = now.solution.pressure / q0;
      const PressureError error = against_hertz(pairs.position, pairs.weight, q0 * p);
      const PressureError lumped = lumped_error(scene, now);
      row.insert(row.end(), {text(closed.rank, " of ", closed.points.size()),
                             unique ? number(error.peak, "%.2f") : "",
                             unique ? percent(error.rms) : "", percent(lumped.rms)});
      const std::string key = text(points, finer == 1 ? "" : "_finer");
      const Repeats repeats = unique ? Repeats::Yes : Repeats::No;
      results.add("peak_" + key, error.peak, "-", repeats);
      results.add("rms_" + key, 100 * error.rms, "%", repeats);
      results.add("lumped_" + key, 100 * lumped.rms, "%");
      if (points == 1 || finer == 2) continue;
      const char* panel[] = {"", "_three", "_four"};
      write_file(run.out / text("fig_10_2", panel[points - 2], ".csv"),
                 table_of({{"x", pairs.position.col(0) / b}, {"p", p}}).csv(tolerance));
    }
    table.row(row);
  }
  write_file(run.out / "hertz.md", table.markdown());
  const SolvedScene nodal = solved(hertz(21, {"mortar", 0, Quadrature::Segments}), "disc");
  write_file(run.out / "fig_10_2_nodal.csv", table_of({{"x", nodal.model.pairs.position.col(0) / b},
                                                       {"p", nodal.solution.pressure / q0}})
                                                 .csv(tolerance));
}

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }  // of the processor

// 5. Forces of nodes, Gauss points as quadrature of their gaps.
void quadrature(const ProgramOptions& run, Results& results) {
  Table table({"points", "projections, 8/11", "blocks: worst error %", "disc: rms error %"});
  Table figure({"points", "patch", "disc"});
  std::vector<double> counts, patch, took;
  for (const int points : {2, 3, 4, 5, 6, 8, 10, 13, 16}) {
    const double begin = seconds();
    const Eigen::Vector2d error = nodal_errors({"mortar", points});
    took.push_back(seconds() - begin);
    counts.push_back(points);
    patch.push_back(error(0));
    table.row({text(points, " an edge"), std::to_string(8 * points), percent(error(0)),
               percent(error(1))});
    figure.row({static_cast<double>(points), 100 * error(0), 100 * error(1)});
    results.add(text("patch_", points), 100 * error(0), "%");
    results.add(text("disc_", points), 100 * error(1), "%");
  }
  results.add("patch_power", -power(counts, patch), "-");
  results.add("time_16_over_2", took.back() / took.front(), "-", Repeats::No);
  const Eigen::Vector2d error = nodal_errors({"mortar", 0, Quadrature::Segments});
  results.add("patch_segments", error(0), "-", Repeats::No);
  results.add("disc_segments", 100 * error(1), "%");
  results.headline("disc_segments", 0, "the closed form of Hertz");
  table.row({"2 a segment", std::to_string(2 * count_segments(8, 11)),
             error(0) < 1e-12 ? "rounding" : percent(error(0)), percent(error(1))});
  write_file(run.out / "quadrature.md", table.markdown());
  write_file(run.out / "fig_10_3.csv", figure.csv(tolerance));
  Table level({"points", "disc"});
  for (const double points : {1.8, 18.0}) level.row({points, 100 * error(1)});
  write_file(run.out / "fig_10_3_segments.csv", level.csv(tolerance));
}

// 6. Points that yield.
void compliance(const ProgramOptions& run, Results& results) {
  Table table({"α", "2 points: peak / q0", "rms error %", "4 points: peak / q0", "rms error %",
               "overlap, % of b²/2R"});
  for (const char* alpha : {"0.001", "0.01", "0.03", "0.1", "0.3", "1"}) {
    std::vector<std::string> row = {alpha};
    for (const int points : {2, 4}) {
      const Soft soft = soft_points(hertz(21, {"gauss_points", points}), std::stod(alpha));
      row.insert(row.end(), {number(soft.error.peak, "%.3f"), percent(soft.error.rms)});
      if (points == 4) row.push_back(percent(soft.overlap));
      results.add(text("soft_rms_", points, "_", alpha), 100 * soft.error.rms, "%");
      results.add(text("soft_overlap_", points, "_", alpha), 100 * soft.overlap, "%");
    }
    table.row(row);
  }
  write_file(run.out / "compliance.md", table.markdown());
  const Soft meeting = soft_points(hertz(16, {"gauss_points", 4}), 0.001);
  results.add("soft_matching", 100 * meeting.error.rms, "%");
}

// 7. Friction: two solutions for three points, and blocks that are pressed and dragged.
/// \PaperEq{LinEtAl, 42}
void friction(const ProgramOptions& run, Results& results) {
  const ThreePoints on = three_points();
  if (!certify(on.problem, on.stick).holds() || !certify(on.problem, on.slide).holds())
    throw NotSolved("three points with friction");
  results.add("stick_slip", on.stick.slip.cwiseAbs().maxCoeff(), "-", Repeats::No);
  results.add("stick_friction", on.stick.friction(0), "-");
  results.add("slide_slip", on.slide.slip(2), "-");
  const ContactState alone = find_solver("primal_dual_active_set").solve(on.nodes, {});
  results.add("nodes_unique", alone.uniqueness == Uniqueness::Proved ? 1 : 0, "-");
  Table table({"forces of", "their sum", "sum of friction", "largest pressure", "largest shear"});
  for (const Sampling& by :
       {Sampling{"mortar", 0, Quadrature::Segments}, Sampling{"gauss_points", 2}}) {
    // [dragged]
    Scene scene = blocks(8, 11, by);
    Body& upper = scene.bodies[0];
    upper.loads.edges.clear();
    upper.supports = {prescribed("top", Axis::Y, -0.002), prescribed("top", Axis::X, 0.0005)};
    scene.bodies[1].supports = {fixed("bottom")};
    scene.contacts[0].friction = Friction{0.3, 0};
    // [dragged]
    const SolvedScene now = solved(scene, "blocks with friction");
    const ContactState& state = now.solution.contact;
    const VectorXd shear = state.friction.cwiseQuotient(now.model.pairs.weight).cwiseAbs();
    table.row({by.points == 0 ? "nodes" : "2 points an edge", number(state.force.sum(), "%.4f"),
               number(state.friction.sum(), "%.4f"),
               number(now.solution.pressure.maxCoeff(), "%.3f"), number(shear.maxCoeff(), "%.3f")});
  }
  write_file(run.out / "friction.md", table.markdown());
}

Status chapter(const ProgramOptions& run) {
  Results results("ch10");
  one_point(run, results);
  two_blocks(run, results);
  several_solvers(results);
  disc(run, results);
  quadrature(run, results);
  compliance(run, results);
  friction(run, results);
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch10", "Gauss-point surface contact", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
