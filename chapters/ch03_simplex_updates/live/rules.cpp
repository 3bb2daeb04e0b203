// Live figure of chapter 3: six rules for the weights, step by step.
#include <algorithm>

#include "../three_problems.hpp"
#include "live/figure.hpp"
#include "papers/weight_iteration.hpp"

namespace live {
namespace {

using namespace ch03;

const Index most = 200;  // steps
const VectorXd step_numbers = VectorXd::LinSpaced(most + 1, 0, most);

// The problems of the chapter, or the three carts, of which the second overlaps more or less.
ContactProblem problem_of(const Request& now) {
  static const std::vector<Named> larger = three_problems();
  const auto which = static_cast<std::size_t>(now.whole("problem"));
  const MatrixXd G = (MatrixXd(3, 3) << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished();
  return which > 0 ? larger[which - 1].problem
                   : ContactProblem{G, Eigen::Vector3d(-2, -now["second"], -3)};
}

struct Climb {
  ContactProblem problem;
  VectorXd best;     // weights of the solution
  double height;     // s there
  MatrixXd missing;  // part of it, after each step of each rule
};

Climb climb(const ContactProblem& problem) {
  const VectorXd force = surrogate_dual(problem, WeightRule::FullyCorrective).force;
  Climb all{problem, force / force.sum(), -0.5 * force.dot(problem.free_gap), {}};
  all.missing.resize(step_numbers.size(), 6);
  for (Index r = 0; r < 6; ++r) {
    WeightIteration run(problem, rules[r].rule);
    for (Index k = 0; k < step_numbers.size(); ++k, (void)run.step())
      all.missing(k, r) = std::max(1e-12, 1 - run.value() / all.height);
  }
  return all;
}

Panel triangle(const Climb& top, const MatrixXd& path) {
  Panel panel{"The way up", "all weight on cart 1, or on cart 2", "above: all on cart 3"};
  const auto missing = [&top](const Eigen::Vector3d& xi) {
    return 1 - surrogate_dual_value(top.problem, xi) / top.height;
  };
  panel.triangle("missing part of the best s", missing, {0.02, 0.05, 0.1, 0.2},
                 "20, 10, 5, 2 % are missing", 1);
  MatrixXd place(2, path.cols());
  for (Index k = 0; k < path.cols(); ++k) place.col(k) = in_triangle(path.col(k));
  const Eigen::Vector2d best = in_triangle(top.best);
  panel.curve("best s", Look::Cross, best.head(1), best.tail(1));
  panel.curve("", Look::Line, place.row(0), place.row(1));
  panel.curve("steps", Look::Closed, place.row(0), place.row(1));
  panel.curve("here", Look::Here, place.row(0).tail(1), place.row(1).tail(1));
  return panel;
}

Answer step_by_step(const Request& now) {
  const Climb& top = kept(now.key({"rule", "steps"}), [&now] { return climb(problem_of(now)); });
  const Index rule = now.whole("rule");
  const VectorXd missed = top.missing.col(rule);
  WeightIteration run(top.problem, rules[rule].rule);
  MatrixXd path = run.weights();
  while (path.cols() <= now.whole("steps") && run.step()) {
    path.conservativeResize(Eigen::NoChange, path.cols() + 1);
    path.rightCols(1) = run.weights();
  }
  const Index steps = path.cols() - 1;
  const VectorXd& xi = run.weights();
  const VectorXd pair = VectorXd::LinSpaced(xi.size(), 1, static_cast<double>(xi.size()));
  Panel weights{"The weights", "pair", "weight"};
  const double pairs = static_cast<double>(xi.size()),
               widest = top.problem.free_gap.cwiseAbs().maxCoeff();
  weights.window = {0, pairs + 1, 0, 1.05};
  weights.whole_x = true;
  weights.curve("best", Look::Dashed, pair, top.best);
  weights.points("pairs", pair, xi, xi, "with weight", "without");
  Panel missing{"What is missing to the best s", "steps", "part of the best s"};
  missing.log_y = true;
  missing.window = {0, most, 5e-13, 1};
  for (Index r = 0; r < 6; ++r)
    missing.curve(r == 0 ? "all rules" : "", Look::Dotted, step_numbers, top.missing.col(r));
  missing.curve(rules[rule].name, Look::Line, step_numbers, missed);
  missing.curve("here", Look::Here, step_numbers.segment(steps, 1), missed.segment(steps, 1));
  for (Layer& layer : missing.layers) layer.varies = true;  // they end in rounding
  Panel overlaps{"Overlaps that are left", "pair", "overlap"};
  overlaps.window = {0, pairs + 1, -widest, widest};
  overlaps.whole_x = true;
  overlaps.clips = true;
  overlaps.curve("no gap", Look::Dotted, pair, 0 * pair);
  overlaps.points("pairs", pair, run.overlap(), xi, "with weight", "without");

  Answer answer;
  Index worst = 0;
  run.overlap().maxCoeff(&worst);
  answer.number("steps", "steps", step_numbers(steps), "", "%.0f");
  answer.number("missing", "missing to the best s", 100 * missed(steps), "%", "%.2g");
  const Index above = (missed.array() > 1e-8).count();
  if (above <= most)
    answer.number("to_8", "steps until 1e-8 is missing", step_numbers(above), "", "%.0f");
  answer.sets = {{"with_weight", {}}};
  for (Index i = 0; i < xi.size(); ++i)
    if (xi(i) > 0) answer.sets[0].members.push_back(i);
  answer.says = run.step() ? text("Pair ", worst + 1, " overlaps most: (28) points to its vertex.")
                : run.end() == WeightEnd::Repeats ? "The next vertex was met before: a circle."
                                                  : "No step raises s any more.";
  answer.panels = {xi.size() == 3 ? triangle(top, path) : weights, missing, overlaps};
  return answer;
}

}  // namespace

Figure rules() {
  return {"rules",
          "Six rules on their way to the best weights",
          {with_own_axes(choice(
               "problem", "problem", "three_carts",
               {"three_carts", "half-plane_200", "Rosen-Suzuki_50_50", "Rosen-Suzuki_20_80"})),
           choice("rule", "rule", "line_search",
                  {"literal", "2/(k+2)", "line_search", "away_steps", "pairwise", "corrective"}),
           playing(slider("steps", "steps", 6, 0, most, 1)),
           slider("second", "overlap of cart 2 [mm]", 2.2, 0, 3, 0.1)},
          step_by_step};
}

}  // namespace live
