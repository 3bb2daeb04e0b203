// Many candidates of which few close: only pairs that may close are condensed, and the answer is that of all pairs.
#include "addons/certified/working_set.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/scene.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "support/random.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr Index cells = 400;

/// A strip 200 times as long as high, of square cells; its lower side is bent upwards by a parabola.
Scene strip(double rise) {
  Scene scene;
  Body& body = scene.bodies[0];
  const double length = static_cast<double>(cells) / 2;
  body.mesh = mapped(block("strip", {0, 0}, {length, 1}, cells, 2), [=](const Vector2d& x) {
    return Vector2d(x.x(), x.y() + rise * x.x() * x.x() / (length * length) * (1 - x.y()));
  });
  body.material = {1, 0.3, PlaneState::Strain, 1};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

/// The same, with its upper side moved down.
Scene pressed(double rise, double depth) {
  Scene scene = strip(rise);
  scene.bodies[0].supports = {symmetric("left"), prescribed("top", Axis::Y, -depth)};
  return scene;
}

/// A beam that is clamped at its left, rests on a disc below its middle and is pushed down beyond it. It bends upwards on the
/// way to the disc, against a ceiling that it would leave without the disc.
Scene lever(double ceiling) {
  Scene scene = strip(0);
  scene.bodies[0].supports = {fixed("left")};
  scene.bodies[0].loads.edges.push_back({"right", 0, [](const Vector2d&) { return Vector2d(0, -1e-7); }});
  scene.contacts = {{{"bottom"}, disc({100, -51}, 50.99)},
                    {{"top"}, half_plane({0, 1 + ceiling}, {0, -1})}};
  return scene;
}

/// A strip that some pressure bends over waves, below a ceiling.
Scene random_strip(std::uint64_t seed) {
  signorini_test::Random random(seed);
  const double length = static_cast<double>(cells) / 2;
  const double wave = pi * random.whole(1, 12) / length;
  const double other = pi * random.whole(13, 40) / length;
  const double share = random.uniform(0, 0.1);
  const double height = random.uniform(1e-3, 0.1);
  const double pressure = std::pow(10.0, -random.whole(5, 11));
  const double gap = random.uniform(0, 1) * height;
  Scene scene = strip(0);
  scene.bodies[0].supports = {fixed("left")};
  if (random.whole(0, 1) == 1) scene.bodies[0].supports.push_back(fixed("right"));
  scene.bodies[0].loads.edges.push_back({"top", pressure, {}});
  const auto y = [=](double x) {
    return height * (std::cos(wave * x) + share * std::sin(other * x) - 1 - share) - gap;
  };
  const auto slope = [=](double x) {
    return height * (share * other * std::cos(other * x) - wave * std::sin(wave * x));
  };
  scene.contacts = {{{"bottom"}, profile(y, slope)},
                    {{"top"}, half_plane({0, 1 + random.uniform(0.01, 1) * height}, {0, -1})}};
  return scene;
}

/// The same with friction on all contacts.
Scene rubbed(Scene scene, double coefficient) {
  for (ContactSpec& contact : scene.contacts) contact.friction = Friction{coefficient};
  return scene;
}

/// One scene in both ways.
struct Both {
  Ledger ledger;
  Model model;
  Condensed few;
  Solution grown;  // by a working set, if it arrived
  Solution all;    // of all pairs
  explicit Both(const Scene& scene)
      : model(build(scene, ledger)),
        few(condense_as_needed(model, ledger)),
        grown(solve(model, few, ledger)),
        all(solve(model, condense(model, ledger), Ledger())) {}

  [[nodiscard]] Index pairs() const { return few.problem.free_gap.size(); }
  [[nodiscard]] Index rows() const { return model.programme.A.rows(); }
  [[nodiscard]] long long condensed() const {
    return grown.ledger.counted("condensation", "condensed pairs");
  }
  [[nodiscard]] long long closed() const { return static_cast<long long>(grown.contact.active().size()); }
  [[nodiscard]] LedgerEntry condensation() const {
    for (const LedgerEntry& entry : grown.ledger.entries())
      if (entry.path == "condensation") return entry;
    return {};
  }
  [[nodiscard]] long long refined_sets() const { return grown.ledger.counted("refinement", "sets"); }
  /// Sets that were condensed, and all pairs if they were.
  [[nodiscard]] long long rounds() const { return condensation().calls - 1; }
  /// Whether the set did not arrive.
  [[nodiscard]] bool all_condensed() const {
    return condensation().bytes >= static_cast<long long>(sizeof(double)) * rows() * rows();
  }
  void check_equal() const;
};

void Both::check_equal() const {
  REQUIRE_FALSE(is_complete(few));
  REQUIRE(grown.contact.report.status == SolveStatus::Solved);
  REQUIRE(all.contact.report.status == SolveStatus::Solved);
  CHECK(grown.certificate.holds());
  CHECK(grown.contact.active() == all.contact.active());
  CHECK(grown.contact.force == all.contact.force);
  CHECK(largest(VectorXd(grown.contact.friction - all.contact.friction)) <= epsilon * largest(all.contact.friction));
  CHECK(grown.contact.contact_status == all.contact.contact_status);
  CHECK(grown.contact.uniqueness == all.contact.uniqueness);
  if (model.law.pair.empty()) CHECK(grown.refined.force == all.refined.force);
  CHECK(largest(VectorXd(grown.refined.force - all.refined.force)) <= epsilon * largest(all.refined.force));
  // u in two parts comes from another start: where it is nothing but rounding, it is another rounding.
  CHECK(largest(VectorXd(grown.contact.gap - all.contact.gap)) <=
        epsilon * largest(all.refined.displacement));
  CHECK(grown.pressure == all.pressure);
  CHECK(largest(VectorXd(grown.refined.displacement - all.refined.displacement)) <=
        epsilon * largest(all.refined.displacement));
  CHECK(grown.notes == all.notes);
}

}  // namespace

