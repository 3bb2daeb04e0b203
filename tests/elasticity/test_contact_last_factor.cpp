#include <cmath>

#include "catch_compat.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/contact/node_to_obstacle.hpp"
#include "signorini/elasticity/contact_last_factor.hpp"
#include "signorini/elasticity/elements.hpp"
#include "support/linear_solve.hpp"
#include "support/meshes.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using namespace signorini;

namespace {

/// A body over an obstacle, with its stiffness and gap rows.
struct Body {
  Mesh mesh;
  Unknowns unknowns;
  Eigen::SparseMatrix<double> K;
  Rows A;

  [[nodiscard]] ContactLastFactor factor(Ledger& ledger) const {
    const std::vector<Index> last = contact_unknowns(A);
    return {K, nested_dissection(K, unknown_positions(mesh, unknowns), last),
            static_cast<Index>(last.size()), ledger};
  }
};

Body over(const Obstacle& obstacle, const Element& element, Vector2d size, Index nx, Index ny) {
  Mesh mesh = signorini_test::block_for(element, size, nx, ny);
  Unknowns unknowns = number_unknowns(mesh, {fixed("left")});
  const Material steel{21000, 0.29, PlaneState::Stress, 1};
  Eigen::SparseMatrix<double> K = assemble(mesh, element, steel, unknowns, {}).stiffness;
  const Surface source{mesh, "bottom"};
  GapOptions options;
  options.n_nodes = mesh.n_nodes();
  Rows A = reduce(node_to_obstacle(source, obstacle, options), source, unknowns, "contact").A;
  return {std::move(mesh), std::move(unknowns), std::move(K), std::move(A)};
}

/// A K^-1 A^T with one solve per row: slow, and without the trick.
Eigen::MatrixXd by_back_solves(const ContactLastFactor& factor, const Rows& A) {
  Eigen::MatrixXd G(A.rows(), A.rows());
  for (Index pair = 0; pair < A.rows(); ++pair)
    G.col(pair) = A * factor.solve(Eigen::VectorXd(A.row(pair).transpose()));
  return G;
}

}  // namespace

TEST_CASE("the compliance read off the trailing block is that of one back-solve per pair",
          "[factor]") {
  const Obstacle flat = half_plane({0, -1}, {0, 1});
  const Obstacle slanted = half_plane({0, -1}, {-0.3, 1});
  const Obstacle round = disc({3, -4}, 3);
  const Body bodies[] = {over(flat, q4(), {6, 2}, 12, 4), over(slanted, q4(), {6, 2}, 9, 5),
                         over(round, q4_incompatible(), {6, 6}, 8, 8),
                         over(round, q8(), {6, 2}, 6, 3), over(flat, q4(), {50, 1}, 40, 1)};
  for (const Body& body : bodies) {
    Ledger ledger;
    const ContactLastFactor factor = body.factor(ledger);
    const Eigen::MatrixXd G = factor.compliance(body.A);
    const Eigen::MatrixXd slow = by_back_solves(factor, body.A);
    CAPTURE(body.A.rows(), body.K.rows());
    // The slow way rounds with the condition number of K, which reaches 1e6 in the slender strip.
    CHECK((G - slow).norm() <= 1e-12 * slow.norm());
    CHECK(G == G.transpose());
    CHECK(G.diagonal().minCoeff() > 0);
  }
}

TEST_CASE("the factor solves its system, from scattered to trailing unknowns", "[factor]") {
  const Body body = over(half_plane({0, -1}, {0, 1}), q8(), {4, 2}, 8, 4);
  Ledger ledger;
  const ContactLastFactor factor = body.factor(ledger);
  REQUIRE(factor.size() == body.unknowns.count);
  signorini_test::Random random(5);
  Eigen::VectorXd exact(factor.size());
  for (Index k = 0; k < exact.size(); ++k) exact(k) = random.uniform(-1, 1);
  const Eigen::VectorXd load = body.K * exact;
  const Eigen::VectorXd u = factor.solve(load);
  CHECK((body.K * u - load).norm() < 1e-13 * load.norm());
  CHECK((u - exact).norm() < 1e-9 * exact.norm());  // rounding times condition number
}

