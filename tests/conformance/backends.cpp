// What every back end promises: the solutions and the compliance of ours, certified scenes with the same forces, and the same
// refusals.  With optional libraries this file is linked once more, with a table that has their members.
#include <cmath>
#include <limits>

#include "addons/frontal/backend.hpp"
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "support/chosen.hpp"
#include "support/effect_examples.hpp"
#include "support/factors.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Rows = Factor::Rows;

namespace {

Factor factored(const Backend& backend, const Placed& placed, const Rows& A, Ledger& ledger,
                const std::vector<Index>& grounded = {}) {
  return backend.factor({placed.K, A, [&] { return placed.positions; }, {}, grounded}, ledger);
}

Rows random_rows(Index rows, Index columns, std::uint64_t seed) {
  Random random(seed);
  Rows A(rows, columns);
  for (Index i = 0; i < rows; ++i)
    for (int k = 0; k < (i % 5 == 3 ? 0 : 4); ++k)
      A.coeffRef(i, random.whole(0, static_cast<int>(columns) - 1)) = random.uniform(-1, 1);
  A.makeCompressed();
  return A;
}

VectorXd some_load(Index n) {
  Random random(2);
  VectorXd load(n);
  for (double& force : load) force = random.uniform(-1, 1);
  return load;
}

/// Ours.
const Backend& reference() { return backends().front(); }

/// What a back end says against a matrix, empty if it takes it.
std::string said(const Backend& backend, const Placed& placed,
                 const std::vector<Index>& grounded = {}) {
  const Rows A = random_rows(3, placed.K.cols(), 1);
  Ledger ledger;
  return problem_message(
      [&] { static_cast<void>(factored(backend, placed, A, ledger, grounded)); });
}

Placed changed(Placed placed, double factor, Index unknown, double entry) {
  placed.K *= factor;
  placed.K.coeffRef(unknown, unknown) = entry;
  return placed;
}

Placed block(const std::vector<Support>& supports) {
  return stiffness("block", block_for(q4(), {3, 2}, 9, 6), q4(), supports);
}

}  // namespace

TEST_CASE("every back end: solutions and the compliance are those of ours",
          "[conformance][backends]") {
  for (const Backend& backend : chosen(backends()))
    for (const Placed& placed : placed_matrices()) {
      const Index n = placed.K.cols();
      for (const Index rows : {0, 1, 23}) {
        if (n == 0 && rows > 0) continue;
        CAPTURE(backend.name, placed.name, n, rows);
        const Rows A = random_rows(rows, n, 7);
        const Rows others = random_rows(rows, n, 8);
        Ledger ledger;
        const Factor ours = factored(reference(), placed, A, ledger);
        const VectorXd expected = ours.solve(some_load(n));
        const MatrixXd G = ours.compliance(A, ledger);
        const MatrixXd other_G = ours.compliance(others, ledger);
        Ledger counts;
        const Factor factor = factored(backend, placed, A, counts);
        REQUIRE(factor.size() == n);
        CHECK((factor.solve(some_load(n)) - expected).norm() <= 1e-10 * expected.norm());
        const MatrixXd made = factor.compliance(A, counts);
        REQUIRE(made.rows() == rows);
        CHECK((made - G).norm() <= 1e-10 * G.norm());
        CHECK(made == made.transpose());
        {
          const Ledger::Phase phase(counts, "others");
          CHECK((factor.compliance(others, counts) - other_G).norm() <= 1e-10 * other_G.norm());
        }
        CHECK((counts.counted("others", "operations") > 0) == (rows > 0));
        CHECK_THROWS_AS(factor.solve(VectorXd::Zero(n + 1)), std::invalid_argument);
        CHECK_THROWS_AS(factor.compliance(Rows(1, n + 1), counts), std::invalid_argument);
        if (n == 0) continue;
        CHECK(counts.counted("numeric", "nonzeros") == factor.nonzeros());
        CHECK(factor.nonzeros() >= n);
        CHECK(counts.counted("numeric", "operations") ==
              static_cast<long long>(factor.operations()));
        CHECK(factor.solve_operations() > 0);
      }
    }
}

TEST_CASE("every back end: the order of a matrix before serves the next, or is not taken",
          "[conformance][backends]") {
  const Placed before = block({fixed("left")});
  const Index n = before.K.cols();
  const Rows A = random_rows(3, n, 7);
  for (const Backend& backend : chosen(backends()))
    for (const Index far : {Index(1), n - 1}) {  // of one cell with the first unknown, and of none
      Placed next = before;
      next.K.coeffRef(0, far) = next.K.coeffRef(far, 0) = 0.1 * before.K.coeff(0, 0);
      next.K.makeCompressed();
      CAPTURE(backend.name, far);
      Ledger ledger;
      const Factor first = factored(backend, before, A, ledger);
      const std::any order = first.order();
      const VectorXd u = factored(backend, next, A, ledger).solve(some_load(n));
      Ledger again;  // its factor is the last one: of some back ends only that one lives
      const Factor second =
          backend.factor({next.K, A, [&] { return next.positions; }, {}, {}, order}, again);
      CHECK((second.solve(some_load(n)) - u).norm() <= 1e-10 * u.norm());
      if (!order.has_value()) continue;
      CHECK(again.counted("ordering", "orders") == (far == 1 ? 0 : 1));
    }
  Ledger ledger;
  CHECK(factored(reference(), before, A, ledger).order().has_value());
}

