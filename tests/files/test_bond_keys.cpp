// The tables of scene files that make bonds: ties, relations, rigid sides.
#include "addons/equations/bonds.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "signorini/scene/scene.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Vector2d;
using signorini_test::problem_message;

namespace {

const std::string bodies =
    "material = { youngs_modulus = 1, poisson_ratio = 0.3 }\n"
    "[[body]]\nname = \"a\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\nfixed = \"bottom\"\n"
    "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", corner = [0, 2], size = [4, 2], cells = [3, 2] }\n";

Scene read(const std::string& bonds) { return parse_scene(bodies + bonds, "name", ".").scene; }

/// The message about bonds that begin in line 9.
std::string complaint(const std::string& bonds) {
  return problem_message([&] { static_cast<void>(read(bonds)); });
}

}  // namespace

TEST_CASE("bonds of a scene file are those of a scene", "[scene_file][bonds]") {
  const Scene scene = read(
      "[[tie]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\ncloses = true\n"
      "[[tie]]\nsource = \"b.left\"\ntarget = { kind = \"half_plane\", point = [0, 0], normal = [1, 0] }\nslides = true\n"
      "[[tie]]\nsource = \"b.right\"\ntarget = { kind = \"half_plane\", point = [4, 0], normal = [-1, 0] }\n"
      "slides = true\nfriction = 0.2\n"
      "[[tie]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\nstiffness = [3, 1]\n"
      "[[relation]]\nterms = [{ side = \"b.top\", point = [0, 4], along = [0, 2] }, { side = \"a.top\", times = -1 }]\nright = 0.5\n"
      "[[relation]]\nterms = { side = \"a.left\" }\nstiffness = 7\n"
      "[[relation]]\nterms = { side = \"a.left\" }\nat_most = 0.25\n"
      "[[relation]]\nterms = { side = \"a.left\" }\nat_least = -3\n"
      "[[rigid]]\nside = \"b.top\"\ncentre = [1, 2]\nx = 0.1\nforce = [0, -3]\nmoment = 4\n");
  REQUIRE(scene.bonds);
  const Bonds& bonds = *scene.bonds;
  REQUIRE(bonds.ties.size() == 3);
  CHECK(bonds.ties[0].closes);
  CHECK_FALSE(bonds.ties[1].closes);
  CHECK_FALSE(bonds.ties[0].slides);
  CHECK(bonds.ties[1].slides);
  CHECK(bonds.ties[2].stiffness == Vector2d(3, 1));
  REQUIRE(scene.contacts.size() == 1);
  CHECK(bonds.two_sided == std::vector<std::size_t>{0});
  CHECK(scene.contacts[0].friction->coefficient == 0.2);
  REQUIRE(bonds.relations.size() == 4);
  CHECK(bonds.relations[0].right == 0.5);
  REQUIRE(bonds.relations[0].terms.size() == 2);
  CHECK(bonds.relations[0].terms[0].only_at == Vector2d(0, 4));
  CHECK(bonds.relations[0].terms[0].along == Vector2d(0, 2));
  CHECK(bonds.relations[0].terms[1].times == -1);
  CHECK(bonds.relations[1].stiffness == 7.0);
  CHECK(bonds.relations[1].holds == Holds::Equal);
  CHECK(bonds.relations[2].right == 0.25);
  CHECK(bonds.relations[2].holds == Holds::AtMost);
  CHECK(bonds.relations[3].right == -3);
  CHECK(bonds.relations[3].holds == Holds::AtLeast);
  REQUIRE(bonds.rigid.size() == 1);
  CHECK(bonds.rigid[0].centre == Vector2d(1, 2));
  CHECK(bonds.rigid[0].x == 0.1);
  CHECK_FALSE(bonds.rigid[0].turn.has_value());
  CHECK(bonds.rigid[0].force == Vector2d(0, -3));
  CHECK(bonds.rigid[0].moment == 4);
  CHECK_FALSE(read("").bonds);
}

TEST_CASE("bonds that a scene file cannot mean are refused where they stand", "[scene_file][bonds]") {
  const std::string tie = "[[tie]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\n";
  CHECK(complaint(tie + "friction = 0.2\n") ==
        "name:12: tie.friction: sides that are tied do not slide: add slides = true, or leave it out");
  CHECK(complaint(tie + "stiffness = [1, 1]\nslides = true\n") ==
        "name:13: tie.slides: has no meaning beside stiffness, which makes springs of the tie: leave it out");
  CHECK_FALSE(complaint("[[relation]]\nterms = []\n").empty());
  CHECK_FALSE(complaint("[[relation]]\nterms = { side = \"a.middle\" }\n").empty());
  CHECK_FALSE(complaint("[[relation]]\nterms = { side = \"a.left\" }\nstiffness = 0\n").empty());
  CHECK(complaint("[[relation]]\nterms = { side = \"a.left\" }\nat_most = 1\nat_least = 0\n") ==
        "name:12: relation.at_least: a relation has one number, right, at_most or at_least: write two relations for two");
  CHECK_FALSE(complaint("[[rigid]]\nturn = 1\n").empty());
}

// The second tie is to blame, and its line is named.
TEST_CASE("errors of ties name their line", "[scene_file][bonds]") {
  const SceneFile file = parse_scene(
      bodies + "[[tie]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\n"
               "[[tie]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\noperator = \"gauss_points\"\n",
      "name", ".");
  const std::string message = problem_message([&] { static_cast<void>(plan(file.scene)); });
  CHECK(located(file, message).rfind("name:12: tie of 'bottom' of 'b' with 'top' of 'a': the operator", 0) == 0);
}
