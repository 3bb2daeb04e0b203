#include <algorithm>

#include "addons/estimate/dual.hpp"
#include "catch_compat.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"
#include "support/effectivity.hpp"
#include "support/lining_rings.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// J - p^T z - g_C^T mu, less what held nodes say directly, over the size of the terms.
double defect(const SolvedScene& run, const Goal& goal) {
  Ledger ledger;
  const GoalGradient change = gradient(run.model, run.solution, goal);
  const DualSolution dual = Dual(run.model, run.condensed, run.solution).solve(change, ledger);
  CHECK(ledger.counted("outside", "solves") <= 2);
  const QuadraticProgramme& programme = run.model.programme;
  const VectorXd z = dual.displacement + dual.rigid;
  double J = 0;
  if (change.displacement.size() > 0)
    J += change.displacement.dot(run.solution.refined.displacement);
  if (change.force.size() > 0) J += change.force.dot(run.solution.refined.force);
  const double sum = programme.load.dot(z) + programme.initial_gap.dot(dual.force);
  const double size = programme.load.cwiseAbs().dot(z.cwiseAbs()) +
                      programme.initial_gap.cwiseAbs().dot(dual.force.cwiseAbs());
  return std::abs(J - sum) / size;
}

}  // namespace

TEST_CASE("a goal is a sum over the data: J = p^T z + g_C^T mu", "[dual][closed-form]") {
  const Measured problem = GENERATE(measured_cantilever(), measured_hertz(), measured_push(),
                                    measured_footing(), measured_pin());
  const char* element = GENERATE("q4_incompatible", "t6");
  CAPTURE(problem.name, element);
  const SolvedScene run = solved(problem.scene(element, 18), problem.name);
  for (const Goal& goal : problem.goals) {
    CAPTURE(goal.name);
    // A width is no sum, but does not change when all forces grow: its derivative along them vanishes.
    CHECK(defect(run, goal) <= 1e-12);
  }
}

TEST_CASE("with friction it is the same sum, whether pairs stick or slide", "[dual][closed-form]") {
  const Measured problem = GENERATE(measured_cantilever(), measured_pin(), measured_footing());
  const double friction = GENERATE(0.02, 10.0);
  CAPTURE(problem.name, friction);
  Scene scene = problem.scene("q4", 20);
  scene.contacts[0].friction = Friction{friction};
  const SolvedScene run = solved(scene, "with friction");
  const Dual dual(run.model, run.condensed, run.solution);
  CHECK(dual.slides() == (friction < 1 || problem.name == "pin"));  // it slides at any friction
  for (const Goal& goal : problem.goals) {
    CAPTURE(goal.name);
    CHECK(defect(run, goal) <= 1e-12);
  }
}

TEST_CASE("what pairs would do if the contact ended elsewhere is what the closed set says",
          "[dual]") {
  const Measured problem = GENERATE(measured_cantilever(), measured_hertz());
  CAPTURE(problem.name);
  const SolvedScene run = solved(problem.scene("q4", 16), problem.name);
  const Dual dual(run.model, run.condensed, run.solution);
  const std::vector<Index>& active = run.solution.contact.active();
  const Index pairs = run.solution.contact.gap.size();
  Index open = 0;
  while (std::binary_search(active.begin(), active.end(), open)) ++open;
  const ScaledProblem scaled = equilibrate(run.condensed.problem);
  const auto closed_as = [&](std::vector<Index> set) {
    std::sort(set.begin(), set.end());
    return solve_active_set(scaled, statuses_of(set, pairs));
  };
  std::vector<Index> more = active, fewer = active;
  more.push_back(open);
  fewer.erase(fewer.begin());
  const double force = closed_as(more).force(open) * scaled.scale(open);
  CHECK(force < 0);
  CHECK(dual.force_to_close(open) == Approx(force).epsilon(1e-8));
  const double gap = closed_as(fewer).movement(active.front()) / scaled.scale(active.front());
  CHECK(gap < 0);
  CHECK(dual.gap_without(active.front()) == Approx(gap).epsilon(1e-8));
}

TEST_CASE("goals say what they miss", "[goal]") {
  const SolvedScene run = solved(measured_cantilever().scene("q4", 20), "cantilever");
  const auto said = [&](const auto& quantity) {
    return problem_message([&] { (void)value(run.model, run.solution, {"mine", quantity}); });
  };
  CHECK_THAT(said(NormalForce{"beam.top on half plane"}),
             ContainsSubstring("beam.bottom on half plane"));
  CHECK_THAT(said(Displacement{}),
             ContainsSubstring("goal 'mine'") && ContainsSubstring("not none"));
  CHECK_THAT(said(Displacement{"", Axis::Y, "top", {{50, 5}}}), ContainsSubstring("not both"));
  CHECK_THAT(said(Displacement{"", Axis::Y, "", {{1, 1}}}), ContainsSubstring("nearest"));
  // The pressure of the beam is highest at one end and lowest in the middle: no ellipse about its support.
  CHECK_THAT(said(PeakPressure{"", {0, 0}}), ContainsSubstring("goal 'mine': Hertz fit"));
}

