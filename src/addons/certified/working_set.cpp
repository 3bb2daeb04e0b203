#include "addons/certified/working_set.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "addons/certified/separate.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/index.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/systems.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Statuses = std::vector<ContactStatus>;

/// The first matrix whose rows are worth leaving out: with doubles, half a megabyte.
constexpr Index fewest_pairs = 256;

/// How many pairs, if they are dense, cost as much as the factor of K, see chapter 21.
Index paid_for(double operations) { return static_cast<Index>(std::cbrt(3 * operations)); }

/// Every how many of n pairs that overlap are tried first: a load may make all pairs overlap where few will close. Without friction
/// no more are tried than are paid for. With friction a pair costs more. A sample of every s-th has n / s pairs, and each of the two ends
/// of a zone of contact is known to a stride before and a stride behind it, 4 s pairs in all: the sum is least at s = sqrt(n) / 2.
Index stride_of(const FrictionLaw& law, Index n, double operations) {
  if (!law.pair.empty()) return 1 + static_cast<Index>(std::sqrt(static_cast<double>(n)) / 2);
  return 1 + n / std::max<Index>(paid_for(operations), 1);
}

/// Every so many of some pairs.
std::vector<Index> thinned(const std::vector<Index>& some, Index stride) {
  std::vector<Index> left;
  for (std::size_t k = 0; k < some.size(); k += at(stride)) left.push_back(some[k]);
  return left;
}

/// The pairs that are condensed, among all.
struct WorkingSet {
  const Model& model;
  const CondensedProgramme whole;  ///< without compliance
  const VectorXd& opens;           ///< `n_c` by how much gaps are larger than in the model [length]
  Statuses statuses;               ///< `n_c` to begin a round with; empty: none are known
  std::vector<bool> in = std::vector<bool>(at(opens.size()), false);  ///< `n_c` whether a pair is in the set
  std::vector<Index> pairs = {};   ///< that are, in increasing order
  SystemParts parts = {};          ///< their rows: gaps, then slips
  NodalRows A = {};                ///< these rows
  ContactProblem problem = {};     ///< of the set, condensed
  KnownMatrices known = {};        ///< of K and all rows of A

  [[nodiscard]] VectorXd rounding(const CertifiedSolution& end) const;
  [[nodiscard]] std::vector<Index> entering(const CertifiedSolution& end) const;
  void keep_closed();
  void take(const std::vector<Index>& some, Index reach);
  void condense(const Factor& factor, Ledger& ledger);
  [[nodiscard]] SolverOptions started(SolverOptions options) const;
  [[nodiscard]] CertifiedSolution untouched() const;
  CertifiedSolution tried(const Solver& solver, const SolverOptions& options, Ledger& ledger) const;
  CertifiedSolution solved(const Solver& solver, const SolverOptions& options, Ledger& ledger) const;
  void widen(CertifiedSolution& end);
  [[nodiscard]] bool asks_all_pairs(const CertifiedSolution& end) const;
};

/// What gaps are known to, as in check_signs().
VectorXd WorkingSet::rounding(const CertifiedSolution& end) const {
  VectorXd least =
      2 * static_cast<double>(end.state.active().size() + 1) * movement_rounding(model.programme, end.solution);
  least.head(opens.size()) += epsilon * opens.cwiseAbs();
  return least;
}

/// The pairs outside that overlap, or may by rounding.
std::vector<Index> WorkingSet::entering(const CertifiedSolution& end) const {
  const VectorXd least = rounding(end);
  std::vector<Index> some;
  for (Index pair = 0; pair < end.state.gap.size(); ++pair)
    if (!in[at(pair)] && !(end.state.gap(pair) > least(pair))) some.push_back(pair);
  return some;
}

/// Leaves out those that ended up open.
void WorkingSet::keep_closed() {
  for (std::size_t pair = 0; pair < in.size(); ++pair)
    if (statuses[pair] == ContactStatus::Open) in[pair] = false;
}

/// Takes in pairs, and so many neighbours on each side of each. Pairs of a contact are numbered along its source.
void WorkingSet::take(const std::vector<Index>& some, Index reach) {
  const Index count = static_cast<Index>(in.size());
  for (const Index pair : some)
    for (Index other = std::max<Index>(0, pair - reach); other <= std::min(count - 1, pair + reach); ++other)
      if (model.contact_of[at(other)] == model.contact_of[at(pair)]) in[at(other)] = true;
  pairs.clear();
  for (Index pair = 0; pair < count; ++pair)
    if (in[at(pair)]) pairs.push_back(pair);
}

