// Live figure of chapter 8: a complementarity function over force and gap, and Newton's path to its zeros.
#include "../functions.hpp"
#include "live/figure.hpp"

namespace live {
namespace {

using namespace signorini;
using Eigen::Vector2d;

const double least_force = -1.4, largest_force = 4.2;  // of the panels
const double least_gap = -1.6, largest_gap = 4.2;

// One pair: its gap is d + G force. The zeros of all functions are the same two half-axes.
struct Pair {
  double d, G;
  [[nodiscard]] double gap(double force) const { return d + G * force; }
  [[nodiscard]] double force() const { return std::max(0.0, -d / G); }  // of the solution
};

Panel map_of(const ComplementarityFunction& phi, const Pair& pair, const VectorXd& force) {
  Panel map{"The function, and the pair's line", "gap a [mm]", "force b [N]", true};
  map.window = {least_gap, largest_gap, least_force, largest_force};
  map.drag = {{"start", 0, 1}};
  const VectorXd x = VectorXd::LinSpaced(60, least_gap, largest_gap);
  const VectorXd y = VectorXd::LinSpaced(58, least_force, largest_force);
  const auto value = [&phi](double gap, double at_force) { return phi.value(gap, at_force); };
  map.map("value of the function", x, y, value, -6, 6);
  map.level_lines("level lines", Look::Dotted, x, y, value, {-3, -2, -1, -0.5, 0.5, 1, 2, 4});
  map.curve("zeros: open, or closed", Look::Line, Eigen::Vector3d(0, 0, largest_gap),
            Eigen::Vector3d(largest_force, 0, 0));
  const auto gap = [&pair](double at) { return pair.gap(at); };
  const Vector2d ends(least_force, largest_force);
  map.curve("gaps that forces leave", Look::Dashed, ends.unaryExpr(gap), ends);
  const VectorXd gaps = force.unaryExpr(gap);
  VectorXd way_gap(2 * force.size() - 2), way_force(way_gap.size());  // from each step to the next
  for (Index k = 0; 2 * k < way_gap.size(); ++k) {
    way_gap.segment<2>(2 * k) = gaps.segment<2>(k);
    way_force.segment<2>(2 * k) = force.segment<2>(k);
  }
  if (way_gap.size() > 0) map.curve("", Look::Arrow, way_gap, way_force);
  map.curve("Newton's steps", Look::Closed, gaps, force);
  map.curve("start", Look::Here, gaps.head(1), force.head(1));
  return map;
}

// Along the pair's line: each step goes down the tangent to zero, and from there to the function again.
Panel tangents(const ComplementarityFunction& phi, const Pair& pair, const VectorXd& force) {
  Panel along{"Along the pair's line", "force [N]", "value of the function"};
  const VectorXd fine = VectorXd::LinSpaced(281, least_force, largest_force);
  const auto value = [&](double at) { return phi.value(pair.gap(at), at); };
  along.window = {least_force, largest_force, -6, 6};
  along.clips = true;
  along.curve("the function", Look::Line, fine, fine.unaryExpr(value));
  along.curve("", Look::Dotted, Vector2d(least_force, largest_force), Vector2d(0, 0));
  VectorXd x(2 * force.size() - 1);
  VectorXd y = VectorXd::Zero(x.size());
  for (Index k = 0; k < force.size(); ++k) {
    x(2 * k) = force(k);
    y(2 * k) = value(force(k));
    if (k > 0) x(2 * k - 1) = force(k);
  }
  along.curve("tangents", Look::Dashed, x, y);
  along.curve("start", Look::Here, x.head(1), y.head(1));
  return along;
}

Answer go(const Request& now) {
  const ComplementarityFunction& phi = functions[static_cast<std::size_t>(now.whole("function"))];
  const Pair pair{now["free_gap"], now["compliance"]};
  const ContactProblem problem{MatrixXd::Constant(1, 1, pair.G), VectorXd::Constant(1, pair.d)};
  const NewtonRun run =
      signorini::newton(problem, phi, VectorXd::Constant(1, now["start"]), {1e-10, 0});
  const Index steps = static_cast<Index>(run.steps());
  VectorXd force(steps + 1);
  for (Index k = 0; k <= steps; ++k) force(k) = run.forces[static_cast<std::size_t>(k)](0);
  const Index shown = std::min(now.whole("shown"), steps);

  Panel digits{"How fast", "steps", "residual, and error of the force"};
  digits.log_y = true;
  const VectorXd count = VectorXd::LinSpaced(steps + 1, 0, static_cast<double>(steps));
  digits.window = {-0.3, 20.3, 5e-18, 100};
  digits.whole_x = true;
  const VectorXd error = (force.array() - pair.force()).abs().max(1e-17);  // 0 has no logarithm
  digits.curve("residual", Look::Closed, count,
               VectorXd::Map(run.residuals.data(), steps + 1).cwiseMax(1e-17));
  digits.curve("error of the force [N]", Look::Cross, count, error);
  for (Layer& layer : digits.layers) layer.varies = true;  // they end in rounding
  digits.curve("enough", Look::Dotted, Vector2d(0, 20), Vector2d(1e-10, 1e-10));

  Answer answer;
  answer.says = !run.ended   ? "60 steps are not enough."
                : pair.d < 0 ? "The residual is small enough: the pair is closed and presses."
                : pair.d > 0 ? "The residual is small enough: the pair is open."
                             : "The residual is small enough: the pair touches without force.";
  answer.number("steps", "steps", static_cast<double>(steps), "", "%.0f");
  answer.number("force", "force after the steps shown", force(shown), "N", "%.6g");
  answer.rounding("residual", "residual at the end", run.residuals.back());
  answer.rounding("error", "error of the force at the end", error(steps), "N");
  answer.sets = {{"presses", {}}};
  if (force(steps) > 1e-4) answer.sets[0].members = {0};
  const VectorXd path = force.head(shown + 1);
  answer.panels = {map_of(phi, pair, path), tangents(phi, pair, path), digits};
  return answer;
}

}  // namespace

Figure newton() {
  return {"newton",
          "Newton's path over a complementarity function",
          {choice("function", "function", "Fischer-Burmeister",
                  {"Fischer-Burmeister", "minimum", "between", "penalised", "smooth"}),
           slider("start", "force at the start [N]", 4, -1.4, 4, 0.05),
           slider("free_gap", "gap without force d [mm]", -1, -1.5, 1, 0.05),
           slider("compliance", "compliance G [mm/N]", 1, 0.25, 2, 0.05),
           playing(slider("shown", "steps shown", 20, 0, 20, 1))},
          go};
}

}  // namespace live
