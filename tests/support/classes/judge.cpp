// What may a solver say, and is it true?
#include <algorithm>
#include <functional>
#include <stdexcept>
#include <tuple>

#include "addons/certified/solve_with_proofs.hpp"
#include "addons/programme/dense_programme.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/portfolio.hpp"
#include "support/classes/checks.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

/// Judges how a solver ended; `must` if no trait excuses a failure.
/// \param proof     what is wrong with its proof that nothing solves the problem
/// \param solved    what is wrong with it as a solution
/// \param feasible  what is wrong with it as a point that satisfies all but the least energy
std::string judge(const Instance& instance, const Report& report, bool must,
                  const std::function<std::string()>& proof,
                  const std::function<std::string()>& solved,
                  const std::function<std::string()>& feasible) {
  switch (report.status) {
    case SolveStatus::Solved:
      return instance.expected != SolveStatus::Solved ? "says solved, but nothing solves this"
                                                      : solved();
    case SolveStatus::Infeasible:
      if (instance.expected == SolveStatus::Solved)
        return "says infeasible, but there is a solution";
      return proof();
    case SolveStatus::Feasible:
      if (instance.expected == SolveStatus::Infeasible) return "says feasible, but nothing is";
      if (!must) return feasible();
      break;
    case SolveStatus::Ray:
    case SolveStatus::Jump:
    case SolveStatus::IterationLimit:
    case SolveStatus::Breakdown:
    case SolveStatus::SlidTooFar:
    case SolveStatus::TurnedTooFar:
      if (!must || instance.expected == SolveStatus::Breakdown ||
          (report.status == SolveStatus::Ray && instance.may_be_ray))
        return {};
  }
  return text("ends with '", to_string(report.status), "' instead of '",
              to_string(instance.expected), "' after ", report.iterations, " iterations");
}

std::string judge(const Instance& instance, const ContactState& state, bool must) {
  const auto proof = [&]() -> std::string {
    if (state.farkas_certificate.size() > 0)
      return check_farkas(instance.problem, state.farkas_certificate);
    if (state.unbounded_direction.size() > 0)
      return check_unbounded_direction(instance.problem, state.unbounded_direction);
    return "says infeasible, but proves nothing";
  };
  return judge(
      instance, state.report, must, proof, [&] { return check_solved(instance, state); },
      [&] { return check_feasible(certify(instance.problem, state)); });
}

std::string judge(const Instance& instance, const DenseSolution& solution, bool must) {
  const auto certificate = [&] { return certify(*instance.programme, solution.refined); };
  const auto proof = [&]() -> std::string {  // with equations it has rows that G does not have
    if (instance.programme->equations > 0 || solution.farkas_certificate.size() == 0) return {};
    return check_farkas(instance.problem, solution.farkas_certificate);
  };
  return judge(
      instance, solution.report, must, proof,
      [&] {
        const double error = certificate().worst();
        return error <= certificate_tolerance
                   ? differs("displacement", solution.refined.displacement, instance.displacement,
                             1, instance.accuracy)
                   : text("says solved, but its certificate is ", error);
      },
      [&] {
        Certificate found = certificate();  // forces of equations come with solutions only
        if (instance.programme->equations > 0) found.equilibrium = 0;
        return check_feasible(found);
      });
}

std::string prefixed(const char* form, const std::string& wrong) {
  return wrong.empty() ? wrong : form + wrong;
}

bool excused(const Solver& solver, const std::vector<Trait>& traits) {
  return std::any_of(traits.begin(), traits.end(),
                     [&](Trait trait) { return may_fail(solver, trait); });
}

}  // namespace

bool takes_part(const Solver& solver, const Instance& instance) {
  const Index n = instance.problem.free_gap.size();
  const bool frictional = !instance.problem.law.pair.empty();
  if (solver.friction == (frictional ? Takes::No : Takes::Only)) return false;
  if (solver.largest > 0 && n > solver.largest) return false;
  return n <= large || !may_fail(solver, Trait::Slow);
}

std::string complaint(const Solver& solver, const std::vector<Trait>& traits,
                      const Instance& instance) try {
  if (may_fail(solver, Trait::Asymmetric) && !is_symmetric(instance.problem)) try {
      static_cast<void>(solver.solve(instance.problem, {}));
      return "does not refuse a matrix that is not symmetric";
    } catch (const std::invalid_argument&) {
      return {};
    }
  const bool must = !excused(solver, traits);
  // Without proofs it may give up on what nothing solves, but be wrong about nothing. Proofs speak before or behind the methods
  // where bodies float or pairs have friction; elsewhere these are the same.
  std::string wrong;
  if (instance.problem.resultant.size() > 0 || !instance.problem.law.pair.empty())
    wrong = judge(instance, solve(instance.problem, solver), false);
  if (wrong.empty()) wrong = judge(instance, solve_with_proofs(instance.problem, solver), must);
  if (wrong.empty() && instance.programme)
    wrong = prefixed("K, p, A, g: ", judge(instance, solve(*instance.programme, solver), must));
  return wrong;
} catch (const std::exception& error) {
  return text("throws: ", error.what());
}

std::string complaints(const Solver& solver) {
  struct Complaint {
    bool honest;  // says that it has no solution
    Index pairs;
    std::string line;
    bool operator<(const Complaint& other) const {
      return std::tie(honest, pairs) < std::tie(other.honest, other.pairs);
    }
  };
  std::vector<Complaint> worst;  // one of each class
  std::size_t all = 0;
  for (const ProblemClass& group : problem_classes()) {
    std::vector<Complaint> of_class;
    for (const Instance& instance : group.instances()) {
      if (!takes_part(solver, instance)) continue;
      const std::string wrong = complaint(solver, group.traits, instance);
      if (wrong.empty()) continue;
      of_class.push_back(
          {wrong.find("ends with '") != std::string::npos, instance.problem.free_gap.size(),
           text(solver.name, ", class '", group.name, "', ", instance.name, ": ", wrong, '\n')});
    }
    all += of_class.size();
    if (!of_class.empty()) worst.push_back(*std::min_element(of_class.begin(), of_class.end()));
  }
  std::stable_sort(worst.begin(), worst.end());
  const std::size_t shown = std::min(worst.size(), most_complaints);
  std::string lines;
  for (std::size_t k = 0; k < shown; ++k) lines += worst[k].line;
  if (all > shown)
    lines += text("and ", all - shown, " more, in ", worst.size(), " classes in all\n");
  return lines;
}

}  // namespace signorini_test
