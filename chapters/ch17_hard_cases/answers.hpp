/// \file
/// Chapter 17: an exhibit posed, and answered by any member of the library.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "addons/certified/solve_with_proofs.hpp"
#include "addons/files/problem_file.hpp"
#include "addons/files/scene_file.hpp"
#include "addons/programme/dense_programme.hpp"
#include "addons/steps/steps_limit.hpp"
#include "exhibit.hpp"
#include "papers/solver_table.hpp"
#include "signorini/scene/bodies.hpp"

namespace museum {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What somebody says about an exhibit.
struct Answer {
  bool asked = true;    ///< whether the method takes such a problem
  std::string said;     ///< "refused", or a status in words
  std::string message;  ///< of a refusal, or notes
  signorini::Certificate certificate = signorini::uncertified();  ///< from the posed data
  signorini::ContactState contact = {};                           ///< forces, gaps, slips
  VectorXd pressure = {};                                         ///< of a scene
  VectorXd unknowns = {};                                         ///< displacements or x
  double objective = std::numeric_limits<double>::quiet_NaN();    ///< of a quadratic programme
  double limit = std::numeric_limits<double>::quiet_NaN();  ///< share of the load that can be held
  signorini::PrimalDual refined = {};                       ///< of a scene or a quadratic programme
  /// \return whether a solution is claimed
  [[nodiscard]] bool solved() const { return said == "solved"; }
};

/// A scene built and condensed, or a problem read.
struct Posed {
  signorini::Scene scene = {};                         ///< of `solve`
  std::optional<signorini::Model> model = {};          ///< of `solve`
  std::optional<signorini::Condensed> condensed = {};  ///< of `solve`
  signorini::TwoSidedProgramme rows = {};              ///< of `qp`
  std::optional<signorini::OneSided> form = {};        ///< of `qp`
  /// Of all: gaps over forces; empty for a programme whose P is not definite
  signorini::ContactProblem small = {};
};

/// An exhibit, posed unless that was refused.
struct Case {
  Exhibit exhibit;             ///< with its statements
  std::optional<Posed> posed;  ///< nothing if refused
  std::string refusal;         ///< message
};

/// Poses what a text says. \param content  of an exhibit \param exhibit  whose command and folder it has
/// \return what solvers need \throws signorini::ProblemError if it is refused
inline Posed pose_text(const std::string& content, const Exhibit& exhibit) {
  using namespace signorini;
  Posed posed;
  if (exhibit.command == "solve") {
    const SceneFile file = parse_scene(content, exhibit.file.string(), exhibit.file.parent_path());
    posed.scene = file.scene;
    Ledger ledger;
    at_file(file, [&] {
      posed.model = build(plan(file.scene), ledger);
      posed.condensed = condense(*posed.model, ledger);
    });
    posed.small = posed.condensed->problem;
    return posed;
  }
  const ProblemFile file = parse_problem(content, exhibit.file.string());
  require_input((exhibit.command == "qp") == std::holds_alternative<TwoSidedProgramme>(file),
                exhibit.file.string(), ": not what its command takes");
  if (exhibit.command == "qp") {
    posed.rows = std::get<TwoSidedProgramme>(file);
    posed.form = one_sided(posed.rows);
    try {
      posed.small = condense(posed.form->programme).problem;
    } catch (const NotDefinite&) {  // the library may have a way that begins elsewhere
    }
  } else {
    posed.small = std::get<std::vector<FiledProblem>>(file).front().problem;
  }
  return posed;
}

/// \param exhibit  any \return the exhibit, posed if it can be
inline Case open(const Exhibit& exhibit) {
  try {
    return {exhibit, pose_text(exhibit.content, exhibit), ""};
  } catch (const signorini::ProblemError& error) {
    return {exhibit, std::nullopt, error.what()};
  }
}

/// The answer of a scene. \param solution  any \return its numbers
inline Answer answer_of(const signorini::Solution& solution) {
  Answer answer;
  answer.said = to_string(solution.contact.report.status);
  answer.certificate = solution.certificate;
  answer.contact = solution.contact;
  answer.pressure = solution.pressure;
  answer.refined = solution.refined;
  answer.unknowns = solution.refined.displacement;
  answer.limit = solution.limit.value_or(1);
  answer.message = solution.unbounded_direction;
  for (const std::string& note : solution.notes) answer.message += "\n" + note;
  return answer;
}

/// The answer of a member of the family; as the command `signorini` asks it.
/// \param posed   the exhibit
/// \param solver  name, or empty for that of the scene or the first that takes the problem
/// \return the answer; not `asked` if it does not take such problems
inline Answer answer(const Posed& posed, const std::string& solver = "") {
  using namespace signorini;
  Answer answer;
  const auto& family = posed.small.law.pair.empty() ? solvers() : friction_solvers();
  const Solver* member = solver.empty() ? nullptr : &find_solver(solver);
  for (const Solver& each : family)
    if (member == nullptr && takes(each, posed.small)) member = &each;
  if (posed.model && solver.empty()) member = &posed.scene.solver;
  answer.asked = member != nullptr && takes(*member, posed.small);
  if (!answer.asked) return answer;
  try {
    if (posed.model)
      return answer_of(solver.empty()
                           ? solve_to_limit(posed.scene, *posed.model, *posed.condensed, {})
                           : solve(*posed.model, *posed.condensed, *member, {}));
    if (posed.form) {
      const DenseSolution solution = solve(posed.form->programme, *member);
      answer.said = to_string(solution.report.status);
      answer.certificate = solution.certificate;
      answer.contact.force = solution.refined.force;
      answer.contact.gap = solution.gap;
      answer.contact.contact_status = statuses_of(solution.active, solution.gap.size());
      answer.contact.farkas_certificate = solution.farkas_certificate;
      answer.refined = solution.refined;
      answer.unknowns = solution.refined.displacement;
      answer.objective = objective(posed.rows, solution.refined);
    } else {
      answer.contact = solve_with_proofs(posed.small, *member);
      answer.said = to_string(answer.contact.report.status);
      answer.certificate = certify(posed.small, answer.contact);
    }
  } catch (const std::exception& error) {  // as the command, which names the matrix and goes on
    answer.said = "refused";
    answer.message = error.what();
  }
  return answer;
}

/// What the library says of an exhibit. \param given  opened \return its answer, or the refusal
inline Answer ours(const Case& given) {
  if (given.posed) return answer(*given.posed);
  Answer refused;
  refused.said = "refused";
  refused.message = given.refusal;
  return refused;
}

}  // namespace museum
