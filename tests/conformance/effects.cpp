// What every member of the table of effects promises: absent it is named so and costs nothing, present it has a
// line in the plan and touches its own part of the model only.
#include "signorini/scene/effects.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "support/cantilever.hpp"
#include "support/chosen.hpp"
#include "support/effect_examples.hpp"
#include "support/linear_solve.hpp"
#include "support/random_scenes.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

namespace {

using Numbers = std::vector<double>;

void append(Numbers& numbers, const Eigen::Ref<const Eigen::MatrixXd>& values) {
  for (Index k = 0; k < values.size(); ++k)
    numbers.push_back(values(k % values.rows(), k / values.rows()));
}

template <int Order>
void append(Numbers& numbers, const Eigen::SparseMatrix<double, Order>& matrix) {
  for (Index k = 0; k < matrix.outerSize(); ++k)
    for (typename Eigen::SparseMatrix<double, Order>::InnerIterator it(matrix, k); it; ++it)
      numbers.insert(numbers.end(), {double(it.row()), double(it.col()), it.value()});
  if (matrix.rows() > 0) numbers.push_back(double(matrix.rows()));
}

/// All numbers of a model but those of its bodies, by what they are.
std::map<std::string, Numbers> contents(const Model& model) {
  std::map<std::string, Numbers> all;
  append(all["K"], model.programme.stiffness);  // and so the unknowns
  append(all["p"], model.programme.load);
  append(all["A"], model.programme.A);
  append(all["g"], model.programme.initial_gap);
  append(all["pairs"], model.pairs.weight);
  append(all["pairs"], model.pairs.position);
  append(all["pairs"], model.pairs.normal);
  append(all["pairs"], model.pairs.opening);
  append(all["sliding"], model.pairs.sliding);
  all["modes"];
  for (const FreeMotion& mode : model.modes) append(all["modes"], Eigen::VectorXd(mode.shape));
  all["law"].assign(model.law.pair.begin(), model.law.pair.end());
  append(all["law"], model.law.coefficient);
  append(all["law"], model.law.cohesion);
  all["loop"];
  if (model.loop) all["loop"].push_back(1);  // functions have no numbers
  all["parts"];
  for (const LoadPart& part : model.parts) {
    append(all["parts"], part.load);
    append(all["parts"], part.movement);
  }
  return all;
}

Model built(const Scene& scene) {
  Ledger ledger;
  return build(scene, ledger);
}

/// What the models of two scenes differ in.
std::set<std::string> differences(const Scene& first, const Scene& second) {
  const std::map<std::string, Numbers> one = contents(built(first));
  std::set<std::string> names;
  for (const auto& [name, numbers] : contents(built(second)))
    if (numbers != one.at(name)) names.insert(name);
  return names;
}

bool contains(const std::vector<std::string>& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

/// Names of the effects that a plan has on.
std::vector<std::string> names_on(const Plan& plan) {
  std::vector<std::string> names;
  for (const Effect* effect : plan.effects) names.emplace_back(effect->name);
  return names;
}

}  // namespace

TEST_CASE("every effect: absent it is named as off and costs nothing, present it has its line",
          "[conformance][effects]") {
  std::set<std::string> known;
  for (const Effect& effect : chosen(effects())) {
    const std::string name = effect.name;
    CAPTURE(name);
    CHECK(known.insert(name).second);
    REQUIRE(effect_examples().count(name) == 1);  // a scene that has it
    const EffectExample& example = effect_examples().at(name);
    const Plan off = plan(example.without);
    const Plan on = plan(example.with);
    CHECK(contains(off.off, name));
    CHECK_FALSE(contains(on.off, name));
    Plan again = on;
    effect.declare(example.with, again);
    CHECK(again.on.size() > on.on.size());
    std::vector<std::string> names = names_on(on);
    names.erase(std::remove(names.begin(), names.end(), name), names.end());
    CHECK(names == names_on(off));  // and brings no other one
    CHECK(differences(example.without, example.with) == example.touched);
    const std::map<std::string, Numbers> bare = contents(built(example.without));
    const std::map<std::string, Numbers> full = contents(built(example.with));
    for (const std::string& own : example.own) {
      CAPTURE(own);
      CHECK(bare.at(own).empty());
      CHECK_FALSE(full.at(own).empty());
    }
  }
  for (const auto& example : effect_examples())
    CHECK(std::any_of(effects().begin(), effects().end(),
                      [&](const Effect& effect) { return effect.name == example.first; }));
}

TEST_CASE(
    "every effect of a random scene is either on or off, and a copy of the plan builds the same",
    "[conformance][effects]") {
  if (chosen(effects()).empty()) return;
  std::map<std::string, int> seen;
  int refused = 0;
  for (const RandomScenes kind :
       {RandomScenes::Frictionless, RandomScenes::Frictional, RandomScenes::Varied,
        RandomScenes::Revolved, RandomScenes::Paths, RandomScenes::Tied, RandomScenes::Moving})
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      CAPTURE(seed);
      Scene scene = random_scene(seed, kind).scene;
      if (seed % 4 == 0 && !scene.path) scene.path = Path{{1}, {}};
      try {
        const Plan planned = plan(scene);
        std::vector<std::string> on;
        std::vector<std::string> off;
        for (const Effect& effect : effects())
          (effect.present(scene, planned) ? on : off).emplace_back(effect.name);
        CHECK(names_on(planned) == on);
        CHECK(planned.off == off);
        for (const std::string& name : on) ++seen[name];
        Ledger ledger;
        const std::map<std::string, Numbers> first = contents(build(planned, ledger));
        CHECK(contents(build(planned, ledger)) == first);
        CHECK(contents(build(scene, ledger)) == first);
        if (!first.at("law").empty())  // empty too if supports keep all that rub from sliding
          CHECK((contains(on, "friction") || contains(on, "cohesion")));
        CHECK(first.at("modes").empty() != contains(on, "rigid motions"));
      } catch (const ProblemError&) {
        ++refused;
      }
    }
  for (const Effect& effect : chosen(effects())) {
    CAPTURE(effect.name);
    CHECK(seen[effect.name] > 0);
  }
  CHECK(refused < 150);
}

