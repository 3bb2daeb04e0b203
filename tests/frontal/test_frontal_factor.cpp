#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "catch_compat.hpp"
#include "support/factors.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using namespace signorini;
using signorini_test::Placed;
using signorini_test::problem_message;

namespace {

FrontalFactor factored(const Placed& placed) {
  Ledger ledger;
  return {placed.K, separator_tree(placed.K, placed.positions), ledger};
}

VectorXd random_vector(Index n, std::uint64_t seed) {
  signorini_test::Random random(seed);
  VectorXd v(n);
  for (Index k = 0; k < n; ++k) v(k) = random.uniform(-1, 1);
  return v;
}

/// Entries and operations of L by playing the elimination on the full pattern, separator by separator: the own
/// unknowns of one, and all later ones that any of them is joined to, become a clique.
struct Recount {
  long long nonzeros = 0;
  long long operations = 0;
};
Recount recount(const Matrix& K, const SeparatorTree& tree) {
  const std::size_t n = tree.order.size();
  std::vector<std::vector<bool>> joined(n, std::vector<bool>(n, false));
  std::vector<std::size_t> place(n);
  for (std::size_t a = 0; a < n; ++a) place[static_cast<std::size_t>(tree.order[a])] = a;
  for (std::size_t a = 0; a < n; ++a) {
    joined[a][a] = true;
    for (Matrix::InnerIterator entry(K, tree.order[a]); entry; ++entry)  // also those that are 0
      joined[a][place[static_cast<std::size_t>(entry.row())]] = true;
  }
  Recount count;
  for (const Separator& separator : tree.separators) {
    std::vector<std::size_t> front;
    const std::size_t first = static_cast<std::size_t>(separator.first);
    const std::size_t end = first + static_cast<std::size_t>(separator.own);
    for (std::size_t a = first; a < n; ++a) {
      bool in = a < end;
      for (std::size_t own = first; own < end; ++own) in = in || joined[a][own];
      if (in) front.push_back(a);
    }
    for (const std::size_t a : front)
      for (const std::size_t b : front) joined[a][b] = true;
    for (std::size_t k = 0; k < end - first; ++k) {
      const long long below = static_cast<long long>(front.size() - k) - 1;
      count.nonzeros += 1 + below;
      count.operations += below + below * (below + 1);  // quotients; products and differences
    }
  }
  return count;
}

}  // namespace

TEST_CASE("fronts solve what dense elimination solves: every element, pieces, random patterns",
          "[factor]") {
  for (const Placed& placed : signorini_test::placed_matrices()) {
    CAPTURE(placed.name, placed.K.cols(), placed.positions.rows());
    const FrontalFactor factor = factored(placed);
    REQUIRE(factor.size() == placed.K.cols());
    const VectorXd exact = random_vector(factor.size(), 5);
    const VectorXd load = placed.K * exact;
    const VectorXd u = factor.solve(load);
    const Eigen::MatrixXd dense(placed.K);
    const VectorXd expected = dense.llt().solve(load);
    CHECK((placed.K * u - load).norm() <= 1e-13 * load.norm());
    CHECK((u - expected).norm() <= 1e-11 * expected.norm());  // rounding times condition number
  }
}

// A front of a mesh has what its own unknowns touch. In other patterns a part below may hand on what they do not.
TEST_CASE("entries and operations of the factor equal a recount", "[factor]") {
  for (const Placed& placed : signorini_test::placed_matrices()) {
    if (placed.K.cols() > 200) continue;
    CAPTURE(placed.name, placed.K.cols());
    Ledger ledger;
    const SeparatorTree tree = separator_tree(placed.K, placed.positions);
    const FrontalFactor factor(placed.K, tree, ledger);
    const Recount expected = recount(placed.K, tree);
    const double most = placed.name == "random" ? 1.05 : 1;
    const double nonzeros = static_cast<double>(expected.nonzeros);
    const double operations = static_cast<double>(expected.operations);
    CHECK(factor.nonzeros() >= expected.nonzeros);
    CHECK(static_cast<double>(factor.nonzeros()) <= most * nonzeros);
    CHECK(factor.operations() >= operations);
    CHECK(factor.operations() <= most * operations);
    CHECK(ledger.counted("numeric", "nonzeros") == factor.nonzeros());
    CHECK(static_cast<double>(ledger.counted("numeric", "operations")) == factor.operations());
  }
}

