#include <algorithm>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex17_5;
using signorini::Certificate;

// The figures of a certificate, in the order of their names.
static std::vector<double> figures(const Certificate& figure) {
  return {figure.penetration, figure.tension, figure.complementarity, figure.equilibrium,
          figure.duality_gap};
}

static const std::vector<std::string> names = {"penetration", "tension", "complementarity",
                                               "equilibrium", "duality gap"};

// Every name that is returned is recomputed, and so is every one that is not.
TEST_CASE("ex17.5 the figures that are named are too small, and all others are not", "[ex17.5]") {
  for (const Document& document : documents()) {
    CAPTURE(document.author);
    const std::vector<std::string> found = understated(posed(), document);
    const std::vector<double> printed = figures(document.printed);
    const std::vector<double> really = figures(certify(posed(), document.answer));
    for (const std::string& name : found) CHECK(std::count(names.begin(), names.end(), name) == 1);
    for (std::size_t k = 0; k < names.size(); ++k) {
      const bool named = std::count(found.begin(), found.end(), names[k]) == 1;
      const bool right = named == (really[k] > 2 * printed[k] && really[k] > 1e-15);
      CHECK(right);
    }
  }
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
