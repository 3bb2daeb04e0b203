// Chapter 3 - Updating xi on the simplex (Xuan & Li 2002, sec. 2.2, eqs. 25-29).
// Run:  make ch03     Reads: nothing     Writes: ch03.results, hops.md, counts.md, solvers.md,
//                                                fig_3_1.csv, fig_3_2.csv
#include <algorithm>
#include <cmath>

#include "signorini/as_printed/weight_iteration.hpp"
#include "signorini/closing/closing.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/examples.hpp"
#include "signorini/programme/dense_programme.hpp"
#include "signorini/report/program.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

struct Rule {
  const char* name;
  WeightRule rule;
};
const Rule rules[] = {
    {"literal (28)", WeightRule::LiteralVertex}, {"2/(k+2)", WeightRule::Harmonic},
    {"line search", WeightRule::LineSearch},     {"away steps", WeightRule::AwaySteps},
    {"pairwise", WeightRule::Pairwise},          {"fully corrective", WeightRule::FullyCorrective}};

// 1. Three problems, rows scaled to a unit diagonal of G as in every solver. The punch stands a little
//    to the right of the middle, so that no two pairs are alike and rounding decides nothing.
// [problems]
struct Named {
  std::string name;
  ContactProblem problem;
};

std::vector<Named> three_problems() {
  Indentation punch = half_plane_indentation(200);
  punch.problem.free_gap -= 0.05 * punch.position;
  std::vector<Named> list = {
      {"Rosen-Suzuki 50, 50", condense(rosen_suzuki(50, 50, 1).programme).problem},
      {"Rosen-Suzuki 20, 80", condense(rosen_suzuki(20, 80, 1).programme).problem},
      {"half-plane, 200", punch.problem}};
  for (Named& named : list) {
    const ScaledProblem scaled = equilibrate(named.problem);
    named.problem = {scaled.compliance, scaled.free};
  }
  return list;
}
// [problems]

VectorXd random_weights(Random& random, Index n) {  // far from the middle, most of them small
  VectorXd weights(n);
  for (double& weight : weights) weight = std::pow(random.uniform(0, 1), 8);
  return weights / weights.sum();
}

// 2. The linear programme (28): no weights gain more than the vertex of the most violated pair.
// [programme]
void linear_programme(const ContactProblem& problem, Results& results) {
  Random random(1);
  const VectorXd slope = surrogate_dual_gradient(problem, start_weights(problem));  // (25), (29)
  Index vertex = 0;
  const double best = slope.maxCoeff(&vertex);
  int better = 0;
  for (int sample = 0; sample < 1000; ++sample)
    better += random_weights(random, slope.size()).dot(slope) > best ? 1 : 0;
  // [programme]
  results.add("better_than_vertex", better, "-");
  results.add("violated_by_u0", static_cast<double>((problem.free_gap.array() < 0).count()), "-");
}

// 3. Two pairs: G = (2 1; 1 2), b = (7, 5), forces (3, 1), s = 13 at the weight 3/4.
// [hops]
void two_pairs(const ProgramOptions& run, Results& results) {
  const Eigen::Matrix2d G = (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
  const ContactProblem problem{G, Vector2d(-7, -5)};
  WeightIteration literal(problem, WeightRule::LiteralVertex);
  WeightIteration harmonic(problem, WeightRule::Harmonic);
  WeightIteration search(problem, WeightRule::LineSearch);
  Table table({"iteration", "literal", "$`s`$", "2/(k+2)", "$`s`$", "line search", "$`s`$"});
  for (int k = 0; k <= 5; ++k) {
    const bool back = literal.end() == WeightEnd::Repeats;
    table.row({std::to_string(k), back ? "back at 1" : number(literal.weights()(0), "%.3f"),
               back ? "" : number(literal.value(), "%.3f"), number(harmonic.weights()(0), "%.3f"),
               number(harmonic.value(), "%.3f"), number(search.weights()(0), "%.3f"),
               number(search.value(), "%.3f")});
    for (WeightIteration* iteration : {&literal, &harmonic, &search}) (void)iteration->step();
  }
  // [hops]
  write_file(run.out / "hops.md", table.markdown());
  Table curve({"weight", "s"});
  for (int step = 0; step <= 100; ++step) {
    const double xi = step / 100.0;
    curve.row({xi, surrogate_dual_value(problem, Vector2d(xi, 1 - xi))});
  }
  write_file(run.out / "fig_3_2.csv", curve.csv());
  results.add("two_pairs_s", search.value(), "-");
}

// 4. s is not concave, but wherever it does not rise to first order it does not rise at all.
// [concave]
void pseudo_concavity(const ContactProblem& problem, Results& results) {
  Random random(2);
  int pairs = 0;
  int not_concave = 0;
  int not_pseudo_concave = 0;
  double lost = 0;  // by the closed-form step, against the best of 1000 steps tried
  for (int sample = 0; sample < 500; ++sample) {
    const VectorXd xi = random_weights(random, problem.free_gap.size());
    const VectorXd zeta = random_weights(random, problem.free_gap.size());
    const double s = surrogate_dual_value(problem, xi);
    const double other = surrogate_dual_value(problem, zeta);
    pairs += s > 0 && other > 0 ? 1 : 0;
    if (s == 0 || other == 0) continue;
    const double middle = surrogate_dual_value(problem, 0.5 * (xi + zeta));
    not_concave += middle < 0.5 * (s + other) ? 1 : 0;
    const VectorXd delta = zeta - xi;
    const double slope = surrogate_dual_gradient(problem, xi).dot(delta);
    not_pseudo_concave += slope <= 0 && other > s * (1 + 1e-12) ? 1 : 0;
    const VectorXd product = problem.compliance * delta;
    const double step =
        best_step({-problem.free_gap.dot(xi), -problem.free_gap.dot(delta),
                   xi.dot(problem.compliance * xi), xi.dot(product), delta.dot(product)},
                  1);
    const double found = surrogate_dual_value(problem, xi + step * delta);
    for (int k = 0; k <= 1000; ++k)
      lost = std::max(lost, surrogate_dual_value(problem, xi + k / 1000.0 * delta) / found - 1);
  }
  // [concave]
  results.add("pairs_of_weights", pairs, "-");
  results.add("not_concave", not_concave, "-");
  results.add("not_pseudo_concave", not_pseudo_concave, "-");
  if (lost > 1e-12) throw NotSolved("the closed-form step is not the best one");
  results.add("lost_by_step", lost, "-", Repeats::No);
}

// 5. Iterations until s* - s <= tolerance s*, and the curves of figure 3.1.
// [counts]
std::vector<std::string> counts(const ContactProblem& problem, double best, WeightRule rule) {
  WeightIteration run(problem, rule);
  std::vector<std::string> cells;
  int k = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    while (best - run.value() > tolerance * best && k < 20000 && run.step()) ++k;
    cells.push_back(best - run.value() <= tolerance * best ? std::to_string(k) : "–");
  }
  return cells;
}
// [counts]

