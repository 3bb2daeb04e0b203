/// \file
/// Chapter 17: whether an answer is what an exhibit states, and what the certificate says of a forged one.
#pragma once
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "answers.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"

namespace museum {

/// A figure of an answer. \param name  such as "force sum", "largest pressure" or "gap 3" \param answer  any
/// \return the figure, not a number if the answer does not tell it \throws signorini::ProblemError for an unknown name
inline double quantity(const std::string& name, const Answer& answer) {
  const signorini::ContactState& state = answer.contact;
  const auto count = [&](auto&& is) {
    return static_cast<double>(
        std::count_if(state.contact_status.begin(), state.contact_status.end(), is));
  };
  if (name == "closed pairs") return static_cast<double>(state.active().size());
  if (name == "sticking pairs")
    return count([](signorini::ContactStatus contact_status) {
      return contact_status == signorini::ContactStatus::Stick;
    });
  if (name == "sliding pairs")
    return count(
        [](signorini::ContactStatus contact_status) { return friction_sign(contact_status) != 0; });
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
      signorini::require_input(i >= 0 && i < values.size(), "quantity ", name, ": there are ",
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
      return bound.quantity + " = " + signorini::number(value, "%.4g") + " misses " +
             signorini::number(bound.value, "%.4g") + " by " +
             signorini::number(std::abs(value - bound.value), "%.1e");
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
/// force is put where there was none but rounding of the load; or, where nothing was solved, the last numbers are called a solution.
/// \param posed   the exhibit
/// \param answer  of the library
/// \param share   of the largest force; 0 changes nothing
/// \return the certificate of the forgery
inline signorini::Certificate forged(const Posed& posed, const Answer& answer, double share) {
  using namespace signorini;
  const auto spoil = [&](VectorXd& force, const VectorXd& load) {
    Index most = 0;
    if (!answer.solved() || force.size() == 0 || share == 0) return;
    const double rounding = epsilon * largest(load);
    const bool none = force.cwiseAbs().maxCoeff(&most) <= rounding;
    force(most) = none ? 1 : force(most) * (1 + share);
  };
  if (!posed.model && !posed.form) {
    ContactState state = answer.contact;
    spoil(state.force, {});
    if (state.force.size() != posed.small.free_gap.size()) return uncertified();
    return certify(posed.small, state);
  }
  PrimalDual claim = answer.refined;
  spoil(claim.force,
        posed.form ? posed.form->programme.load : VectorXd(posed.model->programme.load));
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
