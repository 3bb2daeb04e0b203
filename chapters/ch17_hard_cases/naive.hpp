/// \file
/// Chapter 17: what methods without safeguards make of an exhibit, to see where they fail.
#pragma once
#include <string>

#include "naive_methods.hpp"
#include "papers/solver_table.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/portfolio.hpp"
#include "verdicts.hpp"

namespace museum {

/// A state as the answer of an exhibit. \param posed  the exhibit \param state  claimed
/// \return the answer, certified from the condensed data
inline Answer claimed(const Posed& posed, const ContactState& state) {
  Answer answer;
  answer.said = to_string(state.report.status);
  answer.contact = state;
  if (posed.model && state.force.size() > 0)
    answer.pressure = state.force.cwiseQuotient(posed.model->pairs.weight);
  if (state.gap.size() == posed.small.free_gap.size())
    answer.certificate = certify(posed.small, state);
  return answer;
}

/// The forces of a sound method, and displacements once forwards and backwards through a factor, in plain doubles.
/// \param posed      a scene
/// \param condensed  from K, or from something near it
/// \return the answer, certified from K, p, A and g
inline Answer unrefined(const Posed& posed, const signorini::Condensed& condensed) {
  const signorini::Model& model = *posed.model;
  ContactState state = signorini::solve(condensed.problem, posed.scene.solver);
  Answer answer;
  answer.said = to_string(state.report.status);
  if (!answer.solved()) return answer;
  VectorXd all(state.force.size() + state.friction.size());
  all << state.force, state.friction;
  answer.refined.force = all;
  answer.refined.displacement =
      condensed.factor.solve(model.programme.load - model.programme.A.transpose() * all);
  if (condensed.problem.rigid.cols() > 0) {
    answer.refined.rigid = mode_shapes(model.modes) * state.amplitude;
    answer.refined.displacement += answer.refined.rigid;
  }
  answer.certificate = model.law.pair.empty() ? certify(model.programme, answer.refined)
                                              : certify(model.programme, answer.refined, model.law);
  answer.unknowns = answer.refined.displacement;
  answer.pressure = state.force.cwiseQuotient(model.pairs.weight);
  answer.contact = std::move(state);
  return answer;
}

/// The same of a quadratic programme without equations. \param posed  the programme
/// \return the answer, certified from P, q and the rows
inline Answer unrefined(const Posed& posed) {
  const signorini::DenseProgramme& programme = posed.form->programme;
  Answer answer =
      claimed(posed, signorini::find_solver("primal_dual_active_set").solve(posed.small, {}));
  if (!answer.solved()) return answer;
  const VectorXd& force = answer.contact.force;
  const VectorXd x =
      condense(programme).factor.solve(programme.load - programme.A.transpose() * force);
  answer.certificate = certify(programme, {x, {}, force});
  answer.unknowns = x;
  answer.objective = x.dot(posed.rows.P * x) / 2 + posed.rows.q.dot(x) + posed.rows.r;
  return answer;
}

/// Bodies that only contact holds, held by soft springs everywhere: 1e-9 of the largest stiffness.
/// \param posed  a scene that has such bodies \return its answer
inline Answer soft_springs(const Posed& posed) {
  signorini::Model held = *posed.model;
  Eigen::SparseMatrix<double>& stiffness = held.programme.stiffness;
  stiffness.diagonal().array() += 1e-9 * stiffness.diagonal().maxCoeff();
  held.modes.clear();
  signorini::Ledger ledger;
  return unrefined(posed, condense(held, ledger));
}

/// The portfolio with one refinement, without what the add-on certified knows besides.
/// \param posed  the exhibit \return the answer; not `asked` for programmes, which stand in that add-on
inline Answer small_library(const Posed& posed) {
  using namespace signorini;
  if (posed.model)
    return answer_of(solve_plainly(*posed.model, *posed.condensed, posed.scene.solver, {}, {}));
  Answer answer;
  answer.asked = !posed.form;
  const bool frictional = !posed.small.law.pair.empty();
  const bool general = !frictional && !is_symmetric(posed.small);
  try {
    if (answer.asked)
      answer = claimed(posed, solve(posed.small, general ? lemke() : primal_dual_active_set()));
  } catch (const std::invalid_argument& error) {
    answer.said = "refused";
    answer.message = error.what();
  }
  return answer;
}

/// \param message  of a refusal \return the line of the file that it names as `:NUMBER:`, 0 if it names none
inline int named_line(const std::string& message) {
  for (std::size_t at = message.find(':'); at != std::string::npos;
       at = message.find(':', at + 1)) {
    const std::size_t end = message.find_first_not_of("0123456789", at + 1);
    if (end != std::string::npos && end > at + 1 && message[end] == ':')
      return std::stoi(message.substr(at + 1, end - at - 1));
  }
  return 0;
}

/// A reader that goes on without the lines it cannot use. \param exhibit  a file that is refused
/// \return what the library makes of the rest
inline Answer lenient_reader(const Exhibit& exhibit) {
  Exhibit rest = exhibit;
  for (int drop = 0; drop < 3; ++drop) {
    const Case given = open(rest);
    if (given.posed) return ours(given);
    const int named = named_line(given.refusal);
    if (named == 0) break;
    std::istringstream lines(rest.content);
    rest.content.clear();
    std::string line;
    for (int k = 1; std::getline(lines, line); ++k) rest.content += k == named ? "\n" : line + "\n";
  }
  Answer none;
  none.said = "refused";
  return none;
}

/// What a method makes of an exhibit.
/// \param name   a method of this file; or a member of the library in the place of the usual one: a solver, an element,
///   a gap operator
/// \param given  the exhibit
/// \return the answer; not `asked` if the method does not take such problems
/// \throws signorini::ProblemError for an unknown name
inline Answer naive_answer(const std::string& name, const Case& given) {
  using namespace signorini;
  if (name == "lenient_reader") {
    Answer answer = lenient_reader(given.exhibit);
    answer.asked = !given.posed;
    return answer;
  }
  Answer not_asked;
  not_asked.asked = false;
  if (!given.posed) return not_asked;
  const Posed& posed = *given.posed;
  if (posed.form && !posed.form->definite) return not_asked;
  const bool frictional = !posed.small.law.pair.empty();
  if (name == "trial_and_error" || name == "penalty" || name == "absolute_tolerance" ||
      name == "newton_unscaled" || name == "newton_relative") {
    if (frictional) return not_asked;
    const double spring = name == "penalty" ? 1e-6 : 0, overlap = name[0] == 'a' ? 1e-6 : 0;
    return claimed(posed, name[0] == 'n' ? newton_unscaled(posed.small, name == "newton_relative")
                                         : trial_and_error(posed.small, spring, overlap));
  }
  if (name == "uncoupled") return frictional ? claimed(posed, uncoupled(posed.small)) : not_asked;
  if (name == "sweeps")
    return frictional && posed.small.rigid.cols() == 0 ? claimed(posed, sweeps(posed.small))
                                                       : not_asked;
  if (name == "small_library") return small_library(posed);
  if (name == "double_only" && posed.form && posed.form->programme.equations == 0)
    return unrefined(posed);
  if (name == "double_only") return posed.model ? unrefined(posed, *posed.condensed) : not_asked;
  if (name == "soft_springs")
    return posed.model && posed.small.rigid.cols() > 0 ? soft_springs(posed) : not_asked;
  for (const Solver& solver : all_solvers())
    if (name == solver.name) return answer(posed, name);
  if (!posed.model) return not_asked;
  Scene scene = posed.scene;
  for (Body& body : scene.bodies)
    for (const Element& element : elements())
      if (name == element.name) body.element = name;
  for (ContactSpec& contact : scene.contacts)
    for (const GapOperator& member : gap_operators())
      if (name == member.name) contact.gap_operator = name;
  try {
    Ledger ledger;
    const Model model = build(scene, ledger);
    const Condensed condensed = condense(model, ledger);
    return answer_of(solve_to_limit(scene, model, condensed, ledger));
  } catch (const ProblemError& error) {
    Answer refused;
    refused.said = "refused";
    refused.message = error.what();
    return refused;
  }
}

}  // namespace museum
