// What must hold for any text that is read as a problem file, however odd.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "addons/files/problem_file.hpp"
#include "addons/programme/dense_programme.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini_test {

/// Largest problem that is also solved.
constexpr Eigen::Index largest_solved = 6;

/// Every solver may refuse a problem or end without a solution, but what it calls solved is certified.
/// \return what is wrong, or empty
inline std::string check_solvers(const signorini::ContactProblem& problem) {
  using namespace signorini;
  const bool symmetric = is_symmetric(problem);
  const bool frictional = !problem.law.pair.empty();
  for (const Solver& solver : frictional ? friction_solvers() : solvers()) {
    if (!frictional && !symmetric && may_fail(solver, Trait::Asymmetric)) continue;
    try {
      const ContactState state = solver.solve(problem, {});
      if (state.report.status == SolveStatus::Solved && !certify(problem, state).holds())
        return text(solver.name, ": solved with ", certify(problem, state));
    } catch (const std::invalid_argument&) {
    } catch (const ProblemError&) {
    }
  }
  return "";
}

/// The same for a quadratic programme.
/// \return what is wrong, or empty
inline std::string check_solvers(const signorini::TwoSidedProgramme& programme) {
  using namespace signorini;
  std::optional<OneSided> form;
  try {
    form = one_sided(programme);
  } catch (const ProblemError&) {
    return "";  // not convex
  }
  for (const Solver& solver : solvers()) try {
      const DenseSolution solution = solve(form->programme, solver);
      static_cast<void>(objective(programme, solution.refined));
      static_cast<void>(multipliers(*form, solution.refined.force, programme.lower.size()));
      if (solution.report.status == SolveStatus::Solved && !solution.certificate.holds())
        return text(solver.name, ": solved with ", solution.certificate);
    } catch (const std::invalid_argument&) {
    } catch (const ProblemError&) {
    }
  return "";
}

/// Reads a text as a problem file, and solves what is small.
/// \param content  any bytes
/// \return what is wrong, or empty; a crash or an exception of another kind is wrong as well
inline std::string check_text(std::string_view content) {
  using namespace signorini;
  ProblemFile file;
  try {
    file = parse_problem(content, "name");
  } catch (const ProblemError& error) {
    const std::string message = error.what();
    const bool names_line = message.rfind("name:", 0) == 0 && message.find(": ", 5) != message.npos;
    return names_line && message.size() < 300 ? "" : "message: " + message;
  }
  if (const auto* programme = std::get_if<TwoSidedProgramme>(&file))
    return programme->q.size() + programme->lower.size() <= 2 * largest_solved
               ? check_solvers(*programme)
               : "";
  for (const FiledProblem& filed : std::get<std::vector<FiledProblem>>(file)) {
    if (filed.problem.free_gap.size() > largest_solved) continue;
    const std::string wrong = check_solvers(filed.problem);
    if (!wrong.empty()) return text("line ", filed.line, ": ", wrong);
  }
  return "";
}

}  // namespace signorini_test
