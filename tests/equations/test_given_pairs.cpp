// Contacts whose pairs ties and relations hold as well.
#include <algorithm>
#include <cmath>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::problem_message;

namespace {

Scene scene_of(const std::string& words) { return parse_scene(words, "name", ".").scene; }

const std::string block_on_bed =
    "material = { youngs_modulus = 100, poisson_ratio = 0.3 }\n"
    "[[body]]\nmesh = { kind = \"block\", size = [3, 1], cells = [3, 2] }\nfixed = \"bottom\"\n";

/// A plate whose upper side is at a height, above it.
std::string plate_at(const std::string& height) {
  return "[[contact]]\nsource = \"top\"\nfriction = 0.2\ntarget = { kind = \"half_plane\", point = [0, " + height +
         "], normal = [0, -1] }\n";
}

std::string lifted_by(const std::string& way) {
  return "[[relation]]\nterms = { side = \"top\", along = [0, 1] }\nright = " + way + "\n";
}

}  // namespace

// The block rises by 0.001 or more, whatever the plate does.
TEST_CASE("a pair whose gap a relation says has no force of its own", "[equations][given]") {
  const std::string height = GENERATE("1.001", "1.0010001", "1.5");
  CAPTURE(height);
  const SolvedScene run = solved(scene_of(block_on_bed + lifted_by("0.001") + plate_at(height)), "the block");
  CHECK(run.solution.certificate.holds());
  CHECK(run.solution.contact.force.size() == 0);
  CHECK(run.model.law.pair.empty());
  // As if there were no plate.
  const SolvedScene alone = solved(scene_of(block_on_bed + lifted_by("0.001")), "the block");
  CHECK((run.solution.displacements[0] - alone.solution.displacements[0]).cwiseAbs().maxCoeff() <= 1e-15);
  CHECK(bond_forces(run.model, run.solution)[0].force.y() > 0);
}

TEST_CASE("a relation that pushes a side into an obstacle is refused by place", "[equations][given][errors]") {
  const std::string message = problem_message(
      [&] { static_cast<void>(plan(scene_of(block_on_bed + lifted_by("0.002") + plate_at("1.001")))); });
  CAPTURE(message);
  CHECK(message.find("the pair at (3, 1) is held by supports, ties, relations or rigid sides and overlaps by 0.001") !=
        std::string::npos);
}

// Held along two directions that are not at a right angle, all of the upper side is where two relations say.
TEST_CASE("no friction where relations hold both components", "[equations][given]") {
  const std::string across = "[[relation]]\nterms = { side = \"top\", along = [0.6, 0.8] }\nright = -0.001\n";
  const SolvedScene run =
      solved(scene_of(block_on_bed + across + lifted_by("0") + plate_at("1")), "the block");
  CHECK(run.solution.certificate.holds());
  CHECK(run.solution.contact.force.size() == 0);
  CHECK(run.solution.displacements[0].bottomRows(1)(0, 0) == Approx(-0.001 / 0.6).epsilon(1e-13));
}

// Of the four nodes of the side one moves as a relation says: the others press, and rub.
TEST_CASE("other pairs keep their places and their friction", "[equations][given]") {
  const std::string one = "[[relation]]\nterms = { side = \"top\", point = [1, 1], along = [0, 1] }\nright = -0.01\n";
  const SolvedScene run = solved(scene_of(block_on_bed + one + plate_at("0.99")), "the block");
  CHECK(run.solution.certificate.holds());
  REQUIRE(run.solution.contact.force.size() == 3);
  CHECK(run.model.contact_of.size() == 3);
  CHECK(run.model.law.pair == std::vector<Index>{0, 1, 2});
  for (const Index pair : {0, 1, 2}) {
    CHECK(run.model.pairs.position(pair, 0) != 1);
    CHECK(run.solution.contact.force(pair) > 0);
    CHECK(std::abs(run.solution.contact.friction(pair)) <= 0.2 * run.solution.contact.force(pair) * (1 + 1e-12));
  }
}

TEST_CASE("a contact of sides that a tie joins has no pairs left", "[equations][given]") {
  const std::string bodies =
      "material = { youngs_modulus = 100, poisson_ratio = 0.3 }\n"
      "[[body]]\nname = \"a\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\nfixed = \"bottom\"\n"
      "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", corner = [0, 2], size = [4, 2], cells = [3, 2] }\n"
      "pressure = { top = 1 }\n";
  const std::string sides = "source = \"b.bottom\"\ntarget = \"a.top\"\n";
  const SolvedScene run =
      solved(scene_of(bodies + "[[tie]]\n" + sides + "[[contact]]\n" + sides + "friction = 0.3\n"), "the two");
  const SolvedScene tied = solved(scene_of(bodies + "[[tie]]\n" + sides), "the two");
  CHECK(run.solution.certificate.holds());
  CHECK(run.solution.contact.force.size() == 0);
  for (const std::size_t body : {0, 1})
    CHECK((run.solution.displacements[body] - tied.solution.displacements[body]).cwiseAbs().maxCoeff() <=
          1e-14 * tied.solution.displacements[1].cwiseAbs().maxCoeff());
  CHECK(std::any_of(run.solution.notes.begin(), run.solution.notes.end(), [](const std::string& note) {
    return note.find("4 pairs can neither open nor close") != std::string::npos;
  }));
}

TEST_CASE("messages call a tie that slides a tie", "[equations][given][errors]") {
  const std::string bodies =
      "material = { youngs_modulus = 100, poisson_ratio = 0.3 }\n"
      "[[body]]\nname = \"a\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\nfixed = \"bottom\"\n"
      "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", corner = [0, 2.1], size = [4, 2], cells = [3, 2] }\n";
  const std::string sides = "source = \"b.bottom\"\ntarget = \"a.top\"\n";
  const std::string slides = "[[tie]]\n" + sides + "slides = true\nfriction = 0.3\n";
  const auto message = [&](const std::string& more) {
    return problem_message([&] { static_cast<void>(plan(scene_of(bodies + slides + more))); });
  };
  // The one keeps the gap of 0.1, and the other closes it.
  CHECK(message("[[tie]]\n" + sides).find("sliding tie of 'bottom' of 'b' with 'top' of 'a': the pair at") == 0);
  CHECK(message("[[contact]]\n" + sides).find("(ties that rub count as contacts) are about the same sides") !=
        std::string::npos);
}