TEST_CASE("a few pairs of many close, and few are condensed", "[working_set]") {
  const Both both(pressed(0.4, 1e-3));
  REQUIRE(both.pairs() == cells + 1);
  both.check_equal();
  CHECK_FALSE(both.all_condensed());
  CHECK(both.closed() > 5);
  CHECK(both.rounds() == 1);
  CHECK(both.condensed() < 2 * both.closed());
  CHECK(both.condensed() < 50);
}

TEST_CASE("no pair closes: nothing is condensed", "[working_set]") {
  const Both both(pressed(0.4, -1e-3));
  both.check_equal();
  CHECK(both.closed() == 0);
  CHECK_FALSE(both.all_condensed());
  CHECK(both.condensed() == 0);
  CHECK(both.grown.contact.force.isZero(0));
}

TEST_CASE("all pairs close: a few are tried, and then all are condensed", "[working_set]") {
  const Both both(pressed(0, 1e-3));
  both.check_equal();
  CHECK(both.closed() == both.pairs());
  CHECK(both.all_condensed());
  CHECK(3 * both.condensed() < both.pairs());  // of the few that are tried first
  CHECK(both.rounds() == 2);
}

TEST_CASE("pairs that touch without a force are of the set", "[working_set]") {
  // Level to the left of the middle, where it rests on the plane without overlap, and off it to the right.
  Scene scene = pressed(0, 0);
  const double middle = static_cast<double>(cells) / 4;
  scene.bodies[0].mesh = mapped(scene.bodies[0].mesh, [=](const Vector2d& x) {
    const double beyond = std::max(0.0, x.x() - middle) / middle;
    return Vector2d(x.x(), x.y() + 0.1 * beyond * (1 - x.y()));
  });
  const Both both(scene);
  both.check_equal();
  CHECK(both.condensed() >= cells / 2 + 1);  // the nodes on the plane
  CHECK(both.condensed() < both.pairs());
}

TEST_CASE("where all pairs overlap without contact forces and few will close, few are tried first", "[working_set]") {
  Scene scene = strip(0.4);
  scene.bodies[0].supports = {fixed("left")};
  scene.bodies[0].loads.edges.push_back({"top", 4e-9, {}});
  scene.contacts[0].target = half_plane({0, -1}, {0, 1});
  const Both both(scene);
  both.check_equal();
  CHECK((both.few.problem.free_gap.array() < 0).count() > both.pairs() / 2);
  CHECK(both.closed() < 20);
  CHECK(both.rounds() > 1);
  CHECK_FALSE(both.all_condensed());
  CHECK(both.condensed() < both.rounds() * both.pairs() / 3);
  CHECK(both.refined_sets() == both.rounds() - 1);  // not the first, of which every second is left out
}

TEST_CASE("pairs that close because others close come in round by round", "[working_set]") {
  for (const double ceiling : {1e-2, 1e-3, 1e-4}) {
    CAPTURE(ceiling);
    const Both both(lever(ceiling));
    REQUIRE(both.pairs() == 2 * cells);
    both.check_equal();
    // Without contact forces the beam is below the ceiling everywhere.
    CHECK(both.few.problem.free_gap.tail(cells).minCoeff() > 0);
    CHECK(both.grown.contact.active().back() >= cells);
    CHECK_FALSE(both.all_condensed());
    CHECK(both.rounds() > 1);
    CHECK(both.condensed() < both.pairs());
  }
}

TEST_CASE("a set that would take more than half of the work of all pairs is given up", "[working_set]") {
  const Both both(pressed(0.4, 0.35));
  both.check_equal();
  CHECK(both.all_condensed());
  CHECK(5 * both.closed() > 4 * both.pairs());
  CHECK(both.closed() < both.pairs());
  CHECK(3 * both.condensed() < both.pairs());  // of the few that are tried first
  CHECK(both.rounds() == 2);
}

TEST_CASE("where the method fails on the set, all pairs are condensed", "[working_set]") {
  Scene scene = pressed(0.4, 1e-3);
  scene.solver = {"all or nothing", "gives up on fewer than all pairs of the strip",
                  [](const ContactProblem& problem, const SolverOptions& options) {
                    return problem.free_gap.size() > cells ? primal_dual_active_set().solve(problem, options)
                                                           : ContactState();
                  }};
  const Both both(scene);
  both.check_equal();
  CHECK(both.all_condensed());
  CHECK(both.rounds() == 2);
}