double best_value(const ContactProblem& problem) {
  const ContactState exact = surrogate_dual(problem, WeightRule::FullyCorrective);
  if (exact.report.status != Status::Solved || !certify(problem, exact).holds())
    throw NotSolved("the reference is not solved");
  return -0.5 * exact.force.dot(problem.free_gap);
}

void compare_rules(const ProgramOptions& run, const std::vector<Named>& problems,
                   Results& results) {
  Table table({"problem", "rule", "1e-2", "1e-4", "1e-6", "1e-8"});
  for (const auto& [name, problem] : problems) {
    const double best = best_value(problem);
    for (const Rule& rule : rules) {
      std::vector<std::string> row = {name, rule.name};
      for (const std::string& cell : counts(problem, best, rule.rule)) row.push_back(cell);
      table.row(row);
      if (rule.rule == WeightRule::FullyCorrective)
        results.add(text("corrective_", problem.free_gap.size()), std::stod(row.back()), "-");
    }
  }
  write_file(run.out / "counts.md", table.markdown());
  const ContactProblem& punch = problems.back().problem;
  const double best = best_value(punch);
  Table curve({"iteration", "gap"});
  for (const Rule& rule : rules) {
    WeightIteration iteration(punch, rule.rule);
    double next = 1;
    for (int k = 0; k <= 20000; ++k) {
      const double gap = std::max(1e-12, 1 - iteration.value() / best);
      if (k >= next || gap <= 1e-9) {
        curve.row({static_cast<double>(k), gap});
        next = std::max(k + 1.0, 1.15 * k);
      }
      if (!iteration.step() || gap <= 1e-9) break;
    }
    curve.blank_line();
  }
  write_file(run.out / "fig_3_1.csv", curve.csv("rel 1e-3 abs 1e-10"));
}

// 6. The same rules as solvers: a guess of the closed pairs is confirmed exactly, or dropped.
// [solvers]
void as_solvers(const ProgramOptions& run, const std::vector<Named>& problems) {
  Table table({"problem", "rule", "ends as", "iterations", "factorisations", "closed"});
  for (const auto& [name, problem] : problems)
    for (const Rule& rule : rules) {
      const ContactState state = surrogate_dual(problem, rule.rule);
      const bool solved = state.report.status == Status::Solved;
      if (solved && !certify(problem, state).holds()) throw NotSolved("a certificate fails");
      table.row({name, rule.name, to_string(state.report.status),
                 std::to_string(state.report.iterations),
                 std::to_string(state.report.factorisations),
                 solved ? std::to_string(state.active.size()) : "–"});
    }
  // [solvers]
  write_file(run.out / "solvers.md", table.markdown());
}

Status chapter(const ProgramOptions& run) {
  Results results("ch03");
  const std::vector<Named> problems = three_problems();
  linear_programme(problems.back().problem, results);
  two_pairs(run, results);
  pseudo_concavity(problems.front().problem, results);
  compare_rules(run, problems, results);
  as_solvers(run, problems);
  results.headline("two_pairs_s", 13, "closed form of two pairs");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch03", "Updating xi on the simplex", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
