#include <chrono>
#include <stdexcept>

#include "../chapters/ch16_accuracy_costs/scenes.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_3;
using signorini::Ledger;

static Ledger hertz(Eigen::Index cells) {
  return signorini::solved(ch16::hertz(cells), "Hertz").solution.ledger;
}

static void wait(int milliseconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  while (std::chrono::steady_clock::now() < end) {
  }
}

// The left bars of figure 16.4, in operations.
TEST_CASE("ex16.3 what contact adds to a plain solve", "[ex16.3]") {
  const signorini::SolvedScene run = signorini::solved(ch16::hertz(16), "Hertz");
  const signorini::Factor& factor = run.condensed.factor;
  const Ledger& ledger = run.solution.ledger;
  CHECK(ledger.counted("assembly", "unknowns") == 2649);
  CHECK(over_plain(ledger) ==
        Approx(ch16::operations(ledger) / (factor.operations() + factor.solve_operations()))
            .epsilon(1e-12));
  CHECK(over_plain(ledger) == Approx(1.49).margin(0.02));
}

TEST_CASE("ex16.3 the factor grows fastest, and the entries of K as the unknowns", "[ex16.3]") {
  const Ledger small = hertz(8), large = hertz(16);
  const double factor = power_of(small, large, "factor/numeric", "operations");
  const double entries = power_of(small, large, "assembly", "stiffness entries");
  const double solve = power_of(small, large, "condensation", "operations of one solve");
  CHECK(entries == Approx(1).margin(0.05));
  CHECK(solve > entries);
  CHECK(factor > solve);
  CHECK(factor < 1.6);
  CHECK_THROWS_AS(power_of(small, small, "factor/numeric", "operations"), std::invalid_argument);
}

TEST_CASE("ex16.3 a phase is not as dear as what is nested in it", "[ex16.3]") {
  const Ledger ledger = hertz(8);
  const std::string path = dearest(ledger);
  const auto own = [&](const std::string& phase) {
    double seconds = ledger.seconds(phase);
    if (phase == "factor")
      for (const char* part : {"factor/ordering", "factor/symbolic", "factor/numeric"})
        seconds -= ledger.seconds(part);
    return seconds;
  };
  REQUIRE(ledger.seconds(path) > 0);
  for (const signorini::LedgerEntry& entry : ledger.entries()) {
    CAPTURE(entry.path);
    CHECK(own(path) >= own(entry.path));
  }
}

// What is nested takes most of the time, and ten times as much as the phase around it by itself.
TEST_CASE("ex16.3 the dearest phase of three by hand", "[ex16.3]") {
  Ledger ledger;
  {
    const Ledger::Phase outer(ledger, "outer");
    wait(2);
    const Ledger::Phase inner(ledger, "inner");
    wait(20);
  }
  const double outer = ledger.seconds("outer"), inner = ledger.seconds("outer/inner");
  CAPTURE(outer, inner);
  CHECK(dearest(ledger) == (outer - inner > inner ? "outer" : "outer/inner"));
}
