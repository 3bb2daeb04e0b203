// The tables of solvers and of problem classes make sense, before anything is solved.
#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/chosen.hpp"
#include "support/problem_classes.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

namespace {

const Trait all_traits[] = {Trait::Ordinary,   Trait::Asymmetric, Trait::Dependent,
                            Trait::Infeasible, Trait::Degenerate, Trait::IllConditioned,
                            Trait::Slow,       Trait::Several,    Trait::Friction};

bool has_repetition(const std::vector<Trait>& traits) {
  return std::set<Trait>(traits.begin(), traits.end()).size() < traits.size();
}

}  // namespace

TEST_CASE("every trait has a word of its own", "[conformance][table]") {
  std::set<std::string> words;
  for (const Trait trait : all_traits) {
    words.insert(to_string(trait));
    CHECK(std::string(to_string(trait)) != "unknown");
  }
  CHECK(words.size() == std::size(all_traits));
}

TEST_CASE("every line of the solver table makes sense", "[conformance][table]") {
  std::set<std::string> names;
  for (const Solver& solver : all_solvers()) {
    const std::string name = solver.name;
    const std::string summary = solver.summary;
    CAPTURE(name, summary);
    CHECK(names.insert(name).second);
    CHECK(std::all_of(name.begin(), name.end(), [](unsigned char letter) {
      return std::islower(letter) != 0 || std::isdigit(letter) != 0 || letter == '_';
    }));
    CHECK(find_solver(name).solve == solver.solve);
    CHECK(summary.size() >= 10);
    CHECK(summary.size() <= 90);  // one line of a list
    CHECK((!summary.empty() && std::isupper(static_cast<unsigned char>(summary.front())) == 0));
    CHECK((!summary.empty() && summary.back() != '.'));
    CHECK(solver.solve != nullptr);
    CHECK(solver.largest >= 0);
    CHECK_FALSE(has_repetition(solver.may_fail));
  }
}

TEST_CASE("every line of the class table makes sense", "[conformance][table]") {
  std::set<std::string> names;
  for (const ProblemClass& group : problem_classes()) {
    CAPTURE(group.name);
    CHECK(names.insert(group.name).second);
    CHECK_FALSE(has_repetition(group.traits));
  }
  for (const Trait trait : all_traits) {  // no trait without a problem that has it
    CAPTURE(to_string(trait));
    CHECK(std::any_of(problem_classes().begin(), problem_classes().end(), [&](const auto& group) {
      return std::count(group.traits.begin(), group.traits.end(), trait) > 0;
    }));
  }
}

TEST_CASE("the answers of the class table fit their problems", "[conformance][table]") {
  for (const ProblemClass& group : problem_classes())
    for (const Instance& instance : group.instances()) {
      const Index n = instance.problem.free_gap.size();
      CAPTURE(group.name, instance.name);
      CHECK_NOTHROW(check_finite(instance.problem));
      CHECK((instance.force.size() == 0 || instance.force.size() == n));
      CHECK((instance.gap.size() == 0 || instance.gap.size() == n));
      if (instance.programme) {
        const Eigen::MatrixXd product = condense(*instance.programme).problem.compliance;
        CHECK((product - instance.problem.compliance).norm() <= 1e-13 * product.norm());
      }
      if (instance.force.size() == 0 || instance.gap.size() == 0 || n == 0 ||
          instance.amplitude.size() != instance.problem.rigid.cols())
        continue;
      const Eigen::VectorXd force = instance.force;
      Eigen::VectorXd all(n + instance.friction.size());
      all << force, instance.friction;
      Eigen::VectorXd gap = (instance.problem.compliance * all).head(n) + instance.problem.free_gap;
      Eigen::VectorXd size =  // row by row, so that a scaled row counts as much as any
          (instance.problem.compliance.cwiseAbs() * all.cwiseAbs()).head(n) +
          instance.problem.free_gap.cwiseAbs();
      if (instance.amplitude.size() > 0) {
        gap += (instance.problem.rigid * instance.amplitude).head(n);
        size += (instance.problem.rigid.cwiseAbs() * instance.amplitude.cwiseAbs()).head(n);
      }
      CHECK(((gap - instance.gap).array().abs() <= 1e-10 * size.array()).all());
      CHECK(force.minCoeff() >= 0);
      CHECK((gap.array() >= -1e-10 * size.array()).all());
      CHECK((force.array() * gap.array() <= 1e-10 * force.array() * size.array()).all());
    }
}

TEST_CASE("every solver: more pairs than it accepts are refused", "[conformance][table]") {
  for (const Solver& solver : chosen(solvers())) {
    const Index n = solver.largest + 1;
    CAPTURE(solver.name);
    if (solver.largest > 0)
      CHECK_THROWS_AS(
          solver.solve({Eigen::MatrixXd::Identity(n, n), Eigen::VectorXd::Constant(n, -1)}, {}),
          std::invalid_argument);
  }
}