void WorkingSet::condense(const Factor& factor, Ledger& ledger) {
  const Ledger::Phase phase(ledger, "condensation");
  std::vector<Index> slips;
  parts.rows = pairs;
  for (std::size_t k = 0; k < model.law.pair.size(); ++k)
    if (in[at(model.law.pair[k])]) slips.push_back(static_cast<Index>(k));
  for (const Index slip : slips) parts.rows.push_back(static_cast<Index>(in.size()) + slip);
  A = selected_rows(model.programme.A, parts.rows);
  problem.compliance = factor.compliance(A, ledger);
  problem.free_gap = whole.problem.free_gap(pairs) + opens(pairs);
  problem.free_slip = whole.problem.free_slip(slips);
  problem.law = part_of(model.law, static_cast<Index>(in.size()), parts);
  ledger.count("condensed pairs", static_cast<long long>(pairs.size()));
  ledger.bytes(problem.compliance.size() * static_cast<long long>(sizeof(double)));
}

/// Options that begin with the statuses of the last round, if there was one.
SolverOptions WorkingSet::started(SolverOptions options) const {
  options.start.clear();
  if (statuses.size() == in.size())
    for (const Index pair : pairs) options.start.push_back(statuses[at(pair)]);
  return options;
}

/// The end without contact forces.
CertifiedSolution WorkingSet::untouched() const {
  CertifiedSolution end;
  end.solution = {whole.free_displacement, {}, VectorXd::Zero(model.programme.A.rows())};
  end.state.gap = whole.problem.free_gap + opens;
  return end;
}

/// What the condensed set says of its pairs, and displacements that are not refined: enough to tell who else may close.
CertifiedSolution WorkingSet::tried(const Solver& solver, const SolverOptions& options,
                                    Ledger& ledger) const {
  const Ledger::Phase phase(ledger, "contact");
  CertifiedSolution end;
  end.state = solve_with_proofs(problem, solver, started(options));
  ledger.count("iterations", end.state.report.iterations);
  ledger.count("factorisations", end.state.report.factorisations);
  if (end.state.report.status != SolveStatus::Solved) return end;
  end.solution.force = all_forces(end.state);
  end.solution.displacement =
      whole.free_displacement - whole.solve_stiffness(A.transpose() * end.solution.force);
  return end;
}

CertifiedSolution WorkingSet::solved(const Solver& solver, const SolverOptions& options,
                                     Ledger& ledger) const {
  const QuadraticProgramme programme{model.programme.stiffness, model.programme.load, A,
                                     model.programme.initial_gap(parts.rows)};
  const CondensedProgramme own{problem, whole.free_displacement, whole.solve_stiffness,
                               whole.solve_part, &known};
  return certified_solve(programme, own, mode_shapes(model.modes), solver, started(options), ledger);
}

/// Makes the end of the set a claim for all pairs: the others are open, without a force. Where they overlap the next round
/// begins with them closed.
void WorkingSet::widen(CertifiedSolution& end) {
  const Statuses own = end.state.contact_status;
  statuses.assign(in.size(), ContactStatus::Open);
  for (std::size_t k = 0; k < own.size(); ++k) statuses[at(pairs[k])] = own[k];
  VectorXd force = VectorXd::Zero(model.programme.A.rows());
  force(parts.rows) = end.solution.force;
  end.solution.force = std::move(force);
  VectorXd gap = gaps(model.programme, end.solution);
  gap.head(opens.size()) += opens;
  fill_state(model.law, statuses, end.solution.force, gap, end.state);
  end.state.system = {};  // it has the numbers of the set
  if (Index& pair = end.force_uncertainty.pair; pair >= 0) pair = pairs[at(pair)];
  const VectorXd least = rounding(end);
  for (Index pair = 0; pair < end.state.gap.size(); ++pair)
    if (!in[at(pair)] && gap(pair) < -least(pair)) statuses[at(pair)] = ContactStatus::Stick;
}

/// Whether all pairs may have a proof that there is one solution where the set has one, or a doubt, or no slips to ask. What fails on
/// the set fails on all pairs, see excludes_others(): with more slips C T^-1 C' takes more from G, their |T| is larger, and scales are
/// of single rows.
bool WorkingSet::asks_all_pairs(const CertifiedSolution& end) const {
  return !model.law.pair.empty() && (problem.law.pair.empty() || end.state.uniqueness != Uniqueness::Unknown);
}

