// Live figure of chapter 4: which pairs the printed and the repaired method take in and drop, step by step.
#include "../stages.hpp"
#include "live/figure.hpp"

namespace live {
namespace {

using namespace ch04;
using Eigen::Vector2d;

const exact::Programme* small[] = {&corner, &fan, &four_walls};

ContactProblem pairs_problem(const Request& now) {
  const Index k = now.whole("problem");
  if (k < 3) return condensed(*small[k]);
  if (k == 5) return half_plane_indentation(200).problem;
  const Index n = k == 3 ? 10 : 50;
  const auto seed = static_cast<std::uint64_t>(now.whole("seed"));
  return condense(rosen_suzuki(n, n, seed).programme).problem;
}

Way walk(const Request& now) {
  if (now.chosen("method") == "repaired") return repaired_way(pairs_problem(now));
  return printed_way(pairs_problem(now),
                     choices[static_cast<std::size_t>(now.whole("method"))].rows);
}

// Each of the last twelve steps is a column of marks, one for each pair that overlapped before it. Steps are counted back
// from the one shown, so that the axes stay.
Panel chart(const Way& way, std::size_t last) {
  const auto here = static_cast<double>(last), pairs = static_cast<double>(way.best.size());
  Panel panel{"Which pairs a step takes", "steps after the one shown", "pair"};
  panel.window = {-11.6, 0.6, 0.4, pairs + 0.6};
  panel.whole_x = panel.whole_y = true;
  const char* labels[] = {"taken and pressed", "taken, not pressed", "overlaps, not taken"};
  const Look looks[] = {Look::Closed, Look::Cross, Look::Open};
  panel.curve("here", Look::Dotted, Vector2d(0, 0), Vector2d(0, pairs + 1));
  for (int kind = 0; kind < 3; ++kind) {
    std::vector<double> x, y;
    for (std::size_t k = last > 12 ? last - 11 : 1; k <= last; ++k) {
      const auto in = [](const Rows& rows, Index i) {
        return std::find(rows.begin(), rows.end(), i) != rows.end();
      };
      const Stage& now = way.stages[k];
      const Rows bad = violated_pairs(way.problem, way.stages[k - 1].force);
      for (Index i = 0; i < way.best.size(); ++i) {
        const bool is[] = {in(now.pressed, i), in(now.taken, i), in(bad, i)};
        if (std::find(is, is + 3, true) != is + kind) continue;
        x.push_back(static_cast<double>(k) - here);
        y.push_back(static_cast<double>(i + 1));
      }
    }
    const auto n = static_cast<Index>(x.size());
    if (n > 0)
      panel.curve(labels[kind], looks[kind], VectorXd::Map(x.data(), n),
                  VectorXd::Map(y.data(), n));
  }
  return panel;
}

// Two unknowns: the minimum moves between the rows, which all go through the origin.
Panel plane(const exact::Programme& q, const Way& way, std::size_t last) {
  Panel panel{"The moved minimum", "u\u2081", "u\u2082", true};
  panel.window = {-0.5, 1.3, -0.5, 2.1};
  for (std::size_t i = 0; i < q.A.size(); ++i) {
    const VectorXd a = 3 * floating(q.A[i]);
    panel.curve(i == 0 ? "rows" : "", Look::Dotted, Vector2d(-a(1), a(1)), Vector2d(a(0), -a(0)));
  }
  MatrixXd u(2, last + 1);
  for (std::size_t k = 0; k <= last; ++k)
    u.col(static_cast<Index>(k)) = displacement(q, way.stages[k].force);
  const VectorXd best = displacement(q, way.best);
  panel.curve("solution", Look::Cross, best.head(1), best.tail(1));
  panel.curve("", Look::Line, u.row(0), u.row(1));
  panel.curve("steps", Look::Closed, u.row(0), u.row(1));
  panel.curve("here", Look::Here, u.row(0).tail(1), u.row(1).tail(1));
  return panel;
}

Answer group_by_group(const Request& now) {
  const Way& way = kept(now.key({"step"}), [&now] { return walk(now); });
  const std::size_t end = way.stages.size() - 1;
  const std::size_t step = std::min(static_cast<std::size_t>(now.whole("step")), end);
  const Stage& stage = way.stages[step];
  const VectorXd pair =
      VectorXd::LinSpaced(way.best.size(), 1, static_cast<double>(way.best.size()));
  Panel forces{"Forces of all steps together", "pair", "force"};
  double strongest = way.best.maxCoeff();
  for (const Stage& then : way.stages) strongest = std::max(strongest, then.force.maxCoeff());
  forces.window = {0, static_cast<double>(way.best.size()) + 1, 0, 1.05 * strongest};
  forces.whole_x = true;
  forces.curve("solution", Look::Cross, pair, way.best);
  forces.points("pairs", pair, stage.force, stage.force, "pressed", "not pressed");

  Answer answer;
  answer.says = words_for(way, step);
  answer.number("rounds", "steps of the loop", static_cast<double>(way.rounds), "", "%.0f");
  if (const double left = overlap_left(way, stage); left > 0) {
    answer.number("overlap", "largest overlap", left);
  } else {
    answer.number("above", "energy above the solution", energy_above(way, stage));
    answer.number("bound", "its bound", stage.force.dot(stage.gap));
    answer.numbers.back().varies = way.optimal;  // then it is rounding
  }
  answer.sets = {{"taken", stage.taken}, {"pressed", stage.pressed}};
  const Index k = now.whole("problem");
  answer.panels = {chart(way, step), k < 2 ? plane(*small[k], way, step) : forces};
  return answer;
}

}  // namespace

Figure groups() {
  return {"groups",
          "Groups of pairs, step by step",
          {with_own_axes(
               choice("problem", "problem", "corner",
                      {"corner", "fan", "four_walls", "random_10", "random_50", "half-plane"})),
           with_own_axes(
               choice("method", "rows of a step", "all_violated",
                      {"all_violated", "by_number", "by_overlap", "most_violated", "repaired"})),
           playing(slider("step", "step shown", 6, 0, 200, 1)),
           with_own_axes(slider("seed", "number of the random programme", 1, 1, 100, 1))},
          group_by_group};
}

}  // namespace live
