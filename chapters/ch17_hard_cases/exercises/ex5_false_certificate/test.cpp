#include <algorithm>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex17_5;

static const std::vector<std::string> names = {"penetration", "tension", "complementarity",
                                               "equilibrium", "duality gap"};

// Nobody is named here: how often each figure is stated too small, and how many figures are in one document.
TEST_CASE("ex17.5 the figures that are too small, counted", "[ex17.5]") {
  std::vector<int> of_name(names.size(), 0);
  std::vector<std::size_t> of_document;
  for (const Document& document : documents()) {
    const std::vector<std::string> found = understated(posed(), document);
    of_document.push_back(found.size());
    auto from = names.begin();  // in the order of the names, each once
    for (const std::string& name : found) {
      from = std::find(from, names.end(), name);
      REQUIRE(from != names.end());
      ++of_name[static_cast<std::size_t>(from++ - names.begin())];
    }
  }
  CHECK(of_name == std::vector<int>{1, 1, 1, 1, 2});
  std::sort(of_document.begin(), of_document.end());
  CHECK(of_document == std::vector<std::size_t>{0, 0, 0, 1, 2, 3});
}

TEST_CASE("ex17.5 two to believe, one that is bad and says so, three that are false", "[ex17.5]") {
  const std::vector<Document> pile = documents();
  const Opinion opinion = read(posed(), pile);
  CHECK(opinion.believed.size() == 2);
  CHECK(opinion.bad.size() == 1);
  CHECK(opinion.untrue.size() == 3);
  for (const std::size_t k : opinion.believed) {
    const bool solves = certify(posed(), pile.at(k).answer).holds(1e-12);
    CHECK(solves);
  }
  int single = 0;
  for (const std::size_t k : opinion.untrue)
    single += understated(posed(), pile.at(k)).size() == 1 ? 1 : 0;
  CHECK(single == 1);
}

TEST_CASE("ex17.5 sizes that do not fit are refused", "[ex17.5]") {
  Document document = documents().front();
  document.answer.displacement.resize(3);
  CHECK_THROWS_AS(understated(posed(), document), std::invalid_argument);
}
