// Chapter 21 - Figure 21.1: in which order the unknowns of a body are eliminated, and what the rows of A meet on their way.
// Run:  make ch21     Reads: nothing     Writes: fig_21_1.csv, fig_21_1_tree.csv
#include <algorithm>
#include <iostream>
#include <vector>

#include "addons/frontal/separator_tree.hpp"
#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/bodies.hpp"

namespace {

using namespace ch21;

/// What the picture shows of every separator of a tree.
struct DrawnTree {
  SeparatorTree tree;
  std::vector<int> above;     // number of the separator above, -1 for the root
  std::vector<int> level;     // 0 for the root
  std::vector<bool> visited;  // whether a row of A has an entry in it or below
};

DrawnTree drawn_tree(const Model& model) {
  DrawnTree drawn{separator_tree(model.programme.stiffness, unknown_positions(model)), {}, {}, {}};
  const auto& separators = drawn.tree.separators;
  drawn.above.assign(separators.size(), -1);
  drawn.level.assign(separators.size(), 0);
  drawn.visited.assign(separators.size(), false);
  std::vector<bool> in_a_row(drawn.tree.order.size(), false);
  for (Eigen::Index row = 0; row < model.programme.A.rows(); ++row)
    for (NodalRows::InnerIterator entry(model.programme.A, row); entry; ++entry)
      in_a_row[static_cast<std::size_t>(entry.col())] = true;
  for (std::size_t s = 0; s < separators.size(); ++s) {  // what is below comes before
    for (int k = separators[s].first; k < separators[s].first + separators[s].own; ++k)
      if (in_a_row[static_cast<std::size_t>(drawn.tree.order[static_cast<std::size_t>(k)])])
        drawn.visited[s] = true;
    for (const int below : separators[s].below) {
      if (below < 0) continue;
      drawn.above[static_cast<std::size_t>(below)] = static_cast<int>(s);
      if (drawn.visited[static_cast<std::size_t>(below)]) drawn.visited[s] = true;
    }
  }
  for (std::size_t s = separators.size(); s-- > 0;)
    if (drawn.above[s] >= 0)
      drawn.level[s] = drawn.level[static_cast<std::size_t>(drawn.above[s])] + 1;
  return drawn;
}

/// Where the unknowns of every separator are.
Table drawn_nodes(const DrawnTree& drawn, const Model& model) {
  Table table({"x", "y", "level", "visited"});
  const auto positions = unknown_positions(model);
  for (std::size_t s = 0; s < drawn.level.size(); ++s) {
    const Separator& own = drawn.tree.separators[s];
    const bool part = own.below[0] < 0;  // too small to be cut: no separator
    for (int k = own.first; k < own.first + own.own; ++k) {
      const Eigen::Index unknown = drawn.tree.order[static_cast<std::size_t>(k)];
      table.row({positions(unknown, 0), positions(unknown, 1),
                 part ? -1.0 : static_cast<double>(drawn.level[s]), drawn.visited[s] ? 1.0 : 0.0});
    }
  }
  return table;
}

/// The tree itself: every separator in the middle over what it parts, with a line to the one above.
Table drawn_branches(const DrawnTree& drawn) {
  const std::size_t count = drawn.level.size();
  std::vector<double> place(count);
  double next = 0;
  for (std::size_t s = 0; s < count; ++s) {
    const auto& below = drawn.tree.separators[s].below;
    place[s] = below[0] < 0 ? next++
                            : 0.5 * (place[static_cast<std::size_t>(below[0])] +
                                     place[static_cast<std::size_t>(below[1])]);
  }
  Table table({"place", "level", "to_place", "to_level", "visited"});
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t to = drawn.above[s] < 0 ? s : static_cast<std::size_t>(drawn.above[s]);
    table.row({place[s], static_cast<double>(drawn.level[s]), place[to],
               static_cast<double>(drawn.level[to]), drawn.visited[s] ? 1.0 : 0.0});
  }
  return table;
}

SolveStatus chapter(const ProgramOptions& run) {
  const Model body = built(square(24));
  const DrawnTree tree = drawn_tree(body);
  std::cout << tree.level.size() << " fronts, "
            << std::count(tree.visited.begin(), tree.visited.end(), true)
            << " of them on the way of a row of A\n";
  write_file(run.out / "fig_21_1.csv", drawn_nodes(tree, body).csv());
  write_file(run.out / "fig_21_1_tree.csv", drawn_branches(tree).csv());
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch21_elimination", "Elimination", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
