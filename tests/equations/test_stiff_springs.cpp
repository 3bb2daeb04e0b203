// Springs in the place of ties and relations that are so stiff that rounding of K shows.
#include <string>

#include "addons/equations/bonds.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"

using namespace signorini;
using signorini_test::problem_message;

namespace {

/// Two blocks whose meshes do not match, with E = 1000, under a load of 4.
Scene joined_by(const std::string& bond) {
  return parse_scene("material = { youngs_modulus = 1000, poisson_ratio = 0.3 }\n"
                     "[[body]]\nname = \"a\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\nfixed = \"bottom\"\n"
                     "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", corner = [0, 2], size = [4, 2], cells = [3, 2] }\n"
                     "pressure = { top = 1 }\n" + bond,
                     "name", ".")
      .scene;
}

Scene tied_with(double stiffness) {
  return joined_by(text("[[tie]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\nstiffness = [", stiffness, ", ", stiffness, "]\n"));
}

}  // namespace

// What is lost of the balance is rounding of the springs, epsilon times their stiffness over E, times a few for sums over nodes.
TEST_CASE("stiff elastic ties leave the load to the supports", "[equations][springs]") {
  const double times = GENERATE(1e2, 1e5, 1e7);
  CAPTURE(times);
  const SolvedScene run = solved(tied_with(1000 * times), "the two");
  const Eigen::RowVector2d borne = support_forces(run.model, run.solution, 0).colwise().sum();
  CAPTURE(borne);
  CHECK((borne - Eigen::RowVector2d(0, 4)).norm() <= 4 * (1e-12 + 64 * epsilon * times));
}

TEST_CASE("springs that are too stiff for the digits of K are refused", "[equations][springs][errors]") {
  const auto message = [](const Scene& scene) {
    return problem_message([&] { static_cast<void>(solved(scene, "the two")); });
  };
  const std::string tie = message(tied_with(1e13));
  CAPTURE(tie);
  CHECK(tie.find("elastic tie of 'bottom' of 'b' with 'top' of 'a': a spring of it has the stiffness") !=
        std::string::npos);
  CHECK(tie.find("Leave out stiffness") != std::string::npos);
  const std::string held = "[[tie]]\nsource = \"b.bottom\"\ntarget = \"a.top\"\n"
                           "[[relation]]\nterms = { side = \"b.top\" }\nstiffness = ";
  CHECK(message(joined_by(held + "1e12\n")).find("relation 1: a spring of it") != std::string::npos);
  CHECK(message(joined_by(held + "1e9\n")).empty());
}
