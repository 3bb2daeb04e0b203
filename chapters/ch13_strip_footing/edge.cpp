// Chapter 13 - What a mesh shows of a pressure that is infinite at the edge.
// Run:  make ch13     Reads: nothing     Writes: ch13_edge.results, edge.md
#include <iostream>

#include "base.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch13;

/// Pressures that are linear between nodes and whose integrals with the shape functions are the forces.
// [standard]
VectorXd standard_pressure(const Base& base) {
  const Index n = base.position.size();
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
  for (Index k = 0; k + 1 < n; ++k) {
    const double h = base.position(k + 1) - base.position(k);
    mass.block<2, 2>(k, k) += h / 6 * (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
  }
  return CholeskyFactor(mass).solve(base.force);
}
// [standard]

// Halving every cell: the pressure of the corner has no limit, the deviation of its force has one.
void refine_the_edge(const ProgramOptions& run, Results& results) {
  Table table({"cells under", "nodes", "worst, x ≤ 0.8 a [%]", "corner force [%]", "corner",
               "next to it", "standard, corner", "standard, next to it"});
  for (const Index k : {1, 2, 4, 8}) {
    const EdgeBlockSpec soil = soil_of(8 * k, 10 * k, 9 * k, 4, 60);
    const Base base = rigid_base(soil);
    const Index n = base.force.size();
    const VectorXd dual = base.pressure() / q, standard = standard_pressure(base) / q;
    const double corner = base.deviation()(n - 1);
    table.row({std::to_string(8 * k), std::to_string(soil.n_nodes()), percent(base.worst()),
               percent(corner), number(dual(n - 1), "%.1f"), number(dual(n - 2), "%.1f"),
               number(standard(n - 1), "%.1f"), number(standard(n - 2), "%.2f")});
    results.add(text("edge_pressure_", k), dual(n - 1), "q");
    results.add(text("edge_force_", k), 100 * corner, "%");
    results.add(text("edge_worst_", k), 100 * base.worst(), "%");
  }
  std::cout << table.markdown();
  write_file(run.out / "edge.md", table.markdown());
}

// What one solution shows as stress at the edge: of nodes and of cells, in both bodies.
void edge_stress(const SolvedScene& run, Results& results) {
  const char* names[] = {"footing", "soil"};
  for (std::size_t k = 0; k < 2; ++k) {
    const BodyModel& body = run.model.bodies[k];
    const NodeArray& u = run.solution.displacements[k];
    Index corner = 0;
    (body.mesh.nodes.rowwise() - Eigen::RowVector2d(a, 0)).rowwise().norm().minCoeff(&corner);
    const double node = nodal_stress(body.mesh, body.element, body.material, u)(corner, 1);
    const double cell = cell_stress(body.mesh, body.element, body.material, u).col(1).minCoeff();
    results.add(text("edge_node_", names[k]), -node / q, "q");
    results.add(text("edge_cell_", names[k]), -cell / q, "q");
  }
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch13_edge");
  refine_the_edge(run, results);
  edge_stress(settle(coarse, {}), results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch13_edge", "The edge", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
