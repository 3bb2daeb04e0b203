// Where certified_solve() ends when its solver is wrong: solvers that recite answers.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "addons/certified/certified_solve.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// What the solver says, pass by pass; the last answer again and again.
struct Recital {
  std::vector<ContactState> answers;
  std::size_t next = 0;
};
Recital recital;

ContactState recite(const ContactProblem& /*problem*/, const SolverOptions& /*options*/) {
  const std::size_t now = std::min(recital.next++, recital.answers.size() - 1);
  return recital.answers[now];
}

ContactState claim(SolveStatus status, const VectorXd& force,
                   const std::vector<Eigen::Index>& active) {
  ContactState state;
  state.force = force;
  state.gap = VectorXd::Zero(force.size());
  state.contact_status = statuses_of(active, force.size());
  state.report.status = status;
  return state;
}

Solver one_by_one() { return find_solver("goldfarb_idnani"); }

/// certified_solve() for a body with K = I.
CertifiedSolution certified(const VectorXd& load, const MatrixXd& A, const VectorXd& gap,
                            std::vector<ContactState> answers,
                            const std::vector<Solver (*)()>& others = {},
                            const SolverOptions& options = {}) {
  recital = {std::move(answers)};
  const Eigen::Index n = load.size();
  const QuadraticProgramme programme{MatrixXd::Identity(n, n).sparseView(), load, A.sparseView(),
                                     gap};
  const ContactProblem problem{A * A.transpose(), gap - A * load};
  Ledger ledger;
  const Solver solver = {"recital", "says what it was told to", recite};
  return certified_solve(programme, {problem, load, [](const VectorXd& force) { return force; }},
                         {}, Solver(solver).before(others), options, ledger);
}

// {0} asks for {0, 1}, in which 0 pulls; the solution is {1}.
const MatrixXd step = (MatrixXd(2, 2) << 1, 0, 1, 1).finished();
const Eigen::Vector2d pull(1, 2);

}  // namespace

TEST_CASE("a claim that is wrong is mended, but no claim that runs in circles",
          "[certified_solve]") {
  const auto ends = [](const ContactState& state) {
    return certified(pull, step, Eigen::Vector2d::Zero(), {state});
  };
  const CertifiedSolution right = ends(claim(SolveStatus::Solved, Eigen::Vector2d(0, 0), {1}));
  CHECK(right.state.report.status == SolveStatus::Solved);
  CHECK(right.state.force == Eigen::Vector2d(0, 1.5));
  CHECK((right.state.gap - Eigen::Vector2d(0.5, 0)).norm() < 1e-30);
  const CertifiedSolution mended = ends(claim(SolveStatus::Solved, Eigen::Vector2d(-1, 2), {0, 1}));
  CHECK(mended.state.report.status == SolveStatus::Solved);
  CHECK(mended.state.active() == std::vector<Eigen::Index>{1});
  const CertifiedSolution wrong = ends(claim(SolveStatus::Solved, Eigen::Vector2d(1, 0), {0}));
  CHECK(wrong.state.report.status == SolveStatus::Breakdown);
  CHECK_FALSE(wrong.state.reason.empty());
}

TEST_CASE("what is proved of a corrected problem is not proved of the one that was posed",
          "[certified_solve]") {
  ContactState proved = claim(SolveStatus::Infeasible, Eigen::Vector2d(0, 0), {});
  proved.farkas_certificate = Eigen::Vector2d(1, 1);
  const MatrixXd walls =
      (MatrixXd(2, 2) << 1, 0, -1, 0).finished();  // closer than the body is wide
  const CertifiedSolution first = certified(pull, walls, Eigen::Vector2d(-1, -1), {proved});
  CHECK(first.state.report.status == SolveStatus::Infeasible);
  CHECK(first.state.farkas_certificate == VectorXd::Ones(2));
  const CertifiedSolution feigned = certified(pull, step, Eigen::Vector2d::Zero(), {proved});
  CHECK(feigned.state.report.status == SolveStatus::Breakdown);  // A^T y is not 0
  CHECK(feigned.state.farkas_certificate.size() == 0);
  const CertifiedSolution second =
      certified(pull, step, Eigen::Vector2d::Zero(),
                {claim(SolveStatus::Solved, Eigen::Vector2d(1, 0), {0}), proved});
  CHECK(second.state.report.status == SolveStatus::Breakdown);
  CHECK(second.state.farkas_certificate.size() == 0);
  ContactState escaped = claim(SolveStatus::Infeasible, Eigen::Vector2d(0, 0), {});
  escaped.unbounded_direction = VectorXd::Ones(1);
  const CertifiedSolution third =
      certified(pull, step, Eigen::Vector2d::Zero(),
                {claim(SolveStatus::Solved, Eigen::Vector2d(1, 0), {0}), escaped});
  CHECK(third.state.report.status == SolveStatus::Breakdown);
  CHECK(third.state.unbounded_direction.size() == 0);
}

TEST_CASE("where a method breaks down the first of the others that arrives has the word",
          "[certified_solve]") {
  ContactState lost = claim(SolveStatus::Breakdown, Eigen::Vector2d::Zero(), {});
  lost.unbounded_direction = VectorXd::Ones(1);  // is not refined
  const auto ends = [&](const std::vector<Solver (*)()>& others, Eigen::Index limit = 0) {
    SolverOptions options;
    options.iteration_limit = limit;
    return certified(pull, step, Eigen::Vector2d::Zero(), {lost}, others, options);
  };
  CHECK(ends({}).state.report.status == SolveStatus::Breakdown);
  const CertifiedSolution end = ends({one_by_one, lemke});
  CHECK(end.state.report.status == SolveStatus::Solved);
  CHECK(end.state.active() == std::vector<Eigen::Index>{1});
  CHECK(end.certificate.holds());
  // Who limits the iterations of a method wants that method.
  CHECK(ends({one_by_one}, 100).state.report.status == SolveStatus::Breakdown);
}

