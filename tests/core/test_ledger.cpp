#include <sstream>
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/ledger.hpp"

using signorini::Ledger;

TEST_CASE("phases nest and their paths say so", "[ledger]") {
  Ledger ledger;
  {
    const Ledger::Phase factor(ledger, "factor");
    { const Ledger::Phase inner(ledger, "numeric"); }
    const Ledger::Phase second(ledger, "symbolic");
  }
  { const Ledger::Phase contact(ledger, "contact"); }
  REQUIRE(ledger.entries().size() == 4);
  CHECK(ledger.entries()[0].path == "factor");
  CHECK(ledger.entries()[1].path == "factor/numeric");
  CHECK(ledger.entries()[2].path == "factor/symbolic");
  CHECK(ledger.entries()[3].path == "contact");
}

TEST_CASE("counts and bytes go to the phase that is open, and add up over its calls", "[ledger]") {
  Ledger ledger;
  for (int call = 0; call < 3; ++call) {
    const Ledger::Phase outer(ledger, "outer");
    ledger.count("sweeps", 2);
    const Ledger::Phase inner(ledger, "inner");
    ledger.count("sweeps", 5);
    ledger.bytes(100);
  }
  CHECK(ledger.entries().size() == 2);
  CHECK(ledger.entries()[0].calls == 3);
  CHECK(ledger.counted("outer", "sweeps") == 6);
  CHECK(ledger.counted("outer/inner", "sweeps") == 15);
  CHECK(ledger.entries()[1].bytes == 300);
}

TEST_CASE("what is counted outside every phase is not lost", "[ledger]") {
  Ledger ledger;
  ledger.count("runs", 1);
  { const Ledger::Phase phase(ledger, "phase"); }
  ledger.count("runs", 1);
  CHECK(ledger.counted("outside", "runs") == 2);
}

TEST_CASE("an unknown phase or count is zero", "[ledger]") {
  Ledger ledger;
  { const Ledger::Phase phase(ledger, "known"); }
  CHECK(ledger.counted("known", "nothing") == 0);
  CHECK(ledger.counted("unknown", "nothing") == 0);
  CHECK(ledger.seconds("unknown") == 0);
}

TEST_CASE("an outer phase lasts at least as long as the phases in it", "[ledger]") {
  Ledger ledger;
  {
    const Ledger::Phase outer(ledger, "outer");
    const Ledger::Phase inner(ledger, "inner");
    volatile double x = 1;
    for (int k = 0; k < 100000; ++k) x = x * 1.0000001;
  }
  CHECK(ledger.seconds("outer/inner") > 0);
  CHECK(ledger.seconds("outer") >= ledger.seconds("outer/inner"));
}

TEST_CASE("the printed ledger shows every phase with its counts", "[ledger]") {
  Ledger ledger;
  {
    const Ledger::Phase outer(ledger, "factor");
    const Ledger::Phase inner(ledger, "numeric");
    ledger.count("nonzeros", 1234);
  }
  std::ostringstream out;
  out << ledger;
  CHECK_THAT(out.str(), ContainsSubstring("factor"));
  CHECK_THAT(out.str(), ContainsSubstring("  numeric"));
  CHECK_THAT(out.str(), ContainsSubstring("nonzeros 1234"));
}

TEST_CASE("a phase that is entered again is printed with all that is in it", "[ledger]") {
  Ledger ledger;
  {
    const Ledger::Phase factor(ledger, "factor");
    const Ledger::Phase ordering(ledger, "ordering");
  }
  { const Ledger::Phase assembly(ledger, "assembly"); }
  {
    const Ledger::Phase factor(ledger, "factor");
    const Ledger::Phase numeric(ledger, "numeric");
  }
  std::ostringstream table;
  table << ledger;
  std::vector<std::string> names;
  std::istringstream lines(table.str());
  for (std::string line; std::getline(lines, line);)
    names.push_back(line.substr(0, line.find_last_not_of(' ', line.find("  ", 4)) + 1));
  CHECK(names == std::vector<std::string>{"phase", "factor", "  ordering", "  numeric", "assembly"});
}