TEST_CASE("a law of friction that allows no force is no friction", "[conformance][effects]") {
  Scene none = plain_beam();
  Scene zero = none;
  zero.contacts[0].friction = Friction{0, 0};
  CHECK(differences(none, zero).empty());
  CHECK(plan(zero).on == plan(none).on);
  CHECK(plan(zero).off == plan(none).off);
  CHECK(plan(zero).solver.solve == none.solver.solve);
}

TEST_CASE("cohesion beside friction, and friction beside cohesion, take no further row",
          "[conformance][effects]") {
  Scene rough = plain_beam();
  rough.contacts[0].friction = Friction{0.3, 0};
  Scene sticky = rough;
  sticky.contacts[0].friction = Friction{0, 0.2};
  Scene both = rough;
  both.contacts[0].friction = Friction{0.3, 0.2};
  CHECK(differences(rough, both) == std::set<std::string>{"law"});
  CHECK(differences(sticky, both) == std::set<std::string>{"law"});
}

TEST_CASE("loads of two kinds add up", "[conformance][effects]") {
  const Scene& weight = effect_examples().at("body force").with;
  const Scene& pressed = effect_examples().at("edge loads").with;
  Scene both = weight;
  both.bodies[0].loads.edges = pressed.bodies[0].loads.edges;
  CHECK(built(both).programme.load == built(weight).programme.load + built(pressed).programme.load);
}

// A linear solve, refined: the comparison knows the last digits no better than the condition of K lets it.
TEST_CASE("a scene without contact is one linear solve", "[conformance][effects]") {
  Scene scene = cantilever("q4_incompatible", 12, 2);
  scene.contacts.clear();
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  const Body& body = scene.bodies[0];
  const NodeArray expected =
      solve_body(body.mesh, find_element(body.element), body.material, body.supports, body.loads);
  CHECK((solution.displacements[0] - expected).norm() <= 1e-11 * expected.norm());
  CHECK(solution.ledger.counted("assembly", "pairs") == 0);
  CHECK(solution.contact.force.size() == 0);
  CHECK(solution.contact.frictional_pairs.empty());
}