TEST_CASE("every back end: what it solves of a part is what it solves of all",
          "[conformance][backends]") {
  const Placed body = block({fixed("left")});
  const Placed two = beside(body, body);
  const Index n = body.K.cols();
  std::vector<Index> second;
  for (Index k = n; k < 2 * n; ++k) second.push_back(k);
  VectorXd load = VectorXd::Zero(2 * n);
  load.tail(n) = some_load(n);
  for (const Backend& backend : chosen(backends())) {
    CAPTURE(backend.name);
    Ledger ledger;
    const Factor factor = factored(backend, two, random_rows(1, 2 * n, 1), ledger);
    const std::optional<Factor::Part> part = factor.part(second);
    if (!part) continue;  // it is then asked for all
    const VectorXd u = factor.solve(load).tail(n);
    CHECK((part->solve(load.tail(n)) - u).norm() <= 1e-14 * u.norm());
    CHECK(part->solve_operations < factor.solve_operations());
    const std::vector<Index> edge = {n, n + 3, 2 * n - 1};  // of which K joins each with others
    const VectorXd lone = factor.part(edge)->solve(load(edge));
    VectorXd pushed = VectorXd::Zero(2 * n);
    pushed(edge) = load(edge);
    CHECK((lone - factor.solve(pushed)(edge)).norm() <= 1e-14 * lone.norm());
  }
  Ledger ledger;
  CHECK(factored(reference(), two, random_rows(1, 2 * n, 1), ledger).part(second).has_value());
}

TEST_CASE("every back end: units of force change no digit that counts", "[conformance][backends]") {
  const Placed body = block({fixed("left")});
  const Rows A = random_rows(9, body.K.cols(), 3);
  for (const Backend& backend : chosen(backends()))
    for (const int power : {-700, -7, 1, 600}) {
      CAPTURE(backend.name, power);
      const double unit = std::ldexp(1.0, power);
      Ledger ledger;
      const MatrixXd G = factored(backend, body, A, ledger).compliance(A, ledger);
      const Placed scaled{"scaled", unit * body.K, body.positions};
      const MatrixXd other = factored(backend, scaled, A, ledger).compliance(A, ledger);
      CHECK((unit * other - G).norm() <= 1e-14 * G.norm());
    }
}

TEST_CASE("every back end: springs as stiff as a diagonal entry hold what nothing else does",
          "[conformance][backends]") {
  const Placed free = block({});
  const std::vector<Index> grounded = {0, 1, free.K.cols() - 1};
  const Rows A = random_rows(9, free.K.cols(), 3);
  Ledger ledger;
  const MatrixXd G = factored(reference(), free, A, ledger, grounded).compliance(A, ledger);
  for (const Backend& backend : chosen(backends())) {
    CAPTURE(backend.name);
    const MatrixXd made = factored(backend, free, A, ledger, grounded).compliance(A, ledger);
    CHECK((made - G).norm() <= 1e-10 * G.norm());
  }
}

TEST_CASE(
    "every back end: what is singular, indefinite or no number is refused in the words of ours",
    "[conformance][backends]") {
  const Placed held = block({fixed("left")});
  const Placed without =
      stiffness("far", block_for(q4(), {3, 2}, 40, 30), q4(), {symmetric("left")});
  for (const Backend& backend : chosen(backends()))
    for (const Placed& wrong :
         {block({}), block({symmetric("left")}), block({symmetric("bottom")}), without,
          beside(held, block({symmetric("left")})), changed(held, -1, 0, -1),
          changed(held, 1, 50, -held.K.coeff(50, 50)), changed(held, 0, 0, 0),
          changed(held, 1, 7, std::numeric_limits<double>::quiet_NaN()),
          changed(held, 1, 7, std::numeric_limits<double>::infinity())}) {
      CAPTURE(backend.name, wrong.name, wrong.K.cols());
      const std::string expected = said(reference(), wrong);
      REQUIRE_FALSE(expected.empty());
      CHECK(said(backend, wrong) == expected);
      CHECK(said(backend, held).empty());  // and goes on
    }
}

TEST_CASE("every back end: a slender body is not taken for a free one", "[conformance][backends]") {
  const Placed slender = stiffness("slender", block_for(q4_incompatible(), {1000, 1}, 400, 2),
                                   q4_incompatible(), {fixed("left")});
  for (const Backend& backend : chosen(backends())) {
    CAPTURE(backend.name);
    CHECK(said(backend, slender).empty());
  }
}

TEST_CASE("every back end: scenes of every effect have the forces of ours, certified",
          "[conformance][backends]") {
  for (const Backend& backend : chosen(backends()))
    for (const auto& [name, example] : effect_examples()) {
      Scene scene = example.with;
      if (scene.path) continue;  // solve_steps() has the same condense()
      CAPTURE(backend.name, name);
      const Solution ours = solve(scene);
      scene.backend = backend;
      const Solution other = solve(scene);
      REQUIRE(other.contact.report.status == ours.contact.report.status);
      if (ours.contact.report.status != SolveStatus::Solved) continue;
      CHECK(other.certificate.worst() <= 1e-12);
      CHECK(other.contact.active() == ours.contact.active());
      CHECK((other.refined.force - ours.refined.force).norm() <= 1e-10 * ours.refined.force.norm());
    }
}

TEST_CASE("an unknown back end is refused before anything is solved, with those that there are",
          "[conformance][backends]") {
  CHECK(problem_message([] {
          static_cast<void>(find_backend("frontl"));
        }).find("did you mean 'frontal'?") != std::string::npos);
  CHECK(reference().name == std::string("frontal"));
  CHECK(Scene().backend.factor == reference().factor);
}
