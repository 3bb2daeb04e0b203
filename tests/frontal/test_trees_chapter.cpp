// The tree of chapter 21 against the factor of Eigen, and the three ways to one compliance against each other.
#include <Eigen/SparseCholesky>
#include <numeric>

#include "../chapters/ch21_one_factor/elimination_tree.hpp"
#include "../chapters/ch21_one_factor/scenes.hpp"
#include "catch_compat.hpp"
#include "signorini/scene/bodies.hpp"

using namespace ch21;

// Exact: Eigen keeps every entry that the pattern of K and the order call for, also if it is zero by chance.
TEST_CASE("a tree of columns has the entries of L, and no front misses one", "[trees]") {
  const Model model = built(cantilever(GENERATE(1, 3, 6)));
  const Sparse& K = model.programme.stiffness;
  Order given(static_cast<std::size_t>(K.cols()));
  std::iota(given.begin(), given.end(), 0);
  const SeparatorTree separators = separator_tree(K, unknown_positions(model));
  for (const Order& order :
       {given, minimum_degree(K), contact_last(K, model.programme.A), separators.order}) {
    Eigen::PermutationMatrix<Eigen::Dynamic> P(
        Eigen::Map<const Eigen::VectorXi>(order.data(), K.cols()));
    const Sparse permuted = P.transpose() * K * P;
    const Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(permuted);
    const EliminationTree tree = elimination_tree(K, order);
    CHECK(tree.entries ==
          static_cast<double>(Sparse(factor.matrixL()).nonZeros()));  // integers below 2^53
  }
  const EliminationTree tree = elimination_tree(K, separators.order);
  const Fronts fronts = fronts_of(K, separators);
  CHECK(tree.entries <= static_cast<double>(fronts.nonzeros()));
  CHECK(tree.operations <= fronts.operations());
}

TEST_CASE("contact comes last, and nothing else does", "[trees]") {
  const Model model = built(cantilever(2));
  const NodalRows& A = model.programme.A;
  const Order order = contact_last(model.programme.stiffness, A);
  std::vector<bool> touches(order.size(), false);
  for (Eigen::Index row = 0; row < A.rows(); ++row)
    for (NodalRows::InnerIterator it(A, row); it; ++it)
      touches[static_cast<std::size_t>(it.col())] = true;
  std::vector<bool> last;
  for (const int unknown : order) last.push_back(touches[static_cast<std::size_t>(unknown)]);
  CHECK(std::is_sorted(last.begin(), last.end()));
  CHECK(std::is_permutation(order.begin(), order.end(),
                            minimum_degree(model.programme.stiffness).begin()));
}
