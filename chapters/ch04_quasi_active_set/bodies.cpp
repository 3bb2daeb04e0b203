// Chapter 4 - Contact of bodies: the block of chapter 1, the cantilever of chapter 6, a half-plane, two elastic blocks; and
// the flow chart with how often three runs went along each of its arrows.
// Run:  make ch04     Reads: nothing     Writes: bodies.md, fig_4_1.csv
#include <array>
#include <iostream>

#include "cases.hpp"
#include "papers/examples.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "signorini/core/table.hpp"
#include "meshes/block.hpp"
#include "signorini/pairing/node_to_segment.hpp"  // the operators of these contacts, linked with it
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/scene.hpp"

namespace {

using namespace signorini;
using namespace ch04;
using Rows = QuasiActiveRows;

ContactProblem condensed(Scene scene, const Obstacle& obstacle) {
  scene.contacts = {{{"bottom"}, obstacle}};
  Ledger ledger;
  return condense(build(scene, ledger), ledger).problem;
}

// 1. The block of chapter 1 on its obstacle, and the cantilever of chapter 6 on its foundation.
ContactProblem block_on_obstacle() {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {-20, 0}, {40, 20}, 160, 80);
  body.material = {10, 0.3, PlaneState::Strain, 1};
  body.supports = {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -1.0)};
  return condensed(scene, disc({0, -60}, 60));
}

ContactProblem cantilever() {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("cantilever", {0, 0}, {50, 5}, 100, 10);
  body.material = {2.1e4, 0.29, PlaneState::Stress, 1};
  body.supports = {fixed("left")};
  body.loads.edges = {{"top", 3.6, {}}};
  return condensed(scene, half_plane({0, -1}, {0, 1}));
}

// The block of chapter 1 again, above another one, twice as stiff, whose top is as round as that obstacle: nodes on sides.
ContactProblem two_blocks() {
  Scene scene;
  scene.bodies.resize(2);
  Body& upper = scene.bodies[0];
  upper.mesh = block("upper", {-20, 0}, {40, 20}, 80, 40);
  upper.material = {10, 0.3, PlaneState::Strain, 1};
  upper.supports = {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -1.0)};
  Body& lower = scene.bodies[1];
  lower.mesh = mapped(block("lower", {-20, -20}, {40, 20}, 80, 40),
                      [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
                        return {x.x(), x.y() - (1 + x.y() / 20) * x.x() * x.x() / 120};
                      });
  lower.material = {20, 0.3, PlaneState::Strain, 1};
  lower.supports = {fixed("bottom")};
  scene.contacts = {{{"bottom", "upper"}, Side{"top", "lower"}, "node_to_segment"}};
  Ledger ledger;
  return condense(build(scene, ledger), ledger).problem;
}

// 2. One step, or many that take one row at a time. The coupling is that of the scaled compliance.
double smallest_coupling(const Eigen::MatrixXd& G) {
  const Eigen::VectorXd root = G.diagonal().cwiseSqrt();
  return G.cwiseQuotient(root * root.transpose()).minCoeff();
}

std::vector<std::string> row_of(const char* name, const ContactProblem& problem) {
  const QuasiActiveRun all = run_quasi_active_set_literal(problem);
  const QuasiActiveRun one = run_quasi_active_set_literal(problem, {}, Rows::MostViolated);
  return {name,
          std::to_string(problem.free_gap.size()),
          std::to_string(all.state.report.history.front().changes),
          std::to_string(all.state.active().size()),
          std::to_string(all.outer_steps),
          to_string(all.state.report.status),
          number(smallest_coupling(problem.compliance), "%.1e"),
          std::to_string(one.outer_steps),
          to_string(one.state.report.status)};
}

// 3. How often a run went along the six arrows of figure 4.1, in the order of fig_4_1.gp.
std::array<double, 6> arrows(const QuasiActiveRun& way) {
  const double k = static_cast<double>(way.outer_steps);
  const double left = way.left_over.empty() ? 0 : 1;
  return {1, k, k, 1, 1 - left, left};
}

SolveStatus chapter(const ProgramOptions& run) {
  Table table({"body", "pairs", "overlapping at u⁰", "closed", "k", "status", "smallest coupling",
               "k, one row at a time", "its status"});
  const ContactProblem on_obstacle = block_on_obstacle();
  table.row(row_of("block, chapter 1", on_obstacle));
  table.row(row_of("cantilever, chapter 6", cantilever()));
  table.row(row_of("half-plane, round punch", half_plane_indentation(200).problem));
  table.row(row_of("two elastic blocks", two_blocks()));
  write_file(run.out / "bodies.md", table.markdown());
  std::cout << table.markdown();

  const auto walls = arrows(run_quasi_active_set_literal(ch04::condensed(four_walls)));
  const auto rows =
      arrows(run_quasi_active_set_literal(ch04::condensed(fan), {}, Rows::IndependentByIndex));
  const auto bodies = arrows(run_quasi_active_set_literal(on_obstacle));
  Table chart({"arrow", "walls", "rows", "block"});
  for (std::size_t i = 0; i < 6; ++i)
    chart.row({static_cast<double>(i + 1), walls.at(i), rows.at(i), bodies.at(i)});
  write_file(run.out / "fig_4_1.csv", chart.csv());
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch04_bodies", "Bodies", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
