#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "catch_compat.hpp"
#include "meshes/hertz_meshes.hpp"
#include "signorini/core/index.hpp"
#include "support/factors.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;
using namespace signorini;
using signorini_test::graph;
using signorini_test::Placed;

namespace {

/// For each separator the first place of all that lies below it.
std::vector<int> first_below(const SeparatorTree& tree) {
  std::vector<int> first;
  for (const Separator& separator : tree.separators) {
    first.push_back(separator.first);
    for (const int below : separator.below)
      if (below >= 0) first.back() = std::min(first.back(), first[at(below)]);
  }
  return first;
}

/// Whether separators follow each other without a gap, and each comes directly behind what it parts.
bool in_order(const SeparatorTree& tree) {
  const std::vector<int> first = first_below(tree);
  int place = 0;
  bool good = true;
  for (std::size_t s = 0; s < tree.separators.size(); ++s) {
    const auto& [begin, own, below] = tree.separators[s];
    good = good && begin == place && (below[0] < 0) == (below[1] < 0);
    if (below[0] >= 0)
      good = good && at(below[1]) == s - 1 &&
             tree.separators[at(below[0])].first + tree.separators[at(below[0])].own ==
                 first[at(below[1])];
    place += own;
  }
  return good && at(place) == tree.order.size() && (tree.separators.empty() || first.back() == 0);
}

/// Entries of the matrix that join the two parts of a separator.
int joined_parts(const Matrix& K, const SeparatorTree& tree) {
  const std::vector<int> first = first_below(tree);
  std::vector<int> place(tree.order.size());
  for (std::size_t k = 0; k < place.size(); ++k) place[at(tree.order[k])] = static_cast<int>(k);
  int joined = 0;
  for (const Separator& separator : tree.separators) {
    if (separator.below[0] < 0) continue;
    const int middle = first[at(separator.below[1])];
    for (int p = first[at(separator.below[0])]; p < middle; ++p)
      for (Matrix::InnerIterator entry(K, tree.order[at(p)]); entry; ++entry) {
        const int other = place[at(static_cast<int>(entry.row()))];
        joined += other >= middle && other < separator.first ? 1 : 0;
      }
  }
  return joined;
}

/// How many separators lie above each other.
int height(const SeparatorTree& tree) {
  std::vector<int> heights;
  for (const Separator& separator : tree.separators) {
    heights.push_back(1);
    for (const int below : separator.below)
      if (below >= 0) heights.back() = std::max(heights.back(), 1 + heights[at(below)]);
  }
  return heights.empty() ? 0 : heights.back();
}

/// What a factor has and costs.
struct Work {
  double nonzeros = 0;
  double operations = 0;
};

Work work(const Placed& placed) {
  Ledger ledger;
  const FrontalFactor factor(placed.K, separator_tree(placed.K, placed.positions), ledger);
  return {static_cast<double>(factor.nonzeros()), factor.operations()};
}

/// That of a factor in the order of minimum degree, column by column.
Work work_by_degree(const Matrix& K) {
  const Eigen::SimplicialLLT<Matrix> factor(K);
  const Matrix L = factor.matrixL();
  double sum = 0;
  for (Index k = 0; k < L.cols(); ++k) {
    const double below = L.outerIndexPtr()[k + 1] - L.outerIndexPtr()[k] - 1;
    sum += below * (below + 2);
  }
  return {static_cast<double>(L.nonZeros()), sum};
}

}  // namespace

TEST_CASE("every unknown has one place, and the parts of a separator do not touch", "[tree]") {
  for (const Placed& placed : signorini_test::placed_matrices()) {
    const SeparatorTree tree = separator_tree(placed.K, placed.positions);
    CAPTURE(placed.name, placed.K.cols(), placed.positions.rows());
    std::vector<int> sorted = tree.order;
    std::sort(sorted.begin(), sorted.end());
    bool every_one = static_cast<Index>(sorted.size()) == placed.K.cols();
    for (std::size_t k = 0; k < sorted.size(); ++k) every_one = every_one && sorted[k] == int(k);
    CHECK(every_one);
    CHECK(in_order(tree));
    CHECK(joined_parts(placed.K, tree) == 0);
  }
}

TEST_CASE("a tree serves another matrix unless an entry joins what a separator parts", "[tree]") {
  Random random(5);
  int kept = 0, lost = 0;
  for (const Placed& placed : signorini_test::placed_matrices()) {
    const int n = static_cast<int>(placed.K.cols());
    const SeparatorTree tree = separator_tree(placed.K, placed.positions);
    CAPTURE(placed.name, n);
    CHECK(keeps_apart(tree, placed.K));
    CHECK_FALSE(keeps_apart(tree, Matrix(n + 1, n + 1)));
    for (int k = 0; k < (n > 0 ? 20 : 0); ++k) {
      Matrix other = placed.K;
      const int i = random.whole(0, n - 1);
      const int j = random.whole(0, n - 1);
      other.coeffRef(i, j) = other.coeffRef(j, i) = 1;
      other.makeCompressed();
      const bool apart = joined_parts(other, tree) == 0;
      CHECK(keeps_apart(tree, other) == apart);
      (apart ? kept : lost) += 1;
    }
  }
  CHECK(kept > 20);
  CHECK(lost > 20);
}

