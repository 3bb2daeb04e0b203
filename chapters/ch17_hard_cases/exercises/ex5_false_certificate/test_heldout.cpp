#include <algorithm>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"

using namespace ex17_5;
using Eigen::Index;
using Eigen::VectorXd;
using signorini::Certificate;
using signorini::QuadraticProgramme;

namespace {

const double no_number = std::numeric_limits<double>::quiet_NaN();

QuadraticProgramme sparse(const signorini::DenseProgramme& q) {
  return {q.stiffness.sparseView(), q.load, q.A.sparseView(), q.initial_gap};
}

std::vector<std::string> one(const char* name) { return {name}; }

}  // namespace

// Each figure in turn is stated a thousand times too small; all others as they are.
TEST_CASE("ex17.5 held out: one figure of a bad answer at a time", "[ex17.5]") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const signorini::KnownProgramme known = signorini::rosen_suzuki(8, 6, seed);
    const QuadraticProgramme programme = sparse(known.programme);
    VectorXd force = known.force;
    for (Index i = 0; i < force.size(); ++i) force(i) += i % 2 == 0 ? 0.3 : -0.4;
    const VectorXd pushed = known.displacement + known.programme.A.transpose() * VectorXd::Ones(6);
    const signorini::PrimalDual answer{pushed, {}, force};
    const Certificate really = certify(programme, answer);
    CAPTURE(seed);
    CHECK(understated(programme, {"", answer, really}) ==
          decltype(understated(programme, {"", answer, really})){});
    const auto forged = [&](double Certificate::*figure, double value) {
      Certificate printed = really;
      printed.*figure = value;
      return understated(programme, {"", answer, printed});
    };
    const std::vector<std::pair<const char*, double Certificate::*>> all = {
        {"penetration", &Certificate::penetration},
        {"tension", &Certificate::tension},
        {"complementarity", &Certificate::complementarity},
        {"equilibrium", &Certificate::equilibrium},
        {"duality gap", &Certificate::duality_gap}};
    for (const auto& [name, figure] : all) {
      CAPTURE(name);
      REQUIRE(really.*figure > 1e-6);
      CHECK(forged(figure, 1e-3 * really.*figure) == one(name));
      CHECK(forged(figure, 0.51 * really.*figure) ==
            decltype(forged(figure,
                            0.51 * really.*figure)){});  // a figure is printed with few digits
      CHECK(forged(figure, 0.49 * really.*figure) == one(name));
      CHECK(forged(figure, -1) == one(name));
      CHECK(forged(figure, no_number) == one(name));
    }
  }
}

TEST_CASE("ex17.5 held out: what rounding leaves is nothing, and more is something", "[ex17.5]") {
  const signorini::KnownProgramme known = signorini::rosen_suzuki(6, 4, 5);
  const QuadraticProgramme programme = sparse(known.programme);
  signorini::PrimalDual answer{known.displacement, {}, known.force};
  answer.displacement(0) *= 1 + 1e-13;
  const Certificate really = certify(programme, answer);
  REQUIRE(really.equilibrium > 2e-15);
  const std::vector<std::string> found = understated(programme, {"", answer, {}});
  CHECK(std::count(found.begin(), found.end(), "equilibrium") == 1);
  CHECK(read(programme, {{"", answer, really}}).believed.size() == 1);
  answer.displacement(0) *= 1 + 1e-9;
  CHECK(read(programme, {{"", answer, certify(programme, answer)}}).bad.size() == 1);
}

// The sum of both parts is the answer: the first alone misses by 1e-9.
TEST_CASE("ex17.5 held out: a displacement in two parts", "[ex17.5]") {
  const VectorXd rest = 1e-9 * Eigen::Vector4d(1, -1, 1, 2);
  const Document right = documents()[0];
  const signorini::PrimalDual parts{right.answer.displacement - rest, rest, right.answer.force};
  const Opinion opinion = read(posed(), {{"both", parts, Certificate{0, 0, 0, 1e-15, 1e-15}},
                                         {"one", {parts.displacement, {}, parts.force}, {}}});
  CHECK(opinion.believed == std::vector<std::size_t>{0});
  CHECK(opinion.untrue == std::vector<std::size_t>{1});
}

TEST_CASE("ex17.5 held out: the same pile in other units, and an empty one", "[ex17.5]") {
  const Opinion plain = read(posed(), documents());
  for (const double length : {1e-6, 1e6}) {
    QuadraticProgramme programme = posed();
    programme.stiffness = programme.stiffness / length;
    programme.initial_gap *= length;
    std::vector<Document> pile = documents();
    for (Document& document : pile) document.answer.displacement *= length;
    const Opinion other = read(programme, pile);
    CHECK(other.believed == plain.believed);
    CHECK(other.bad == plain.bad);
    CHECK(other.untrue == plain.untrue);
  }
  CHECK(read(posed(), {}).untrue == decltype(read(posed(), {}).untrue){});
}

// A figure that no figure can be was not computed, however good the answer is.
TEST_CASE("ex17.5 held out: a good answer below a figure that is none", "[ex17.5]") {
  Document document = documents()[0];
  for (const double printed : {-1e-20, no_number}) {
    document.printed.tension = printed;
    CHECK(understated(posed(), document) == one("tension"));
    CHECK(read(posed(), {document}).untrue.size() == 1);
  }
}

TEST_CASE("ex17.5 held out: no numbers, and sizes that do not fit", "[ex17.5]") {
  Document document = documents()[0];
  document.answer.displacement(1) = no_number;
  CHECK(understated(posed(), document).size() == 5);
  document.answer.displacement.resize(3);
  CHECK_THROWS_AS(understated(posed(), document), std::invalid_argument);
  CHECK_THROWS_AS(read(posed(), {document}), std::invalid_argument);
}
