// Chapter 10 - How well the bodies feel the pressures of a gap operator: the constant of the inf-sup condition.
// Run:  make ch10     Reads: nothing     Writes: ch10_inf_sup.results, inf_sup.md
#include <cmath>
#include <iostream>

#include "interfaces.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch10;
using Eigen::Index;

// 1. The least work b(q, v) of pressures q on the displacements v that answer best, over |q| |v|. |v|^2 is twice the energy
//    of v, and |q|^2 = h/E times the sum of weight q^2, with h an edge of the source. With G the compliance of the pairs and
//    W their weights, the best v makes b^2 / |v|^2 = q^T W G W q.
double inf_sup(Index source_edges, Index target_edges, const Sampling& by) {
  Scene scene = blocks(source_edges, target_edges, by);
  scene.bodies[0].supports = {fixed("top")};
  scene.bodies[0].loads.edges.clear();
  scene.bodies[1].supports = {fixed("bottom")};
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  const Eigen::VectorXd root = model.pairs.weight.cwiseSqrt();
  const Eigen::MatrixXd felt = root.asDiagonal() * condensed.problem.compliance * root.asDiagonal();
  const double h = 2 / static_cast<double>(source_edges),
               E = scene.bodies[0].material.youngs_modulus;
  const double least = singular_values(felt).values.minCoeff();
  return std::sqrt(least * E / h);
}

struct Operator {
  const char* name;
  const char* key;
  Sampling by;
};

// 2. Two rows of meshes, each refined twice.
void operators(const ProgramOptions& run, Results& results) {
  Table table({"pressures", "8/8", "16/16", "8/11", "16/22", "32/44", "7/15", "14/30", "28/60"});
  const std::vector<Operator> all = {
      {"mortar, one a node", "mortar", {"mortar", 0, Quadrature::Segments}},
      {"nodes to segments", "nodes", {"node_to_segment", 0}},
      {"one Gauss point an edge", "one", {"gauss_points", 1}},
      {"two", "two", {"gauss_points", 2}},
      {"three", "three", {"gauss_points", 3}}};
  for (const Operator& with : all) {
    std::vector<std::string> row = {with.name};
    for (const auto& [source, target] :
         {std::pair(8, 8), std::pair(16, 16), std::pair(8, 11), std::pair(16, 22),
          std::pair(32, 44), std::pair(7, 15), std::pair(14, 30), std::pair(28, 60)}) {
      const double beta = inf_sup(source, target, with.by);
      row.push_back(beta < 1e-6 ? "0" : number(beta, "%.2g"));
      if (beta > 1e-6 && target % 11 == 0) results.add(text(with.key, "_", source), beta, "-");
    }
    table.row(row);
  }
  std::cout << table.markdown();
  write_file(run.out / "inf_sup.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch10_inf_sup");
  operators(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch10_inf_sup", "The inf-sup condition", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
