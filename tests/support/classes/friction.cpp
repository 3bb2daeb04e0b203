// Pairs that rub: one pair in every motion, random ones with all their solutions, a cylinder in partial slip.
#include "support/friction.hpp"

#include "addons/files/problem_file.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::VectorXd;

VectorXd one(double x) { return VectorXd::Constant(1, x); }

/// With all its solutions, tried out one by one.
Instance tried_out(std::string name, const ContactProblem& problem) {
  Instance made{std::move(name), problem};
  made.solutions = all_solutions(problem);
  if (made.solutions.empty()) made.expected = SolveStatus::Breakdown;
  return made;
}

}  // namespace

Instances friction_one_pair() {  // closed form, [LinEtAl-9] [LinEtAl-10] [LinEtAl-15] [LinEtAl-16]
  struct Case {
    const char* name;
    double gap, slip, mu, cohesion;
    ContactStatus contact_status;
    double force, friction;
  };
  Instances made;
  for (const Case& known :
       {Case{"stick", -6, -4, 0.5, 0, ContactStatus::Stick, 3, 1},
        Case{"forward", -6, 8, 0.5, 0, ContactStatus::SlipForward, 3, -1.5},
        Case{"backward", -6, -8, 0.5, 0, ContactStatus::SlipBackward, 3, 1.5},
        Case{"glued", -6, 8, 0.5, 1, ContactStatus::Stick, 3, -2},
        Case{"cohesion gives way", -6, 8, 0, 1, ContactStatus::SlipForward, 3, -1},
        Case{"smooth", -6, 8, 0, 0, ContactStatus::SlipForward, 3, 0},
        Case{"open", 1, 8, 0.5, 0, ContactStatus::Open, 0, 0}}) {
    const Matrix2d F = Eigen::Vector2d(2, 4).asDiagonal();
    Instance pair{known.name, one_pair(F, known.gap, known.slip, known.mu, known.cohesion)};
    pair.force = one(known.force);
    pair.friction = one(known.friction);
    pair.gap = one(known.gap + 2 * known.force);
    pair.contact_status = {known.contact_status};
    pair.accuracy = 1e-14;
    made.push_back(pair);
  }
  return made;
}

Instances friction_moderate() {
  Random random(21);
  Instances made;
  for (int trial = 0; trial < 200; ++trial) {
    const Index n = 1 + trial % 8;
    const ContactProblem problem = random_friction(random, n, 0.5);
    const std::string name = text("trial ", trial, ", ", n, " pairs");
    made.push_back(n <= 4 ? tried_out(name, problem) : Instance{name, problem});
  }
  return made;
}

Instances friction_strong() {  // some have several solutions
  Random random(22);
  Instances made;
  for (int trial = 0; trial < 200; ++trial) {
    const double mu = trial % 2 == 0 ? 3 : 1e4;
    made.push_back(
        tried_out(text("trial ", trial, ", mu ", mu), random_friction(random, 1 + trial % 4, mu)));
  }
  Matrix2d F;  // tests/data/generated/coulomb_one_node_nonunique.txt: three solutions
  F << 1, 2, 2, 9;
  made.push_back(tried_out("one node, mu 0.3", one_pair(F, 0.1, 3, 0.3)));
  made.push_back(tried_out("one node, mu 0.6", one_pair(F, 0.1, 3, 0.6)));
  return made;
}

Instances friction_none() {  // mu = 0: the slips are there and nothing holds them
  Random random(11);
  Instances made;
  for (int trial = 0; trial < 40; ++trial) {
    const Index n = 1 + trial % 8;
    made.push_back({text("trial ", trial, ", ", n, " pairs"), random_friction(random, n, 0)});
    made.back().friction = VectorXd::Zero(n);
  }
  return made;
}

Instances friction_of_some() {  // every second pair rubs, beginning with the first or the second
  Random random(25);
  Instances made;
  for (int trial = 0; trial < 60; ++trial) {
    const Index n = 2 + trial % 4;
    std::vector<Index> pairs;
    for (Index i = trial / 4 % 2; i < n; i += 2) pairs.push_back(i);
    made.push_back(tried_out(text("trial ", trial, ", ", n, " pairs"),
                             frictional_only(random_friction(random, n, 0.5), pairs)));
  }
  return made;
}

Instances friction_cohesion() {  // some have no solution
  Random random(23);
  Instances made;
  for (int trial = 0; trial < 150; ++trial)
    made.push_back(
        tried_out(text("trial ", trial), random_friction(random, 1 + trial % 4, 0.5, 0.3)));
  // It overlaps by 0.1 and tends to slide; at most 1 of friction force opens it by up to 0.5. Open, it
  // overlaps; closed, it would need a tensile force.
  Matrix2d F;
  F << 1, -0.5, -0.5, 1;
  made.push_back(tried_out("pulled open by its cohesion only", one_pair(F, -0.1, 3, 0, 1)));
  return made;
}

Instances friction_floating() {  // free to move both ways; some have no solution
  Random random(24);
  Instances made;
  for (int trial = 0; trial < 200; ++trial)
    made.push_back(tried_out(text("trial ", trial), random_floating(random, 1 + trial % 4, 0.5)));
  return made;
}

Instances friction_cylinder() {
  Instances made;
  for (const double part : {0.1, 0.6, 0.95}) {
    made.push_back({text("pushed by ", part, " of mu P"), cylinder(100, 0.3, part)});
    const ContactState state = find_solver("primal_dual_active_set").solve(made.back().problem, {});
    made.back().contact_status =
        state.contact_status;  // those of Cattaneo and Mindlin: solvers/test_friction_cattaneo.cpp
    made.back().force = state.force;
    made.back().friction = state.friction;
    made.back().accuracy = 1e-11;
  }
  return made;
}

Instances friction_cylinder_away() {
  Instances made = {{"pushed by a little more than mu P", cylinder(60, 0.3, 1 + 1e-9)}};
  made.back().expected = SolveStatus::Infeasible;
  return made;
}

Instances friction_siconos() {
  Instances made;
  for (const char* name : {"FrictionContactProblem00031", "FrictionContactProblem00374"})
    made.push_back(
        {name, std::get<std::vector<FiledProblem>>(read_problem(std::string(SIGNORINI_TEST_DATA) +
                                                                "/siconos_fc2d/" + name + ".dat"))
                   .front()
                   .problem});
  return made;
}

}  // namespace signorini_test