TEST_CASE("the same numbers each time, and in all units, to the last bit", "[factor]") {
  const Mesh mesh = signorini_test::block_for(q8(), {3, 2}, 24, 16);
  const Placed body = signorini_test::stiffness("block", mesh, q8(), {fixed("left")});
  const VectorXd load = random_vector(body.K.cols(), 1);
  const VectorXd u = factored(body).solve(load);
  CHECK(factored(body).solve(load) == u);
  for (const int power : {-900, -31, 1, 2, 600}) {
    const double unit = std::ldexp(1.0, power);
    CHECK(factored({"scaled", unit * body.K, body.positions}).solve(unit * load) == u);
  }
}

// Parts of one place share fronts; those that are apart share few, so that all parts cost about what the whole does.
TEST_CASE("a part that nothing joins with others is solved alone to the same bits",
          "[factor][part]") {
  const Placed a =
      signorini_test::stiffness("a", signorini_test::block_for(q4(), {3, 2}, 9, 7), q4(), {});
  for (const double apart : {0.0, 5.0}) {
    Placed all = a;
    const Index count = a.K.cols();
    const Index bodies = 12;
    for (Index k = 1; k < bodies; ++k) {
      Placed moved = a;
      moved.positions.col(0).array() += apart * static_cast<double>(k);
      all = signorini_test::beside(all, moved);
    }
    for (Index k = 0; k < all.K.cols(); ++k) all.K.coeffRef(k, k) *= 1.01;
    const FrontalFactor factor = factored(all);
    double operations = 0;
    for (Index k = 0; k < bodies; ++k) {
      CAPTURE(apart, k);
      std::vector<Index> unknowns;
      for (Index i = 0; i < count; ++i) unknowns.push_back(k * count + i);
      const FrontalFactor::Part part = factor.part(unknowns);
      operations += part.solve_operations;
      const VectorXd load = random_vector(count, static_cast<std::uint64_t>(k));
      VectorXd whole = VectorXd::Zero(all.K.cols());
      whole.segment(k * count, count) = load;
      const VectorXd u = factor.solve(part, load);
      CHECK(u == factor.solve(whole).segment(k * count, count));
      CHECK((u.array() != 0).all());
    }
    CHECK(operations >= factor.solve_operations());
    if (apart > 0) CHECK(operations <= 1.2 * factor.solve_operations());
  }
  const FrontalFactor factor = factored(signorini_test::random_matrix(9, 1, 1));
  CHECK_THROWS_AS(factor.part({9}), std::invalid_argument);
  CHECK_THROWS_AS(factor.part({-1}), std::invalid_argument);
  CHECK_THROWS_AS(factor.solve(factor.part({0, 1}), VectorXd::Zero(9)), std::invalid_argument);
}

// Of a boundary alone the fronts above it are enough, each of them once, however many unknowns it eliminates.
TEST_CASE("some unknowns of a body are solved for with the fronts above them, to the same bits", "[factor][part]") {
  Placed held = signorini_test::stiffness("held", signorini_test::block_for(q4(), {1, 1}, 90, 90), q4(), {});
  const Index n = held.K.cols();
  for (Index k = 0; k < n; ++k) held.K.coeffRef(k, k) *= 1.01;
  const FrontalFactor whole = factored(held);
  for (const Index every : {1, 7, 500}) {
    CAPTURE(every);
    std::vector<Index> some;
    for (Index k = 0; k < n; k += every) some.push_back(k);
    const FrontalFactor::Part part = whole.part(some);
    if (every == 1) CHECK(std::abs(part.solve_operations / whole.solve_operations() - 1) <= 1e-12);
    if (every == 500) CHECK(part.solve_operations < whole.solve_operations());
    const VectorXd load = random_vector(static_cast<Index>(some.size()), 3);
    VectorXd all = VectorXd::Zero(n);
    all(some) = load;
    CHECK(whole.solve(part, load) == VectorXd(whole.solve(all)(some)));
  }
}

