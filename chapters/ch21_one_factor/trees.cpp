// Chapter 21 - The trees that a factor climbs, drawn.
// Run:  make ch21     Reads: nothing     Writes: ch21_trees.results, fig_21_2.csv, fig_21_3.csv
#include <algorithm>

#include "elimination_tree.hpp"
#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/bodies.hpp"

namespace {

using namespace ch21;

// 1. The trees of three orders, of a small cantilever: a column of L stands over its place in the beam, at its depth.
void draw_trees(const ProgramOptions& run) {
  const Model model = built(cantilever(4));
  const Sparse& K = model.programme.stiffness;
  const Positions positions = unknown_positions(model);
  Table table({"tree", "x", "depth", "parent_x", "parent_depth"});
  int number_of = 0;
  for (const Order& order : {contact_last(K, model.programme.A), minimum_degree(K),
                             separator_tree(K, positions).order}) {
    const EliminationTree tree = elimination_tree(K, order);
    const auto x = [&](int k) { return positions(order[static_cast<std::size_t>(k)], 0); };
    for (int k = 0; k < static_cast<int>(order.size()); ++k) {
      const int up = tree.parent[static_cast<std::size_t>(k)] < 0
                         ? k
                         : tree.parent[static_cast<std::size_t>(k)];
      table.row({static_cast<double>(number_of), x(k),
                 static_cast<double>(tree.depth[static_cast<std::size_t>(k)]), x(up),
                 static_cast<double>(tree.depth[static_cast<std::size_t>(up)])});
    }
    table.blank_line();
    ++number_of;
  }
  write_file(run.out / "fig_21_3.csv", table.csv());
}

// 2. The separators of the cantilever, and which of them the rows of its contacts come through.
void draw_paths(const ProgramOptions& run, Results& results) {
  const Model model = built(cantilever(8));
  const Sparse& K = model.programme.stiffness;
  const Positions positions = unknown_positions(model);
  const Fronts fronts = fronts_of(K, separator_tree(K, positions));
  const RowPaths paths = row_paths(fronts, model.programme.A);
  std::vector<int> above(fronts.all.size(), -1), depth(fronts.all.size(), 0);
  std::vector<double> x(fronts.all.size(), 0);
  for (std::size_t f = fronts.all.size(); f-- > 0;) {
    const Front& front = fronts.all[f];
    for (const int below : front.separator.below) {
      if (below < 0) continue;
      above[static_cast<std::size_t>(below)] = static_cast<int>(f);
      depth[static_cast<std::size_t>(below)] = depth[f] + 1;
    }
    for (int k = 0; k < front.separator.own; ++k)
      x[f] += positions(fronts.order[static_cast<std::size_t>(front.separator.first + k)], 0) /
              front.separator.own;
  }
  Table table({"x", "depth", "above_x", "above_depth", "own", "rows", "one"});
  const int one = static_cast<int>(model.programme.A.rows() / 3);  // the row of one contact
  int on_path = 0, all_rows = 0;
  for (std::size_t f = 0; f < fronts.all.size(); ++f) {
    const std::size_t up = above[f] < 0 ? f : static_cast<std::size_t>(above[f]);
    const bool passes = std::binary_search(paths.rows[f].begin(), paths.rows[f].end(), one);
    on_path += passes ? 1 : 0;
    all_rows += static_cast<int>(paths.rows[f].size());
    table.row({x[f], static_cast<double>(depth[f]), x[up], static_cast<double>(depth[up]),
               static_cast<double>(fronts.all[f].own()), static_cast<double>(paths.rows[f].size()),
               passes ? 1.0 : 0.0});
  }
  write_file(run.out / "fig_21_2.csv", table.csv());
  results.add("fronts", static_cast<double>(fronts.all.size()), "-");
  results.add("fronts_of_one_row", on_path, "-");
  results.add("rows", static_cast<double>(model.programme.A.rows()), "-");
  results.add("fronts_of_a_row", all_rows / static_cast<double>(model.programme.A.rows()), "-");
  results.add("carrying", paths.operations / fronts.operations(), "-");
  results.add("column_by_column",
              fronts.solve_operations() * static_cast<double>(model.programme.A.rows()) /
                  fronts.operations(),
              "-");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch21_trees");
  draw_trees(run);
  draw_paths(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch21_trees", "The trees that a factor climbs", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}
