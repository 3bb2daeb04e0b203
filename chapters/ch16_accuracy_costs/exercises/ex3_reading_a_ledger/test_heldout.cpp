#include <array>
#include <chrono>
#include <stdexcept>

#include "../chapters/ch16_accuracy_costs/scenes.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_3;
using signorini::Ledger;

namespace {

void wait(double milliseconds) {
  const auto begin = std::chrono::steady_clock::now();
  using Milliseconds = std::chrono::duration<double, std::milli>;
  while (Milliseconds(std::chrono::steady_clock::now() - begin).count() < milliseconds) {
  }
}

void counts(Ledger& ledger, const char* outer, const char* inner, const char* name, long long n) {
  const Ledger::Phase phase(ledger, outer);
  if (inner == nullptr) {
    ledger.count(name, n);
    return;
  }
  const Ledger::Phase nested(ledger, inner);
  ledger.count(name, n);
}

/// Phases within phases, and one whose name begins as that of another.
Ledger nested(double outer, double middle, double inner, double other) {
  Ledger ledger;
  {
    const Ledger::Phase a(ledger, "a");
    wait(outer);
    const Ledger::Phase b(ledger, "b");
    wait(middle);
    const Ledger::Phase c(ledger, "c");
    wait(inner);
  }
  const Ledger::Phase again(ledger, "ab");
  wait(other);
  return ledger;
}

}  // namespace

// Whatever the machine does meanwhile, the phase that is returned is compared with what the ledger has.
TEST_CASE("ex16.3 held out: phases within phases within phases", "[ex16.3]") {
  for (const std::array<double, 4>& waits :  // of a, b, c and ab [ms]
       {std::array<double, 4>{20, 2, 2, 2},
        {2, 20, 2, 2},
        {2, 2, 20, 2},
        {2, 2, 2, 20},
        {20, 0, 16, 0}}) {
    const Ledger ledger = nested(waits[0], waits[1], waits[2], waits[3]);
    const double a = ledger.seconds("a"), b = ledger.seconds("a/b"), c = ledger.seconds("a/b/c");
    const double own[] = {a - b, b - c, c, ledger.seconds("ab")};
    const char* paths[] = {"a", "a/b", "a/b/c", "ab"};
    int most = 0;
    for (int k = 1; k < 4; ++k)
      if (own[k] > own[most]) most = k;
    CHECK(dearest(ledger) == paths[most]);
  }
  CHECK(dearest(Ledger()) == decltype(dearest(Ledger())){});
}

TEST_CASE("ex16.3 held out: counts by hand", "[ex16.3]") {
  Ledger ledger;
  counts(ledger, "factor", "numeric", "operations", 800);
  CHECK(over_plain(ledger) == 1);
  counts(ledger, "condensation", nullptr, "operations", 500);
  counts(ledger, "condensation", nullptr, "operations of one solve", 200);
  CHECK(over_plain(ledger) == Approx(1.3).epsilon(1e-14));
  counts(ledger, "refinement", nullptr, "operations", 700);
  counts(ledger, "refinement", nullptr, "solves", 7);
  CHECK(over_plain(ledger) == Approx(2).epsilon(1e-14));
}

TEST_CASE("ex16.3 held out: powers by hand, in either order", "[ex16.3]") {
  Ledger small, large;
  counts(small, "assembly", nullptr, "unknowns", 100);
  counts(large, "assembly", nullptr, "unknowns", 400);
  counts(small, "factor", "numeric", "operations", 1000);
  counts(large, "factor", "numeric", "operations", 8000);
  CHECK(power_of(small, large, "factor/numeric", "operations") == Approx(1.5).epsilon(1e-12));
  CHECK(power_of(large, small, "factor/numeric", "operations") == Approx(1.5).epsilon(1e-12));
  CHECK_THROWS_AS(power_of(small, large, "factor", "operations"), std::invalid_argument);
  counts(large, "contact", nullptr, "iterations", 3);
  CHECK_THROWS_AS(power_of(small, large, "contact", "iterations"), std::invalid_argument);
  CHECK_THROWS_AS(power_of(Ledger(), large, "factor/numeric", "operations"), std::invalid_argument);
  CHECK_THROWS_AS(over_plain(Ledger()), std::invalid_argument);
}

TEST_CASE("ex16.3 held out: the cantilever, whose whole lower side may touch", "[ex16.3]") {
  double before = 2;
  for (const Eigen::Index cells : {8, 16}) {
    const signorini::SolvedScene run = signorini::solved(ch16::cantilever(cells), "the cantilever");
    const signorini::Factor& factor = run.condensed.factor;
    const double now = over_plain(run.solution.ledger);
    CHECK(now == Approx(ch16::operations(run.solution.ledger) /
                        (factor.operations() + factor.solve_operations()))
                     .epsilon(1e-12));
    CHECK(now < before);
    before = now;
  }
}
