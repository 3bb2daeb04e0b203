// Random scenes of bodies that move, by the arithmetic of the tests.
#include <cmath>

#include "catch_compat.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "support/energy_forces.hpp"
#include "support/meshes.hpp"
#include "support/random_outcomes.hpp"
#include "support/sample.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

// Half of them under finite strain.
TEST_CASE("random bodies that move are never silently wrong, and mostly solved",
          "[motion][random]") {
  int unsolved = 0;
  for (std::uint64_t seed = 0; seed < 120; seed += sample_step) {
    const Trial trial = try_scene(seed, RandomScenes::Moving);
    CAPTURE(seed, trial.text);
    CHECK_FALSE(is_fault(trial.outcome));
    const bool refused = trial.outcome == Outcome::Refused || trial.outcome == Outcome::Turned;
    if (trial.outcome != Outcome::Solved && !refused) ++unsolved;
  }
  CHECK(unsolved <= 2);  // of the first 300 there are 4, of which 1 is a jump of cohesion
  CHECK(try_scene(548, RandomScenes::Moving).outcome == Outcome::Solved);  // its iterations once went round
}

TEST_CASE("that check notices forces, strains and places that are a little off",
          "[motion][random]") {
  int forces = 0;  // some tools never touch
  int strains = 0;
  int places = 0;
  for (std::uint64_t seed = 0; seed < 20; seed += sample_step) {
    const auto wrong = [seed](void (*change)(Solution & solution)) {
      return try_scene(seed, RandomScenes::Moving, "", change).outcome == Outcome::Wrong;
    };
    forces += wrong([](Solution& solution) { solution.refined.force *= 1 + 1e-6; });
    strains += wrong([](Solution& solution) { solution.refined.displacement *= 1 + 1e-6; });
    places += wrong([](Solution& solution) {
      for (NodeArray& moved : solution.displacements) moved *= 1 + 1e-6;
    });
  }
  CAPTURE(forces, strains, places);
  CHECK(forces >= 14 / sample_step);
  CHECK(strains >= 14 / sample_step);
  CHECK(places >= 14 / sample_step);
}

TEST_CASE("the forces that it compares with are those of a stretched bar", "[motion][random]") {
  // lambda = mu = 1.2, and the sides are held. In a sheet the strain across is that without stress.
  const double s = 1.3;
  const double E = (s * s - 1) / 2;
  struct Bar {
    const char* law;
    PlaneState state;
    double stress;  // first Piola
  };
  for (const Bar& bar : {Bar{"neo_hooke", PlaneState::Strain, 1.2 * (s - 1 / s + std::log(s) / s)},
                         Bar{"st_venant_kirchhoff", PlaneState::Strain, 1.2 * s * 3 * E},
                         Bar{"st_venant_kirchhoff", PlaneState::Stress, 1.2 * s * 8 * E / 3}})
    for (const char* name : {"q4", "q4_bbar", "q8", "t3", "t6"}) {
      CAPTURE(name, bar.law, to_string(bar.state));
      const Element& element = find_element(name);
      const Mesh mesh = block_for(element, {2, 1}, 2, 2);
      Material material{3, 0.25, bar.state, 0.5};
      material.law = find_strain_law(bar.law);
      LongNodes u = LongNodes::Zero(mesh.n_nodes(), 2);
      u.col(0) = (s - 1) * mesh.nodes.col(0).cast<long double>();
      const LongNodes force = energy_forces(mesh, element, material, u);
      double pull = 0;
      for (const Index node : boundary_nodes(mesh, "right"))
        pull += static_cast<double>(force(node, 0));
      // E and nu give lambda and mu in double, and rules have weights in double.
      CHECK(std::abs(pull - 0.5 * bar.stress) <= 1e-14 * bar.stress);
    }
}