TEST_CASE("units and the origin do not change the tree", "[tree]") {
  const Mesh mesh = signorini_test::block_for(q8(), {4, 2}, 16, 8);
  const Placed body = signorini_test::stiffness("block", mesh, q8(), {fixed("left")});
  const SeparatorTree tree = separator_tree(body.K, body.positions);
  for (const double factor : {1e-3, 1.0 / 1024, 25.4})
    for (const double shift : {0.0, -4096.0}) {
      const NodeArray moved = factor * (body.positions.array() + shift).matrix();
      CHECK(separator_tree(factor * body.K, moved).order == tree.order);
    }
}

TEST_CASE("bodies that do not touch are parted by nothing", "[tree]") {
  const Mesh mesh = signorini_test::block_for(q4(), {2, 1}, 8, 4);
  const Placed body = signorini_test::stiffness("body", mesh, q4(), {fixed("left")});
  Placed two = signorini_test::beside(body, body);
  const Index n = body.K.cols();
  for (const double above : {1.0, 0.5, 0.0}) {  // one on the other, one in the other, at one place
    two.positions.bottomRows(n) = body.positions;
    two.positions.col(1).tail(n).array() += above;
    const SeparatorTree tree = separator_tree(two.K, two.positions);
    CHECK(tree.separators.back().own == 0);
    CHECK(joined_parts(two.K, tree) == 0);
    CHECK(work(two).operations <= 1.01 * 2 * work(body).operations);
  }
}

TEST_CASE("graphs of no mesh are cut as well, and the tree stays low", "[tree]") {
  const int n = 3000;
  std::vector<std::pair<int, int>> star, path, comb;
  for (int k = 1; k < n; ++k) {
    star.emplace_back(0, k);
    path.emplace_back(k - 1, k);
    comb.emplace_back(k % 2 == 0 ? k - 2 : k - 1, k);
  }
  const int low = static_cast<int>(3 * std::log2(n));
  for (const auto& edges : {star, path, comb, std::vector<std::pair<int, int>>()}) {
    const Matrix K = graph(n, edges);
    const SeparatorTree tree = separator_tree(K);
    Ledger ledger;
    CAPTURE(edges.size());
    CHECK(in_order(tree));
    CHECK(joined_parts(K, tree) == 0);
    CHECK(height(tree) <= low);
    CHECK(FrontalFactor(K, tree, ledger).nonzeros() <= 6 * n);
  }
}

TEST_CASE("about the work of minimum degree on small squares, beams and the graded meshes of Hertz",
          "[tree]") {
  // Coordinates cut squares and discs better than minimum degree, beams and graded plates a little worse; levels
  // of the graph alone know less.
  struct Bound {
    double with_positions;
    double without;
  };
  const std::vector<Bound> bounds = {{0.75, 1.25}, {1.25, 1.65}, {1.0, 1.25}, {1.25, 1.4}};
  std::vector<Placed> bodies;
  for (const auto& [length, cells] : {std::pair{1, 60}, {10, 16}}) {
    const Mesh mesh = signorini_test::block_for(q4(), {double(length), 1}, length * cells, cells);
    bodies.push_back(signorini_test::stiffness("block", mesh, q4(), {fixed("left")}));
  }
  HertzMeshSpec spec;
  spec.disc_cells = spec.plate_cells = 32;
  spec.disc_rows = spec.plate_rows = 24;
  spec.disc_layers = spec.plate_layers = 30;
  const HertzMeshes meshes = make_hertz_meshes(spec);
  bodies.push_back(signorini_test::stiffness("disc", meshes.disc, q4(), {fixed("axis")}));
  bodies.push_back(signorini_test::stiffness("plate", meshes.plate, q4(), {fixed("base")}));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Placed& body = bodies[k];
    CAPTURE(body.name, body.K.cols());
    const Work degree = work_by_degree(body.K);
    const Work own = work(body);
    CHECK(own.operations <= bounds[k].with_positions * degree.operations);
    if (k == 0) CHECK(own.nonzeros <= degree.nonzeros);
    CHECK(work({body.name, body.K, {}}).operations <= bounds[k].without * degree.operations);
  }
}

TEST_CASE("positions that do not fit are refused", "[tree]") {
  const Matrix K = graph(4, {{0, 1}});
  CHECK_THAT(signorini_test::argument_message(
                 [&] { static_cast<void>(separator_tree(K, NodeArray::Zero(3, 2))); }),
             ContainsSubstring("3 positions for 4 x 4"));
  CHECK_THROWS_AS(separator_tree(Matrix(3, 4)), std::invalid_argument);
}