/// The pairs to begin with.
struct FirstPairs {
  std::vector<Index> pairs;
  bool sample;  ///< whether they are every second, third, ... of those that may close
};

/// Those that are said to be closed, or else those that overlap, or a sample of them where that is worth a trial.
FirstPairs first_pairs(const WorkingSet& set, double operations) {
  std::vector<Index> closed;
  for (std::size_t pair = 0; pair < set.statuses.size(); ++pair)
    if (set.statuses[pair] != ContactStatus::Open) closed.push_back(static_cast<Index>(pair));
  if (!closed.empty()) return {closed, false};
  const std::vector<Index> overlapping = set.entering(set.untouched());
  const Index stride = stride_of(set.model.law, static_cast<Index>(overlapping.size()), operations);
  return {thinned(overlapping, stride), stride > 1};
}

/// Round after round: each shows who enters. A sample is not refined if somebody does, and only what closed of it stays. Nor is any
/// round with friction: a proof that sends to all pairs is seen before.
/// \param refined  whether the last one is solved once more, to the end
/// \return the last one, if it was solved and was worth its rounds
std::optional<CertifiedSolution> grown(WorkingSet& set, const Factor& factor, const Solver& solver,
                                       const SolverOptions& options, bool refined, Ledger& ledger) {
  const auto dense = [](std::size_t m) { return std::pow(static_cast<double>(m), 3); };
  CertifiedSolution end;
  Report report;
  auto [some, sample] = first_pairs(set, factor.operations());
  const bool late = !refined || !set.model.law.pair.empty();
  bool trial = sample || late;
  double made = 0;
  for (Index reach = 0; reach == 0 || !some.empty(); reach = std::max<Index>(1, 2 * reach)) {
    if (sample && reach == 1) set.keep_closed();
    set.take(some, reach);
    made += dense(set.pairs.size());
    if (2 * made > dense(set.in.size())) return std::nullopt;
    set.condense(factor, ledger);
    do {
      end = trial ? set.tried(solver, options, ledger) : set.solved(solver, options, ledger);
      append(report, end.state.report);
      if (report.status != SolveStatus::Solved) return std::nullopt;
      set.widen(end);
      some = set.entering(end);
      if (refined && some.empty() && set.asks_all_pairs(end)) return std::nullopt;
    } while (refined && some.empty() && std::exchange(trial, false));
    trial = late;
  }
  end.state.report = std::move(report);
  return end;
}

}  // namespace

bool working_set_pays(const Plan& plan, Index rows, double operations) {
  const bool plain = plan.modes.empty() && plan.law.cohesion.isZero(0) && plan.path.times.empty() &&
                     !plan.equations && !plan.loop;
  const double worth = plan.law.pair.empty() ? operations : operations / 2;
  return plain && rows >= fewest_pairs && rows > paid_for(worth);
}

std::optional<CertifiedSolution> working_set_solution(const Model& model,
                                                      const Condensed& condensed,
                                                      const Solver& solver,
                                                      const SolverOptions& options,
                                                      Ledger& ledger) {
  try {
    const VectorXd as_they_are = VectorXd::Zero(condensed.problem.free_gap.size());
    WorkingSet set{model, condensed_programme(condensed, ledger), as_they_are, options.start};
    set.known = known_matrices(model.programme, model.law);
    // Of systems that nothing connects one may have slips and the others none in the set: who asks for a proof is then unknown.
    if (!model.law.pair.empty() && !set.known.connected) return std::nullopt;
    std::optional<CertifiedSolution> end = grown(set, condensed.factor, solver, options, true, ledger);
    if (!end) return end;
    end->certificate = certify(model.programme, end->solution, model.law, &set.known);
    return end->certificate.holds() ? std::move(end) : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // numbers that no unit can take: the problem of all pairs says which
  }
}

std::optional<ContactState> working_set_state(const Model& model, const Condensed& condensed,
                                              const VectorXd& opens, const Solver& solver,
                                              const SolverOptions& options) {
  try {
    Ledger unseen;
    WorkingSet set{model, condensed_programme(condensed, unseen), opens, options.start};
    std::optional<CertifiedSolution> end = grown(set, condensed.factor, solver, options, false, unseen);
    if (!end) return std::nullopt;
    end->state.uniqueness = Uniqueness::Unknown;  // of the set, not of all pairs
    end->state.uniqueness_warning = {};
    return std::move(end->state);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace signorini
