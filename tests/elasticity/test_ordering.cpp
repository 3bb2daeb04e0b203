#include <algorithm>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/elasticity/contact_last_factor.hpp"
#include "signorini/elasticity/elements.hpp"
#include "support/linear_solve.hpp"
#include "support/meshes.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;
using namespace signorini;

namespace {

struct Body {
  Mesh mesh;
  Unknowns unknowns;
  Matrix K;
  NodeArray positions;
};

Body square(Index cells, const Element& element) {
  Mesh mesh = signorini_test::block_for(element, {1, 1}, cells, cells);
  Unknowns unknowns = number_unknowns(mesh, {fixed("left")});
  Matrix K = assemble(mesh, element, {}, unknowns, {}).stiffness;
  NodeArray positions = unknown_positions(mesh, unknowns);
  return {std::move(mesh), std::move(unknowns), std::move(K), std::move(positions)};
}

std::vector<Index> bottom_unknowns(const Body& body) {
  std::vector<Index> list;
  for (const Index node : boundary_nodes(body.mesh, "bottom"))
    if (body.unknowns.number(node, 1) >= 0) list.push_back(body.unknowns.number(node, 1));
  std::sort(list.begin(), list.end());
  return list;
}

/// Entries and operations of L D L^T by playing the elimination on the full pattern, term by term.
struct Recount {
  long long nonzeros = 0;
  long long operations = 0;
};
Recount recount(const Matrix& K, const EliminationOrder& order) {
  const std::size_t n = order.size();
  std::vector<std::size_t> place(n);
  for (std::size_t k = 0; k < n; ++k) place[static_cast<std::size_t>(order[k])] = k;
  std::vector<std::vector<bool>> filled(n, std::vector<bool>(n, false));
  for (Index column = 0; column < K.cols(); ++column)  // stored entries, also those of value zero
    for (Matrix::InnerIterator entry(K, column); entry; ++entry)
      filled[place[static_cast<std::size_t>(entry.row())]]
            [place[static_cast<std::size_t>(column)]] = true;
  Recount count;
  for (std::size_t k = 0; k < n; ++k) {
    ++count.nonzeros;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (!filled[i][k]) continue;
      ++count.nonzeros;
      ++count.operations;  // l_ik = a_ik / d_k
      for (std::size_t j = k + 1; j <= i; ++j) {
        if (!filled[j][k]) continue;
        count.operations += 2;  // a_ij -= l_ik d_k l_jk
        filled[i][j] = filled[j][i] = true;
      }
    }
  }
  return count;
}

}  // namespace

TEST_CASE("an elimination order is a permutation that ends with the chosen unknowns",
          "[ordering]") {
  for (const Element& element : {q4(), q8()}) {
    const Body body = square(7, element);
    const std::vector<Index> last = bottom_unknowns(body);
    for (const EliminationOrder& order :
         {nested_dissection(body.K, body.positions, last), minimum_degree(body.K, last)}) {
      CAPTURE(element.name);
      REQUIRE(order.size() == static_cast<std::size_t>(body.unknowns.count));
      std::vector<Index> tail(order.end() - static_cast<std::ptrdiff_t>(last.size()), order.end());
      std::sort(tail.begin(), tail.end());
      CHECK(tail == last);
      std::vector<int> sorted = order;
      std::sort(sorted.begin(), sorted.end());
      bool every_one = true;
      for (std::size_t k = 0; k < sorted.size(); ++k)
        every_one = every_one && sorted[k] == static_cast<int>(k);
      CHECK(every_one);
    }
  }
}

TEST_CASE("entries and operations of the factor equal a recount, whatever the order",
          "[ordering][factor]") {
  const Body body = square(6, q4());
  const std::vector<Index> last = bottom_unknowns(body);
  for (const EliminationOrder& order :
       {nested_dissection(body.K, body.positions), nested_dissection(body.K, body.positions, last),
        minimum_degree(body.K)}) {
    Ledger ledger;
    const ContactLastFactor factor(body.K, order, 0, ledger);
    const Recount expected = recount(body.K, order);
    CHECK(factor.nonzeros() == expected.nonzeros);
    CHECK(factor.operations() == static_cast<double>(expected.operations));
    CHECK(ledger.counted("numeric", "nonzeros") == expected.nonzeros);
    CHECK(ledger.counted("numeric", "operations") == expected.operations);
  }
}

TEST_CASE("nested dissection fills no more than minimum degree on a square of 60 x 60 cells",
          "[ordering]") {
  const Body body = square(60, q4());
  Ledger ledger;
  const ContactLastFactor dissected(body.K, nested_dissection(body.K, body.positions), 0, ledger);
  const ContactLastFactor greedy(body.K, minimum_degree(body.K), 0, ledger);
  CHECK(dissected.nonzeros() <= greedy.nonzeros());
  CHECK(dissected.operations() <= greedy.operations());
}

TEST_CASE("unknowns that cannot come last are refused", "[ordering]") {
  const Body body = square(2, q4());
  using signorini_test::argument_message;
  const auto message = [&](const std::vector<Index>& last) {
    return argument_message(
        [&] { static_cast<void>(nested_dissection(body.K, body.positions, last)); });
  };
  CHECK_THAT(message({3, 3}), ContainsSubstring("distinct") && ContainsSubstring("got 3"));
  CHECK_THAT(message({12}), ContainsSubstring("below 12, got 12"));
  CHECK_THAT(message({-1}), ContainsSubstring("got -1"));
  CHECK_THAT(argument_message([&] { static_cast<void>(minimum_degree(body.K, {99})); }),
             ContainsSubstring("got 99"));
  CHECK_THAT(argument_message(
                 [&] { static_cast<void>(nested_dissection(body.K, body.positions.topRows(3))); }),
             ContainsSubstring("3 positions"));
}