TEST_CASE("a free body is found out on every mesh, whatever rounding leaves of the last pivot",
          "[factor]") {
  int found = 0;
  for (Index n = 1; n <= 12; ++n)
    for (const char* side : {"bottom", "left"}) {
      const Mesh mesh = signorini_test::distorted(
          signorini_test::block_for(q4(), {3, 2}, n + 1, n), {3, 2},
          {3.0 / static_cast<double>(n + 1), 2.0 / static_cast<double>(n)},
          static_cast<std::uint64_t>(n));
      const Placed body = signorini_test::stiffness("free", mesh, q4(), {symmetric(side)});
      for (const NodeArray& positions : {body.positions, NodeArray(0, 2)})
        found += problem_message([&] { factored({"free", body.K, positions}); }).empty() ? 0 : 1;
    }
  CHECK(found == 48);
}

TEST_CASE("springs hold a free body as a matrix with them does, to the last bit", "[factor]") {
  const Mesh mesh = signorini_test::block_for(q4(), {3, 2}, 6, 4);
  const Placed free = signorini_test::stiffness("free", mesh, q4(), {});
  const std::vector<Index> grounded = {0, 1, free.K.cols() - 1};
  Matrix held = free.K;
  for (const Index unknown : grounded) held.coeffRef(unknown, unknown) *= 2;
  const SeparatorTree tree = separator_tree(free.K, free.positions);
  Ledger ledger;
  const FrontalFactor springs(free.K, tree, ledger, {}, grounded);
  const VectorXd load = random_vector(free.K.cols(), 3);
  CHECK(springs.solve(load) == FrontalFactor(held, tree, ledger).solve(load));
  CHECK_THROWS_AS(FrontalFactor(free.K, tree, ledger), ProblemError);
  CHECK_THROWS_AS(FrontalFactor(free.K, tree, ledger, {}, {free.K.cols()}), std::invalid_argument);
}

TEST_CASE("a slender body is not taken for a free one", "[factor]") {
  const Mesh mesh = signorini_test::block_for(q4(), {1000, 1}, 400, 2);
  const Placed body = signorini_test::stiffness("beam", mesh, q4(), {fixed("left")});
  CHECK_NOTHROW(factored(body));
  CHECK_NOTHROW(factored({"beam somewhere", body.K, {}}));
}

TEST_CASE("numbers that are none, negative and zero diagonals are told apart", "[factor]") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double entry : {0.0, -1.0, inf, std::nan("")}) {
    Matrix K(3, 3);
    for (int k = 0; k < 3; ++k) K.insert(k, k) = k == 1 ? entry : 1;
    K.makeCompressed();
    const std::string message = problem_message([&] { factored({"bad", K, {}}); });
    CHECK_THAT(message, ContainsSubstring("at unknown 1"));
    if (std::isfinite(entry))
      CHECK_THAT(message, ContainsSubstring("singular") && ContainsSubstring("diagonal entry"));
    else
      CHECK_THAT(message, ContainsSubstring("no finite number") && !ContainsSubstring("support"));
  }
  CHECK_THROWS_AS(factored({"nothing stored", Matrix(2, 2), {}}), ProblemError);
}

TEST_CASE("sizes that do not fit are refused", "[factor]") {
  const Placed body = signorini_test::random_matrix(5, 0.5, 1);
  const FrontalFactor factor = factored(body);
  Ledger ledger;
  CHECK_THROWS_AS(factor.solve(VectorXd::Zero(3)), std::invalid_argument);
  CHECK_THROWS_AS(factor.compliance(Eigen::SparseMatrix<double, Eigen::RowMajor>(1, 3)),
                  std::invalid_argument);
  CHECK_THROWS_AS(
      FrontalFactor(signorini_test::random_matrix(4, 0.5, 1).K, separator_tree(body.K), ledger),
      std::invalid_argument);
  CHECK_THROWS_AS(FrontalFactor(Matrix(3, 5), separator_tree(body.K), ledger),
                  std::invalid_argument);
}