TEST_CASE("pairs whose set was never confirmed are named by their numbers", "[certified_solve]") {
  // The second pair repeats the first but is 0.5 wider: both cannot close, and it carries nothing.
  const CertifiedSolution end =
      certified(VectorXd::Ones(1), MatrixXd::Ones(2, 1), Eigen::Vector2d(0, 0.5),
                {claim(SolveStatus::Solved, Eigen::Vector2d(1, 0), {0, 1})});
  CHECK(end.state.report.status == SolveStatus::Solved);
  CHECK(end.state.force == Eigen::Vector2d(1, 0));
  CHECK(end.state.gap == Eigen::Vector2d(0, 0.5));
  CHECK(end.state.active() == std::vector<Eigen::Index>{0});
}

TEST_CASE("where a claim that is not solved has moved the body is not believed",
          "[certified_solve][floating]") {
  // A point that rubs on the ground with mu = 0, so that nothing holds it along; grounded by K = I.
  const MatrixXd modes = MatrixXd::Identity(2, 2);
  const VectorXd load = Eigen::Vector2d(0, -1);
  const MatrixXd A = (MatrixXd(2, 2) << 0, -1, -1, 0).finished();
  const QuadraticProgramme programme{Eigen::SparseMatrix<double>(2, 2), load, A.sparseView(),
                                     Eigen::Vector2d::Zero()};
  ContactProblem problem{MatrixXd::Identity(2, 2), -VectorXd::Ones(1), VectorXd::Zero(1),
                         law_of_all(VectorXd::Zero(1), VectorXd::Zero(1))};
  add_rigid_modes(programme, modes, problem);
  const auto along = [&](SolveStatus status) {
    ContactState state = claim(status, VectorXd::Ones(1), {0});
    state.frictional_pairs = {0};
    state.contact_status = {ContactStatus::SlipForward};
    state.friction = VectorXd::Zero(1);
    state.slip = VectorXd::Constant(1, 0.25);
    state.amplitude = Eigen::Vector2d(0.25, 0);
    recital = {{state}};
    const Solver solver = {"recital", "says what it was told to", recite};
    Ledger ledger;
    const CertifiedSolution end =
        certified_solve(programme, {problem, load, [](const VectorXd& force) { return force; }},
                        modes, Solver(solver).with_friction(Takes::Also), {}, ledger);
    CHECK(end.state.report.status == SolveStatus::Solved);
    CHECK(end.state.force(0) == 1);
    CHECK(end.state.slip(0) == end.solution.displacement(0));
    return end.solution.displacement(0);
  };
  CHECK(along(SolveStatus::Solved) == 0.25);
  CHECK(std::abs(along(SolveStatus::IterationLimit)) < 1e-15);  // rounding of the load along it
}

TEST_CASE("a method that breaks down without a word still has a reason in the end",
          "[certified_solve]") {
  const CertifiedSolution end =
      certified(pull, step, Eigen::Vector2d::Zero(),
                {claim(SolveStatus::Breakdown, Eigen::Vector2d::Zero(), {0, 1})});
  REQUIRE(end.state.report.status != SolveStatus::Infeasible);
  CHECK((end.state.report.status == SolveStatus::Solved) == end.state.reason.empty());
  ContactState nothing = claim(SolveStatus::Breakdown, Eigen::Vector2d::Zero(), {});
  nothing.force.resize(0);  // no numbers to go on with
  const CertifiedSolution without = certified(pull, step, Eigen::Vector2d::Zero(), {nothing});
  CHECK(without.state.report.status == SolveStatus::Breakdown);
  CHECK_FALSE(without.state.reason.empty());
}

TEST_CASE("after a method that breaks down none is asked that takes no friction where there is some",
          "[certified_solve]") {
  // A spring in each direction, pressed by 1 and dragged by 0.2: it sticks.
  const VectorXd load = (VectorXd(2) << 1, 0.2).finished();
  const QuadraticProgramme programme{MatrixXd::Identity(2, 2).sparseView(), load,
                                     MatrixXd::Identity(2, 2).sparseView(), VectorXd::Zero(2)};
  ContactProblem problem{MatrixXd::Identity(2, 2), -load.head(1), -load.tail(1)};
  problem.law = law_of_all(VectorXd::Constant(1, 0.5), VectorXd::Zero(1));
  // A proof that proves nothing.
  recital = {{claim(SolveStatus::Infeasible, VectorXd::Zero(1), {})}};
  recital.answers[0].farkas_certificate = VectorXd::Ones(1);
  const auto end = [&](const std::vector<Solver (*)()>& others) {
    recital.next = 0;
    Ledger ledger;
    const Solver solver = {"recital", "says what it was told to", recite};
    return certified_solve(programme,
                           {problem, load, [](const VectorXd& force) { return force; }}, {},
                           Solver(solver).with_friction(Takes::Also).before(others), {}, ledger);
  };
  CHECK(end({quasi_active_set}).state.report.status != SolveStatus::Solved);
  const CertifiedSolution solved = end({quasi_active_set, lemke});
  CHECK(solved.state.report.status == SolveStatus::Solved);
  CHECK((solved.solution.force - load).norm() <= 1e-15);
}
