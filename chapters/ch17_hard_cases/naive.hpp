/// \file
/// Chapter 17: methods without safeguards, as they are often written, to see where they fail.
#pragma once
#include <Eigen/LU>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "answers.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "signorini/elasticity/elements.hpp"
#include "signorini/factor/separator_tree.hpp"

namespace museum {

using signorini::ContactProblem;
using signorini::ContactState;
using signorini::Status;

/// Gaps of given forces, as the method computes them. \param problem  condensed \param[in,out] state  forces and amplitudes
inline void find_gaps(const ContactProblem& problem, ContactState& state) {
  state.gap = problem.free_gap + problem.compliance * state.force;
  if (problem.rigid.cols() > 0) state.gap += problem.rigid * state.amplitude;
}

// [guess]
/// Active sets by trial and error: solve for the forces of a set, drop what pulls, add what overlaps.
/// \param problem   without friction
/// \param spring    compliance of a spring in each contact [length/force]: 0, or that of a penalty
/// \param overlap   that counts as none [length]
/// \return the state in which no sign is wrong any more
inline ContactState trial_and_error(const ContactProblem& problem, double spring, double overlap) {
  const Index n = problem.free_gap.size(), modes = problem.rigid.cols();
  ContactState state;
  for (Index i = 0; i < n; ++i)
    if (problem.free_gap(i) < -overlap) state.active.push_back(i);
  for (int step = 0; step < 100; ++step) {
    const Index k = static_cast<Index>(state.active.size());
    MatrixXd system = MatrixXd::Zero(k + modes, k + modes);
    VectorXd right(k + modes);
    system.topLeftCorner(k, k) = problem.compliance(state.active, state.active);
    system.topLeftCorner(k, k).diagonal().array() += spring;
    right.head(k) = -problem.free_gap(state.active);
    if (modes > 0) {
      system.topRightCorner(k, modes) = problem.rigid(state.active, Eigen::all);
      system.bottomLeftCorner(modes, k) = system.topRightCorner(k, modes).transpose();
      right.tail(modes) = problem.resultant;
    }
    if (k + modes > 0) right = Eigen::PartialPivLU<MatrixXd>(system).solve(right).eval();
    if (!right.allFinite()) break;  // singular
    state.force = VectorXd::Zero(n);
    state.force(state.active) = right.head(k);
    state.amplitude = right.tail(modes);
    find_gaps(problem, state);
    std::vector<Index> next;
    for (Index i = 0; i < n; ++i)
      if (state.force(i) > 0 || (state.force(i) == 0 && state.gap(i) < -overlap)) next.push_back(i);
    state.report.status = next == state.active ? Status::Solved : Status::IterationLimit;
    if (next == state.active) return state;
    state.active = next;
  }
  return state;
}
// [guess]

/// Newton's method on gap and force as they are, a length beside a force: no scaling, no search along the line.
/// \param problem   without friction
/// \param relative  the residual must come below 1e-8 of the first one, else below 1e-8
/// \return the last state
inline ContactState newton_unscaled(const ContactProblem& problem, bool relative) {
  const Index n = problem.free_gap.size(), modes = problem.rigid.cols();
  ContactState state;
  state.force = VectorXd::Zero(n);
  state.amplitude = VectorXd::Zero(modes);
  state.report.status = Status::IterationLimit;
  double wanted = 1e-8;
  for (int step = 0; step < 100; ++step) {
    find_gaps(problem, state);
    const Eigen::ArrayXd a = state.gap.array(), b = state.force.array();
    const Eigen::ArrayXd root = (a.square() + b.square()).sqrt();
    VectorXd residual(n + modes);
    residual.head(n) = root - a - b;
    MatrixXd system = MatrixXd::Zero(n + modes, n + modes);
    const VectorXd da = a / root - 1, db = b / root - 1;
    system.topLeftCorner(n, n) = da.asDiagonal() * problem.compliance;
    system.topLeftCorner(n, n).diagonal() += db;
    if (modes > 0) {
      residual.tail(modes) = problem.rigid.transpose() * state.force - problem.resultant;
      system.topRightCorner(n, modes) = da.asDiagonal() * problem.rigid;
      system.bottomLeftCorner(modes, n) = problem.rigid.transpose();
    }
    if (relative && step == 0) wanted *= residual.norm();
    if (residual.norm() < wanted) {
      state.report.status = Status::Solved;
      return state;
    }
    const VectorXd change = Eigen::PartialPivLU<MatrixXd>(system).solve(residual);
    state.force -= change.head(n);
    state.amplitude -= change.tail(modes);
  }
  return state;
}

/// Friction in one go: forces without friction first, then bounds of friction from them.
/// \param problem  with friction \return the state, claimed to be that of the whole
inline ContactState uncoupled(const ContactProblem& problem) {
  const std::string solver = "primal_dual_active_set";
  ContactProblem step = problem;
  step.law.coefficient.setZero();
  step.law.cohesion.setZero();
  ContactState state = signorini::find_solver(solver).solve(step, {});
  if (state.report.status != Status::Solved) return state;
  step.law.cohesion =
      problem.law.cohesion + problem.law.coefficient.cwiseProduct(state.force(problem.law.pair));
  return signorini::find_solver(solver).solve(step, {});
}

/// Pair by pair, the force that closes the gap, then the friction that stops the slip, up to its bound; a hundred times, or
/// until nothing changes by more than 1e-6. Cohesion holds open pairs, too, \PaperEq{LinEtAl, 29}.
/// \param problem  with friction, of held bodies \return the state
inline ContactState sweeps(const ContactProblem& problem) {
  const Index n = problem.free_gap.size();
  VectorXd free(n + problem.free_slip.size()), all = VectorXd::Zero(free.size());
  free << problem.free_gap, problem.free_slip;
  ContactState state;
  state.report.status = Status::IterationLimit;
  for (int sweep = 0; sweep < 100 && state.report.status != Status::Solved; ++sweep) {
    double change = 0;
    for (Index i = 0; i < all.size(); ++i) {
      const double moved = free(i) + problem.compliance.row(i).dot(all);
      const double wanted = all(i) - moved / problem.compliance(i, i);
      const Index k = i - n;
      const double bound =
          k < 0 ? 0
                : problem.law.coefficient(k) * all(problem.law.pair[static_cast<std::size_t>(k)]) +
                      problem.law.cohesion(k);
      const double next = k < 0 ? std::max(wanted, 0.0) : std::clamp(wanted, -bound, bound);
      change = std::max(change, std::abs(next - all(i)));
      all(i) = next;
    }
    if (change < 1e-6) state.report.status = Status::Solved;
  }
  const VectorXd moved = free + problem.compliance * all;
  state.force = all.head(n);
  state.gap = moved.head(n);
  state.friction = all.tail(all.size() - n);
  state.slip = moved.tail(all.size() - n);
  return state;
}

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

// [double]
/// The forces of a sound method, and displacements once forwards and backwards through a factor, in plain doubles.
/// \param posed      a scene
/// \param factor     of K, or of something near it
/// \param condensed  with the compliance of that factor
/// \return the answer, certified from K, p, A and g
inline Answer unrefined(const Posed& posed, const signorini::FrontalFactor& factor,
                        const ContactProblem& condensed) {
  const signorini::Model& model = *posed.model;
  const std::string& name = posed.scene.solver;
  ContactState state = signorini::find_solver(name).solve(condensed, {});
  Answer answer;
  answer.said = to_string(state.report.status);
  if (!answer.solved()) return answer;
  VectorXd all(state.force.size() + state.friction.size());
  all << state.force, state.friction;
  answer.refined.force = all;
  answer.refined.displacement =
      factor.solve(model.programme.load - model.programme.A.transpose() * all);
  if (condensed.rigid.cols() > 0) {
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
// [double]

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

/// Bodies that only contact holds, made fast by soft springs everywhere: 1e-9 of the largest stiffness.
/// \param posed  a scene that has such bodies \return its answer
inline Answer soft_springs(const Posed& posed) {
  Eigen::SparseMatrix<double> stiffness = posed.model->programme.stiffness;
  stiffness.diagonal().array() += 1e-9 * stiffness.diagonal().maxCoeff();
  signorini::Ledger ledger;
  const signorini::FrontalFactor factor(stiffness, signorini::separator_tree(stiffness), ledger);
  const auto& [K, p, A, g] = posed.model->programme;
  const VectorXd free = g - A * factor.solve(p);
  const Index pairs = posed.small.free_gap.size();
  return unrefined(
      posed, factor,
      {factor.compliance(A), free.head(pairs), free.tail(free.size() - pairs), posed.model->law});
}

/// A reader that goes on without the lines it cannot use. \param exhibit  a file that is refused
/// \return what the library makes of the rest
inline Answer lenient_reader(const Exhibit& exhibit) {
  Exhibit rest = exhibit;
  for (int drop = 0; drop < 3; ++drop) {
    const Case given = open(rest);
    if (given.posed) return ours(given);
    std::smatch match;
    if (!std::regex_search(given.refusal, match, std::regex(":(\\d+):"))) break;
    std::istringstream lines(rest.content);
    rest.content.clear();
    std::string line;
    for (int k = 1; std::getline(lines, line); ++k)
      rest.content += k == std::stoi(match[1]) ? "\n" : line + "\n";
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
  const bool rubs = !posed.small.law.pair.empty();
  if (name == "trial_and_error" || name == "penalty" || name == "absolute_tolerance" ||
      name == "newton_unscaled" || name == "newton_relative") {
    if (rubs) return not_asked;
    const double spring = name == "penalty" ? 1e-6 : 0, overlap = name[0] == 'a' ? 1e-6 : 0;
    return claimed(posed, name[0] == 'n' ? newton_unscaled(posed.small, name == "newton_relative")
                                         : trial_and_error(posed.small, spring, overlap));
  }
  if (name == "uncoupled") return rubs ? claimed(posed, uncoupled(posed.small)) : not_asked;
  if (name == "sweeps")
    return rubs && posed.small.rigid.cols() == 0 ? claimed(posed, sweeps(posed.small)) : not_asked;
  if (name == "double_only" && posed.form && posed.form->programme.equations == 0)
    return unrefined(posed);
  if (name == "double_only")
    return posed.model ? unrefined(posed, posed.condensed->factor, posed.small) : not_asked;
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