TEST_CASE("statuses to begin with are those of the set", "[working_set]") {
  const Both both(pressed(0.4, 1e-3));
  SolverOptions options;
  options.start = both.all.contact.contact_status;
  const Solution again = solve(both.model, both.few, both.model.solver, Ledger(), options);
  CHECK(again.contact.force == both.all.contact.force);
  CHECK(again.contact.report.iterations == 1);
}

TEST_CASE("random strips over waves: the same as of all pairs", "[working_set]") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const Both both(random_strip(seed));
    both.check_equal();
    CHECK_FALSE(both.all_condensed());
  }
}

TEST_CASE("random strips with friction over waves: the same as of all pairs", "[working_set]") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const Both both(rubbed(random_strip(seed), signorini_test::Random(seed).uniform(0.1, 1)));
    both.check_equal();
    // Where no pair may close without contact forces, no set says whether there is one solution.
    CHECK(both.all_condensed() == (both.condensed() == 0));
    CHECK(both.condensed() < both.pairs());
  }
}

TEST_CASE("with friction a few pairs of all that overlap are tried, and no round but the last is refined", "[working_set]") {
  Scene scene = rubbed(strip(0.4), 0.3);
  scene.bodies[0].supports = {fixed("left")};
  scene.bodies[0].loads.edges.push_back({"top", 4e-9, {}});
  scene.contacts[0].target = half_plane({0, -1}, {0, 1});
  const Both both(scene);
  both.check_equal();
  CHECK(both.closed() > 0);
  CHECK_FALSE(both.all_condensed());
  CHECK(both.rounds() > 1);
  CHECK(both.refined_sets() == 1);
  CHECK(6 * both.condensed() < both.pairs());
}

TEST_CASE("all pairs are asked for a proof where those of the set are smooth", "[working_set]") {
  // The strip is pressed onto a smooth plane, and its upper side stays off a rough one.
  Scene scene = strip(0.4);
  scene.bodies[0].supports = {fixed("left")};
  scene.bodies[0].loads.edges.push_back({"top", 4e-9, {}});
  scene.contacts[0].target = half_plane({0, -1}, {0, 1});
  scene.contacts.push_back({{"top"}, half_plane({0, 3}, {0, -1})});
  scene.contacts.back().friction = Friction{1e-5};
  const Both both(scene);
  both.check_equal();
  CHECK(both.closed() > 0);
  CHECK(both.all_condensed());
}

TEST_CASE("statuses of a solution with friction begin a set that is refined once", "[working_set]") {
  const Both both(rubbed(pressed(0.4, 1e-3), 0.3));
  SolverOptions options;
  options.start = both.all.contact.contact_status;
  const Solution again = solve(both.model, both.few, both.model.solver, Ledger(), options);
  CHECK(again.contact.force == both.all.contact.force);
  CHECK(again.ledger.counted("refinement", "sets") == 1);
}

TEST_CASE("all pairs are condensed where friction may be shown to have one solution", "[working_set]") {
  const Both both(rubbed(pressed(0.4, 1e-3), 1e-4));
  both.check_equal();
  CHECK(both.grown.contact.uniqueness == Uniqueness::Proved);
  CHECK(both.all_condensed());
  CHECK(both.refined_sets() == 1);  // the proof is seen before the set is refined
  const Both rough(rubbed(pressed(0.4, 1e-3), 0.3));
  rough.check_equal();
  CHECK(rough.grown.contact.uniqueness == Uniqueness::Unknown);
  CHECK_FALSE(rough.all_condensed());
}

TEST_CASE("a working set is tried where the counts say that it pays, and for held bodies of one load only",
          "[working_set]") {
  const auto left_out = [](const Scene& scene) {
    Ledger ledger;
    return !is_complete(condense_as_needed(build(scene, ledger), ledger));
  };
  const Scene scene = pressed(0.4, 1e-3);
  CHECK(left_out(scene));
  CHECK(left_out(rubbed(scene, 0.2)));
  Scene other = rubbed(scene, 0.2);
  other.contacts[0].friction->cohesion = 1e-6;
  CHECK_FALSE(left_out(other));
  other = scene;
  other.bodies[0].supports = {symmetric("left")};
  other.bodies[0].loads.edges.push_back({"top", 1e-6, {}});
  CHECK_FALSE(left_out(other));
  const Plan small = plan(scene);
  CHECK(working_set_pays(small, 256, 5e6));
  CHECK_FALSE(working_set_pays(small, 255, 5e6));
  CHECK_FALSE(working_set_pays(small, 256, 6e6));
  CHECK(working_set_pays(plan(rubbed(scene, 0.2)), 256, 1.1e7));
  CHECK_FALSE(working_set_pays(plan(rubbed(scene, 0.2)), 256, 1.2e7));
}
