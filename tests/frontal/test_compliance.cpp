#include <cmath>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/contact/node_to_obstacle.hpp"
#include "support/factors.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using namespace signorini;
using signorini_test::Placed;

namespace {

FrontalFactor factored(const Placed& placed) {
  Ledger ledger;
  return {placed.K, separator_tree(placed.K, placed.positions), ledger};
}

/// A K^-1 A^T with one solve per row: slow, and without the walk.
MatrixXd by_back_solves(const FrontalFactor& factor, const Rows& A) {
  MatrixXd G(A.rows(), A.rows());
  for (Index pair = 0; pair < A.rows(); ++pair)
    G.col(pair) = A * factor.solve(Eigen::VectorXd(A.row(pair).transpose()));
  return G;
}

/// Gaps of the bottom of a block over an obstacle.
struct Over {
  Placed body;
  Rows A;
};
Over over(const Obstacle& obstacle, const Element& element, Eigen::Vector2d size, Index nx,
          Index ny) {
  const Mesh mesh = signorini_test::block_for(element, size, nx, ny);
  const Unknowns unknowns = number_unknowns(mesh, {fixed("left")});
  const Surface source{mesh, "bottom"};
  GapOptions options;
  options.n_nodes = mesh.n_nodes();
  return {signorini_test::stiffness("over", mesh, element, {fixed("left")}),
          reduce(node_to_obstacle(source, obstacle, options), source, unknowns).A};
}

/// Rows with some entries each, anywhere; some rows are empty.
Rows random_rows(Index rows, Index columns, int entries, std::uint64_t seed) {
  signorini_test::Random random(seed);
  Rows A(rows, columns);
  for (Index i = 0; i < rows; ++i)
    for (int k = 0; k < (i % 5 == 3 ? 0 : entries); ++k)
      A.coeffRef(i, static_cast<Index>(random.uniform(0, 1) * static_cast<double>(columns))) =
          random.uniform(-1, 1);
  A.makeCompressed();
  return A;
}

}  // namespace

TEST_CASE("the compliance of one walk is that of one back-solve per pair", "[compliance]") {
  const Obstacle flat = half_plane({0, -1}, {0, 1});
  const Obstacle slanted = half_plane({0, -1}, {-0.3, 1});
  const Obstacle round = disc({3, -4}, 3);
  for (const Over& scene : {over(flat, q4(), {6, 2}, 12, 4), over(slanted, q4(), {6, 2}, 9, 5),
                            over(round, q4_incompatible(), {6, 6}, 8, 8),
                            over(round, q8(), {6, 2}, 6, 3), over(flat, q4(), {50, 1}, 40, 1)}) {
    const FrontalFactor factor = factored(scene.body);
    const MatrixXd G = factor.compliance(scene.A);
    const MatrixXd slow = by_back_solves(factor, scene.A);
    CAPTURE(scene.A.rows(), scene.body.K.rows());
    // The slow way rounds with the condition number of K, which reaches 1e6 in the slender strip.
    CHECK((G - slow).norm() <= 1e-12 * slow.norm());
    CHECK(G == G.transpose());
    CHECK(G.diagonal().minCoeff() > 0);
  }
}

TEST_CASE("rows may have entries anywhere, many, few or none, in pieces and patterns of no mesh",
          "[compliance]") {
  for (const Placed& placed : signorini_test::placed_matrices()) {
    const Index n = placed.K.cols();
    const FrontalFactor factor = factored(placed);
    for (const Index rows : {0, 1, 7, 60})
      for (const int entries : {1, 4, 25}) {
        if (n == 0 && rows > 0) continue;
        CAPTURE(placed.name, n, rows, entries);
        const Rows A = random_rows(rows, n, entries, static_cast<std::uint64_t>(rows));
        const MatrixXd G = factor.compliance(A);
        REQUIRE(G.rows() == rows);
        const MatrixXd slow = by_back_solves(factor, A);
        CHECK((G - slow).norm() <= 1e-11 * slow.norm());
        CHECK(G == G.transpose());
      }
  }
}

TEST_CASE("the compliance is the same each time, and in all units, to the last bit",
          "[compliance]") {
  const Over scene = over(disc({3, -4}, 3), q8(), {6, 2}, 24, 8);
  const MatrixXd G = factored(scene.body).compliance(scene.A);
  CHECK(factored(scene.body).compliance(scene.A) == G);
  for (const int power : {-700, -7, 1, 600}) {
    const double unit = std::ldexp(1.0, power);
    const FrontalFactor scaled = factored({"scaled", unit * scene.body.K, scene.body.positions});
    CHECK(MatrixXd(unit * scaled.compliance(scene.A)) == G);
  }
}
