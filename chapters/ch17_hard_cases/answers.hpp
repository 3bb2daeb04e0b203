/// \file
/// Chapter 17: an exhibit posed, answered by any member of the library, and what the certificate says of a forged answer.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "exhibit.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem_file/problem_file.hpp"
#include "signorini/programme/dense_programme.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/steps_limit.hpp"
#include "signorini/scene_file/scene_file.hpp"
#include "signorini/solvers/solvers.hpp"

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
  signorini::ContactProblem small = {};                ///< of all: gaps over forces
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
  pose((exhibit.command == "qp") == std::holds_alternative<TwoSidedProgramme>(file),
       exhibit.file.string(), ": not what its command takes");
  if (exhibit.command == "qp") {
    posed.rows = std::get<TwoSidedProgramme>(file);
    posed.form = one_sided(posed.rows);
    posed.small = condense(posed.form->programme).problem;
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
  answer.message = solution.escape;
  for (const std::string& note : solution.notes) answer.message += "\n" + note;
  return answer;
}

/// Whether a member takes a problem. \param solver  a member \param problem  condensed \return whether it does
inline bool takes(const signorini::Solver& solver, const signorini::ContactProblem& problem) {
  using namespace signorini;
  const bool rubs = !problem.law.pair.empty();
  const bool asymmetric = !rubs && !is_symmetric(problem);
  return too_many(solver, problem.free_gap.size()).empty() &&
         (solver.friction != (rubs ? Takes::No : Takes::Only)) &&
         !(asymmetric && may_fail(solver, Trait::Asymmetric));
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
  if (posed.model && solver.empty()) member = &find_solver(posed.scene.solver);
  answer.asked = member != nullptr && takes(*member, posed.small);
  if (!answer.asked) return answer;
  try {
    if (posed.model)
      return answer_of(solver.empty()
                           ? solve_to_limit(posed.scene, *posed.model, *posed.condensed, {})
                           : solve(*posed.model, *posed.condensed, solver, {}));
    if (posed.form) {
      const DenseSolution solution = solve(posed.form->programme, *member);
      answer.said = to_string(solution.report.status);
      answer.certificate = solution.certificate;
      answer.contact.force = solution.refined.force;
      answer.contact.gap = solution.gap;
      answer.contact.active = solution.active;
      answer.refined = solution.refined;
      answer.unknowns = solution.refined.displacement;
      answer.objective = objective(posed.rows, solution.refined);
    } else {
      answer.contact = member->solve(posed.small, {});
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

/// A figure of an answer. \param name  such as "force sum", "largest pressure" or "gap 3" \param answer  any
/// \return the figure, not a number if the answer does not tell it \throws signorini::ProblemError for an unknown name
inline double quantity(const std::string& name, const Answer& answer) {
  const signorini::ContactState& state = answer.contact;
  const auto count = [&](auto&& is) {
    return static_cast<double>(std::count_if(state.motion.begin(), state.motion.end(), is));
  };
  if (name == "closed pairs") return static_cast<double>(state.active.size());
  if (name == "sticking pairs")
    return count([](signorini::Motion motion) { return motion == signorini::Motion::Stick; });
  if (name == "sliding pairs")
    return count([](signorini::Motion motion) { return friction_sign(motion) != 0; });
  if (name == "doubtful") return state.uniqueness == signorini::Uniqueness::Doubtful ? 1 : 0;
  if (name == "objective") return answer.objective;
  if (name == "limit") return answer.limit;
  const std::vector<std::pair<std::string, const VectorXd*>> vectors = {
      {"force", &state.force},        {"gap", &state.gap},   {"pressure", &answer.pressure},
      {"friction", &state.friction},  {"slip", &state.slip}, {"unknown", &answer.unknowns},
      {"amplitude", &state.amplitude}};
  for (const auto& [word, vector] : vectors) {
    const VectorXd& values = *vector;
    const bool known = name == word + " sum" || name == "largest " + word ||
                       name == "least " + word || name.rfind(word + " ", 0) == 0;
    if (known && values.size() == 0) return std::numeric_limits<double>::quiet_NaN();
    if (name == word + " sum") return values.sum();
    if (name == "largest " + word) return values.maxCoeff();
    if (name == "least " + word) return values.minCoeff();
    if (name.rfind(word + " ", 0) == 0) {
      const Index i = std::stol(name.substr(word.size() + 1));
      signorini::pose(i >= 0 && i < values.size(), "quantity ", name, ": there are ",
                      values.size());
      return values(i);
    }
  }
  throw signorini::ProblemError("unknown quantity '" + name + "'");
}

/// Whether an answer keeps the bounds of its exhibit, as far as it tells their quantities. \param exhibit  with bounds \param answer  claimed solution
/// \return the first bound that is broken, or nothing
inline std::string broken_bound(const Exhibit& exhibit, const Answer& answer) {
  for (const Bound& bound : exhibit.bounds) {
    const double value = quantity(bound.quantity, answer);
    const double scale = bound.value == 0 ? 1 : std::abs(bound.value);
    if (std::abs(value - bound.value) > bound.within * scale)
      return bound.quantity + " = " + signorini::shortest(value) + ", not " +
             signorini::shortest(bound.value);
  }
  return "";
}

/// Largest figure of a certificate that is accepted, as that of the command.
constexpr double accepted = 1e-12;

/// How an answer compares with what the exhibit states.
enum class Verdict {
  Solved,   ///< a solution, certified and within all bounds
  Honest,   ///< no solution is claimed, and why is said
  Refuted,  ///< a solution is claimed, and the certificate or a bound refutes it
  NotFor    ///< the method does not take such problems
};

/// \param exhibit  as stated \param answer  of any method \return the verdict
inline Verdict judge(const Exhibit& exhibit, const Answer& answer) {
  if (!answer.asked) return Verdict::NotFor;
  if (!answer.solved()) return Verdict::Honest;
  const bool right = exhibit.status == "solved" && answer.certificate.holds(accepted) &&
                     broken_bound(exhibit, answer).empty();
  return right ? Verdict::Solved : Verdict::Refuted;
}

/// What the certificate says of an answer that was made wrong: its largest force is changed by a share, or one unit of
/// force is put where there was none; or, where nothing was solved, the last numbers are called a solution.
/// \param posed   the exhibit
/// \param answer  of the library
/// \param share   of the largest force; 0 changes nothing
/// \return the certificate of the forgery
inline signorini::Certificate forged(const Posed& posed, const Answer& answer, double share) {
  using namespace signorini;
  const auto spoil = [&](VectorXd& force) {
    Index largest = 0;
    if (!answer.solved() || force.size() == 0 || share == 0) return;
    force.cwiseAbs().maxCoeff(&largest);
    force(largest) = force(largest) == 0 ? 1 : force(largest) * (1 + share);
  };
  if (!posed.model && !posed.form) {
    ContactState state = answer.contact;
    spoil(state.force);
    if (state.force.size() != posed.small.free_gap.size()) return uncertified();
    return certify(posed.small, state);
  }
  PrimalDual claim = answer.refined;
  spoil(claim.force);
  if (posed.form) {
    if (claim.displacement.size() == 0) return uncertified();
    return certify(posed.form->programme, claim);
  }
  const QuadraticProgramme& programme = posed.model->programme;
  if (claim.displacement.size() == 0) {
    claim.displacement = VectorXd::Zero(programme.load.size());
    claim.force = VectorXd::Zero(programme.A.rows());
  }
  return posed.model->law.pair.empty() ? certify(programme, claim)
                                       : certify(programme, claim, posed.model->law);
}

}  // namespace museum
