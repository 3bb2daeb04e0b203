// Chapter 10 - Forces of nodes: Gauss points only integrate their gaps (after Lin et al., sec. 2.4).
// Run:  make ch10     Reads: nothing     Writes: ch10_quadrature.results,
//       quadrature.md, fig_10_4*.csv
#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <utility>
#include <vector>

#include "interfaces.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/pairing/mortar_segments.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch10;
using Eigen::Index;

std::string percent(double x) { return number(100 * x, x < 0.995 ? "%.2g" : "%.0f"); }
const char* tolerance = "rel 1e-4 abs 1e-6";  // of the curves

Eigen::Vector2d nodal_errors(const Sampling& by) {  // worst of three blocks, mean of three discs
  Eigen::Vector2d error(0, 0);
  for (const auto& [source, target] : {std::pair(8, 11), std::pair(11, 8), std::pair(7, 15)}) {
    const Eigen::VectorXd p = solved(blocks(source, target, by), "blocks").solution.pressure;
    error(0) = std::max(error(0), (p.array() - 1).abs().maxCoeff());
  }
  for (const Eigen::Index cells : {18, 21, 23}) {
    const SolvedScene disc = solved(hertz(cells, by), "disc");
    const Pairs& pairs = disc.model.pairs;
    error(1) += against_hertz(pairs.position, pairs.weight, disc.solution.pressure).rms / 3;
  }
  return error;
}

/// The k for which y = c x^k fits best, by least squares of the logarithms.
double power(const std::vector<double>& x, const std::vector<double>& y) {
  const Eigen::Index n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd lines = Eigen::MatrixXd::Ones(n, 2);
  lines.col(1) = Eigen::VectorXd::Map(x.data(), n).array().log();
  const Eigen::VectorXd logs = Eigen::VectorXd::Map(y.data(), n).array().log();
  return least_norm_solution(lines, logs)(1);
}

/// Pieces into which the nodes of the lower block cut the edges of the upper one.
std::size_t count_segments(Eigen::Index source_edges, Eigen::Index target_edges) {
  const Scene scene = blocks(source_edges, target_edges, {});
  const Mesh& upper = scene.bodies[0].mesh;
  const Mesh& lower = scene.bodies[1].mesh;
  GapOptions options;
  options.n_nodes = upper.n_nodes() + lower.n_nodes();
  const Interface interface({upper, "bottom", 0}, {lower, "top", upper.n_nodes()}, options);
  std::size_t segments = 0;
  for (const std::vector<double>& cuts : segment_cuts(interface)) segments += 1 + cuts.size();
  return segments;
}

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }  // of the processor

// 2. Forces of nodes, Gauss points as quadrature of their gaps.
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
  table.row({"2 a segment", std::to_string(2 * count_segments(8, 11)),
             error(0) < 1e-12 ? "rounding" : percent(error(0)), percent(error(1))});
  std::cout << table.markdown();
  write_file(run.out / "quadrature.md", table.markdown());
  write_file(run.out / "fig_10_4.csv", figure.csv(tolerance));
  Table level({"points", "disc"});
  for (const double points : {1.8, 18.0}) level.row({points, 100 * error(1)});
  write_file(run.out / "fig_10_4_segments.csv", level.csv(tolerance));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch10_quadrature");
  quadrature(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch10_quadrature", "Points that only integrate", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}
