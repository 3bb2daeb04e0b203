// Chapter 10 - One Gauss point and the forces on its four nodes (Lin et al., sec. 2.4, eqs. 32-41).
// Run:  make ch10     Reads: nothing     Writes: ch10.results, element.md
#include "signorini/contact/gauss_points.hpp"

#include <array>
#include <cmath>
#include <iostream>

#include "interfaces.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch10;
using Eigen::VectorXd;

std::string digits(double x) { return number(std::abs(x) < 5e-5 ? 0 : x, "%.4f"); }

// 1. A cell of width 1 rests on one of width 2.
/// What a pressure of 3 and a shear of 1 at the first point put on the nodes.
struct OnePoint {
  Pairs pairs;
  std::array<double, 4> x, normal, friction;
};

/// \PaperEq{LinEtAl, 32} to \PaperEq{LinEtAl, 36}, \PaperEq{LinEtAl, 38} to \PaperEq{LinEtAl, 41}
OnePoint press_one_point() {
  const Mesh source = block("source", {0.75, 1}, {1, 1}, 1, 1);
  const Mesh target = block("target", {0, 0}, {2, 1}, 1, 1);
  GapOptions options;
  options.n_nodes = source.n_nodes() + target.n_nodes();
  options.sliding = true;
  const Pairs pairs =
      gauss_points({source, "bottom", 0}, {target, "top", source.n_nodes()}, options);
  const double share = pairs.weight(0);                                      // l_12 / 2
  const VectorXd normal = pairs.opening.row(0).transpose() * (3 * share);    // (33)-(36)
  const VectorXd friction = pairs.sliding.row(0).transpose() * (1 * share);  // (38)-(41)

  OnePoint point{pairs, {}, {}, {}};
  const std::vector<Eigen::Index> on = boundary_nodes(source, "bottom");
  const std::vector<Eigen::Index> below = boundary_nodes(target, "top");
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Index own = k < 2 ? on[k] : below[k - 2];
    const Eigen::Index node = k < 2 ? own : source.n_nodes() + own;
    point.x[k] = (k < 2 ? source : target).nodes(own, 0);
    point.normal[k] = normal(2 * node + 1);
    point.friction[k] = friction(2 * node);
  }
  return point;
}

// 2. One Gauss point: the forces on its four nodes.
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
  std::cout << table.markdown();
  write_file(run.out / "element.md", table.markdown());
  results.add("share", point.pairs.weight(0), "-");
  results.add("point_x", point.pairs.position(0, 0), "-");
  results.add("force_1", point.normal[0], "-");
  results.add("force_2", point.normal[1], "-");
  results.headline("force_1", 0.75 * (1 + 1 / std::sqrt(3)), "(35) by hand");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch10");
  one_point(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch10", "Gauss-point surface contact", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