TEST_CASE("the force of a contact is its resultant, with friction and round a curve",
          "[goal][closed-form]") {
  const auto of = [](const SolvedScene& run) {
    return value(run.model, run.solution, {"mine", ContactForce{}});
  };
  // A sector of rings: its supports along the axes and the contact hold the inner ring under its pressure.
  const SolvedScene quarter = solved(lining_rings(9, 5), "quarter");
  const Resultants sum = resultants(quarter.model, quarter.solution);
  CHECK(of(quarter) == Approx(sum.force.norm()).epsilon(1e-13));
  CHECK(of(quarter) < 0.95 * sum.normal_force);
  CHECK(defect(quarter, {"mine", ContactForce{}}) <= 1e-12);
  // A beam that slides along its support: friction is part of the resultant.
  Scene scene = measured_cantilever().scene("q4", 20);
  scene.contacts[0].friction = Friction{0.02};
  const SolvedScene rubbed = solved(scene, "with friction");
  const ContactState& contact = rubbed.solution.contact;
  CHECK(contact.friction.sum() != 0);
  CHECK(of(rubbed) ==
        Approx(std::hypot(contact.force.sum(), contact.friction.sum())).epsilon(1e-13));
  CHECK(defect(rubbed, {"mine", ContactForce{}}) <= 1e-12);
}

TEST_CASE("a contact whose forces balance each other is asked for its normal force", "[goal]") {
  SolvedScene run = solved(measured_cantilever().scene("q4", 20), "cantilever");
  const Index pairs = run.solution.contact.force.size();
  run.solution.contact.force.setOnes();
  for (Index pair = 0; pair < pairs; ++pair)
    run.model.pairs.normal.row(pair) *= pair < pairs / 2 ? 1 : -1;
  if (pairs % 2 == 1) run.solution.contact.force(0) = 2;
  CHECK_THAT(problem_message([&] {
               (void)value(run.model, run.solution, {"mine", ContactForce{}});
             }),
             ContainsSubstring("goal 'mine'") && ContainsSubstring("normal_force"));
}

TEST_CASE("goals read what they are named for", "[goal][closed-form]") {
  const SolvedScene run = solved(measured_cantilever().scene("q4", 20), "cantilever");
  const auto read = [&](const auto& quantity) {
    return value(run.model, run.solution, {"mine", quantity});
  };
  const double force = read(NormalForce{});
  CHECK(force == Approx(run.solution.contact.force.sum()).epsilon(1e-14));
  CHECK(read(NormalForce{run.model.contacts[0], [](const Eigen::Vector2d&) { return 0.5; }}) ==
        Approx(force / 2).epsilon(1e-14));
  CHECK(read(ContactForce{}) == Approx(force).epsilon(1e-14));  // along a straight side
  // The mean over a side is that of its nodes with half the weight at its ends.
  const Mesh& mesh = run.model.bodies[0].mesh;
  double mean = 0;
  for (Index k = 0; k < mesh.n_nodes(); ++k)
    if (mesh.nodes(k, 0) == 50)
      mean += run.solution.displacements[0](k, 1) *
              (mesh.nodes(k, 1) == 0 || mesh.nodes(k, 1) == 5 ? 0.5 : 1);
  CHECK(read(Displacement{"", Axis::Y, "right"}) == Approx(mean / 3).epsilon(1e-13));
  const double between = read(Displacement{"", Axis::Y, "", {{50, 5.0 / 6}}});
  CHECK(between == Approx((read(Displacement{"", Axis::Y, "", {{50, 0}}}) +
                           read(Displacement{"", Axis::Y, "", {{50, 5.0 / 3}}})) /
                          2)
                       .epsilon(1e-13));
}

TEST_CASE("the change of a peak and of a width with the forces is that of central differences",
          "[goal][derivative]") {
  const SolvedScene run = solved(measured_hertz().scene(GENERATE("q4", "q8"), 12), "Hertz");
  const Goal goal = measured_hertz().goals[GENERATE(std::size_t{0}, std::size_t{1})];
  CAPTURE(goal.name);
  const VectorXd change = gradient(run.model, run.solution, goal).force;
  const double step = 1e-5 * run.solution.contact.force.maxCoeff();
  for (const Index pair : run.solution.contact.active()) {
    Solution out = run.solution, in = run.solution;
    out.contact.force(pair) += step;
    in.contact.force(pair) -= step;
    const double difference =
        (value(run.model, out, goal) - value(run.model, in, goal)) / (2 * step);
    CHECK(change(pair) ==
          Approx(difference).epsilon(1e-5).margin(1e-7 * change.cwiseAbs().maxCoeff()));
  }
}
