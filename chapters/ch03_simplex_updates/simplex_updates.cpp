// Chapter 3 - Updating xi on the simplex (Xuan & Li 2002, sec. 2.2, eqs. 25-29): two pairs.
// Run:  make ch03     Reads: nothing     Writes: ch03.results, hops.md, fig_3_1.csv
#include <iostream>

#include "papers/weight_iteration.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

// 1. One update of the weights, by line search.
// [update]
VectorXd update(const ContactProblem& problem, const VectorXd& xi) {
  const VectorXd slope = surrogate_dual_gradient(problem, xi);  // eta (A u - g)
  Index vertex = 0;
  slope.maxCoeff(&vertex);  // (28): all weight to the pair that overlaps most
  const VectorXd delta = VectorXd::Unit(xi.size(), vertex) - xi;
  const VectorXd moved = problem.compliance * delta;                              // G delta
  const WeightLine line{-problem.free_gap.dot(xi), -problem.free_gap.dot(delta),  // b0, b1
                        xi.dot(problem.compliance * xi), xi.dot(moved), delta.dot(moved)};
  return xi + best_step(line, 1) * delta;  // t* of the way
}
// [update]

// 2. Two pairs: G = (2 1; 1 2), b = (7, 5), forces (3, 1), s = 13 at the weight 3/4.
double hops(const ContactProblem& problem, const ProgramOptions& run) {
  WeightIteration literal(problem, WeightRule::LiteralVertex);
  WeightIteration harmonic(problem, WeightRule::Harmonic);
  VectorXd xi = start_weights(problem);  // (29)
  Table table({"iteration", "literal", "$`s`$", "2/(k+2)", "$`s`$", "line search", "$`s`$"});
  for (int k = 0; k <= 5; ++k) {
    const bool back = literal.end() == WeightEnd::Repeats;
    table.row({std::to_string(k), back ? "back at 1" : number(literal.weights()(0), "%.3f"),
               back ? "" : number(literal.value(), "%.3f"), number(harmonic.weights()(0), "%.3f"),
               number(harmonic.value(), "%.3f"), number(xi(0), "%.3f"),
               number(surrogate_dual_value(problem, xi), "%.3f")});
    (void)literal.step();
    (void)harmonic.step();
    xi = update(problem, xi);
  }
  write_file(run.out / "hops.md", table.markdown());
  std::cout << table.markdown();
  return surrogate_dual_value(problem, xi);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch03");
  const Eigen::Matrix2d G = (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
  const ContactProblem problem{G, Vector2d(-7, -5)};
  results.add("two_pairs_s", hops(problem, run), "-");
  Table curve({"weight", "s"});
  for (int step = 0; step <= 100; ++step) {
    const double xi = step / 100.0;
    curve.row({xi, surrogate_dual_value(problem, Vector2d(xi, 1 - xi))});
  }
  write_file(run.out / "fig_3_1.csv", curve.csv());
  results.headline("two_pairs_s", 13, "closed form of two pairs");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch03", "Updating xi on the simplex", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