TEST_CASE("a free body has a singular matrix, and the unknown that can move is named", "[factor]") {
  const Mesh mesh = signorini_test::block_for(q4(), {3, 2}, 6, 4);
  const Unknowns unknowns = number_unknowns(mesh, {symmetric("bottom")});  // may slide along x
  const Eigen::SparseMatrix<double> K = assemble(mesh, q4(), {}, unknowns, {}).stiffness;
  const EliminationOrder order = minimum_degree(K);
  Ledger ledger;
  const std::string plain =
      signorini_test::problem_message([&] { ContactLastFactor(K, order, 0, ledger); });
  CHECK_THAT(plain, ContainsSubstring("stiffness matrix is singular at unknown ") &&
                        ContainsSubstring("pivot") && ContainsSubstring("add a support"));
  const std::string named = signorini_test::problem_message([&] {
    ContactLastFactor(K, order, 0, ledger,
                      [&](Index unknown) { return unknowns.describe(mesh, unknown); });
  });
  CHECK_THAT(named, ContainsSubstring("(node ") && ContainsSubstring("direction x"));
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
      const Unknowns unknowns = number_unknowns(mesh, {symmetric(side)});
      const Eigen::SparseMatrix<double> K =
          assemble(mesh, q4(), {7, 0.3, PlaneState::Strain, 1}, unknowns, {}).stiffness;
      Ledger ledger;
      const std::string message = signorini_test::problem_message([&] {
        ContactLastFactor(K, nested_dissection(K, unknown_positions(mesh, unknowns)), 0, ledger);
      });
      found += message.empty() ? 0 : 1;
    }
  CHECK(found == 24);
}

TEST_CASE("a slender body is not taken for a free one", "[factor]") {
  const Mesh mesh = signorini_test::block_for(q4(), {1000, 1}, 400, 2);
  const Unknowns unknowns = number_unknowns(mesh, {fixed("left")});
  const Eigen::SparseMatrix<double> K = assemble(mesh, q4(), {}, unknowns, {}).stiffness;
  Ledger ledger;
  CHECK_NOTHROW(
      ContactLastFactor(K, nested_dissection(K, unknown_positions(mesh, unknowns)), 0, ledger));
}

TEST_CASE("a row of A that uses an unknown not ordered last is refused", "[factor]") {
  const Body body = over(half_plane({0, -1}, {0, 1}), q4(), {4, 2}, 4, 2);
  Ledger ledger;
  const ContactLastFactor factor = body.factor(ledger);
  Rows wrong(1, body.A.cols());
  const Index top = boundary_nodes(body.mesh, "top").front();
  wrong.insert(0, body.unknowns.number(top, 1)) = 1;
  CHECK_THAT(signorini_test::argument_message([&] { static_cast<void>(factor.compliance(wrong)); }),
             ContainsSubstring("row 0 of A") && ContainsSubstring("not ordered last"));
}

TEST_CASE("sizes that do not fit are refused", "[factor]") {
  const Body body = over(half_plane({0, -1}, {0, 1}), q4(), {4, 2}, 4, 2);
  Ledger ledger;
  const ContactLastFactor factor = body.factor(ledger);
  CHECK_THROWS_AS(factor.solve(Eigen::VectorXd::Zero(3)), std::invalid_argument);
  CHECK_THROWS_AS(factor.compliance(Rows(1, 3)), std::invalid_argument);
  CHECK_THROWS_AS(ContactLastFactor(body.K, {0, 1}, 0, ledger), std::invalid_argument);
}

TEST_CASE("the contact unknowns are the columns in use, sorted and once each", "[factor]") {
  Rows A(2, 6);
  A.insert(0, 4) = 1;
  A.insert(0, 1) = 2;
  A.insert(1, 4) = 3;
  CHECK(contact_unknowns(A) == std::vector<Index>{1, 4});
  CHECK(contact_unknowns(Rows(0, 6)).empty());
}
