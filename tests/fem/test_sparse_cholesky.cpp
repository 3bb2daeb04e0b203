// The plain factor of the library against the multifrontal one, and the family that both can be in.
#include "addons/frontal/backend.hpp"
#include "catch_compat.hpp"
#include "signorini/fem/factor.hpp"
#include "support/cantilever.hpp"
#include "support/factors.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

Factor factored(const Backend& backend, const Placed& placed, const Factor::Rows& A, Ledger& ledger,
                const std::vector<Index>& grounded = {}) {
  const auto positions = [&] { return placed.positions; };
  const auto describe = [](Index unknown) { return "node " + std::to_string(unknown); };
  return backend.factor({placed.K, A, positions, describe, grounded}, ledger);
}

Factor::Rows last_unknowns(Index n) {
  Factor::Rows A(std::min<Index>(n, 3), n);
  for (Index k = 0; k < A.rows(); ++k) A.insert(k, n - 1 - k) = k == 0 ? 1 : -0.5;
  return A;
}

}  // namespace

TEST_CASE("the plain factor solves as the multifrontal one does", "[factor][sparse_cholesky]") {
  for (const Placed& placed : placed_matrices()) {
    const Index n = placed.K.cols();
    CAPTURE(placed.name, n);
    const Factor::Rows A = last_unknowns(n);
    std::vector<Index> grounded;
    if (n > 2) grounded = {0, 2};
    Ledger ledger;
    Ledger unused;
    const Factor plain = factored(sparse_cholesky(), placed, A, ledger, grounded);
    const Factor other = factored(frontal(), placed, A, unused, grounded);
    const VectorXd load = VectorXd::LinSpaced(n, 1, 2);
    const VectorXd u = other.solve(load);
    CHECK((plain.solve(load) - u).norm() <= 1e-10 * u.norm());
    const Eigen::MatrixXd compliance = other.compliance(A, unused);
    CHECK((plain.compliance(A, ledger) - compliance).norm() <= 1e-10 * compliance.norm());
    CHECK(plain.size() == n);
    CHECK(plain.nonzeros() >= n);
    CHECK_FALSE(plain.part({}).has_value());
  }
}

TEST_CASE("the plain factor refuses what is singular or not finite, and names the unknown",
          "[factor][sparse_cholesky][input]") {
  const Placed loose = stiffness("loose", block_for(q4(), {3, 2}, 9, 6), q4(), {symmetric("left")});
  Ledger ledger;
  const auto said = [&](const Placed& placed) {
    const Factor::Rows A = last_unknowns(placed.K.cols());
    return problem_message(
        [&] { static_cast<void>(factored(sparse_cholesky(), placed, A, ledger)); });
  };
  CHECK_THAT(said(loose), ContainsSubstring("singular at unknown") && ContainsSubstring("(node "));
  Placed broken = stiffness("held", block_for(q4(), {3, 2}, 9, 6), q4(), {fixed("left")});
  CHECK(said(broken).empty());
  broken.K.coeffRef(4, 4) = std::nan("");
  CHECK_THAT(said(broken), ContainsSubstring("no finite number at unknown 4 (node 4)"));
}

TEST_CASE("a scene with the plain factor has the same solution", "[factor][sparse_cholesky]") {
  Scene scene = cantilever("q4_incompatible", 40, 4);
  const Solution other = solve(scene);
  scene.backend = sparse_cholesky();
  const Solution plain = solve(scene);
  REQUIRE(plain.contact.report.status == SolveStatus::Solved);
  CHECK(plain.contact.active() == other.contact.active());
  CHECK((plain.contact.force - other.contact.force).norm() <= 1e-10 * other.contact.force.norm());
}

TEST_CASE("the first back end that was added is the default", "[factor]") {
  CHECK(default_backend().factor == frontal().factor);
  const std::size_t count = backends().size();
  add_backend(frontal());  // it is there
  CHECK(backends().size() == count);
}
