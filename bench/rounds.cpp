#include "bench/rounds.hpp"

#include <chrono>
#include <cmath>
#include <fstream>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "addons/certified/working_set.hpp"
#include "addons/frontal/frontal_factor.hpp"
#include "bench/measure.hpp"
#include "signorini/core/table.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini::bench {
namespace {

using Eigen::VectorXd;

const double once = 5;      // what takes more seconds is not repeated
const double longest = 45;  // a yardstick that will need more seconds is left out

const Eigen::Index most_steps = 25;  // of the active set, whatever the size
const long long most_solves = 5;     // with K, to refine

/// Memory of this program. \param line  `VmHWM:` the largest since forget_peak(), `VmRSS:` now
/// \return [MB], 0 where the system does not tell
double megabytes(const char* line) {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0;
  while (status >> word)
    if (word == line) status >> kilobytes;
  return kilobytes / 1e3;
}

void forget_peak() {
#ifdef __GLIBC__
  malloc_trim(0);  // else what earlier scenes freed may still count
#endif
  std::ofstream("/proc/self/clear_refs") << '5';
}

/// Does something, and notes its processor time and by how much memory rose.
template <typename Do>
void note(const std::string& way, Cost& cost, Do&& what) {
  const bool first = cost.times.count(way) == 0;
  if (first) forget_peak();
  const double before = first ? megabytes("VmRSS:") : 0;
  const double begin = processor_seconds();
  what();
  cost.times[way].push_back(processor_seconds() - begin);
  if (first) cost.rise[way] = megabytes("VmHWM:") - before;
}

/// Takes the phases of a ledger over. They are wall times; what others did on the machine is taken off in proportion.
void split(const Ledger& ledger, double share, Times& times) {
  for (const LedgerEntry& entry : ledger.entries())
    times[entry.path].push_back(share * entry.seconds);
}

/// What a round of contact leaves to those that come after it.
struct Round {
  Model model;
  Condensed condensed;
};

/// Mesh to certified solution; every round must end at the same bits.
Round contact_round(const Scene& scene, Cost& cost) {
  Ledger ledger;
  const auto wall = std::chrono::steady_clock::now();
  const double begin = processor_seconds();
  Model model = build(scene, ledger);
  const double built = processor_seconds();
  Condensed condensed = condense_as_needed(model, ledger);
  const double small = processor_seconds();
  Solution solution = solve(model, condensed, std::move(ledger));
  const double end = processor_seconds();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - wall;
  split(solution.ledger, (end - begin) / elapsed.count(), cost.times);
  cost.times["set-up"].push_back(built - begin);
  cost.times["condense"].push_back(small - built);
  cost.times["whole"].push_back(end - built);
  cost.fill = static_cast<double>(condensed.factor.nonzeros());
  cost.operations = condensed.factor.operations();
  cost.unknowns = model.unknowns.count;
  const ContactState& contact = solution.contact;
  const bool first = cost.times["whole"].size() == 1;
  cost.good = cost.good && is_certified(solution) && contact.report.iterations <= most_steps &&
              solution.ledger.counted("refinement", "solves") <= most_solves &&
              (first || (contact.force == cost.first.contact.force &&
                         contact.report.iterations == cost.first.contact.report.iterations));
  if (first) cost.first = std::move(solution);
  return {std::move(model), std::move(condensed)};
}

/// Whether u solves K u = p up to the rounding of a sum.
bool solves(const Eigen::SparseMatrix<double>& K, const VectorXd& u, const VectorXd& p) {
  const VectorXd terms = K.cwiseAbs() * u.cwiseAbs() + p.cwiseAbs();
  return (p - K * u).cwiseAbs().maxCoeff() <= 1e-12 * terms.maxCoeff();
}

/// A plain solve: ordering, factor and one solve, as without contact.
void plain_round(const Model& model, const Eigen::SparseMatrix<double>& K, Cost& cost) {
  Ledger unused;
  VectorXd u;
  note("plain", cost, [&] {
    const FrontalFactor factor(K, separator_tree(K, unknown_positions(model)), unused);
    u = factor.solve(model.programme.load);
    cost.good = cost.good && cost.fill == static_cast<double>(factor.nonzeros()) &&
                cost.operations == factor.operations();
  });
  cost.good = cost.good && solves(K, u, model.programme.load);
}

void yardstick_round(const Yardstick& other, const Round& ours,
                     const Eigen::SparseMatrix<double>& K, Cost& cost) {
  const Model& model = ours.model;
  VectorXd u;
  note(other.name, cost, [&] { u = other.solve(K, model.programme.load); });
  cost.good = cost.good && solves(K, u, model.programme.load);
  if (!other.compliance) return;
  Eigen::MatrixXd theirs;
  note(other.name + " compliance", cost, [&] { theirs = other.compliance(K, model.programme.A); });
  Ledger unused;
  const Eigen::MatrixXd compliance = completed(model, ours.condensed, unused).problem.compliance;
  cost.good = cost.good && (theirs - compliance).cwiseAbs().maxCoeff() <=
                               1e-10 * compliance.cwiseAbs().maxCoeff();
}

/// Whether the work of a factor in the plane, which grows like the power 3/2, lets a yardstick end in time.
bool in_time(const Yardstick& other, const Scene& scene, const Cost* smaller) {
  if (smaller == nullptr) return true;
  const auto last = smaller->times.find(other.name);
  if (last == smaller->times.end()) return false;
  double unknowns = 0;
  for (const Body& part : scene.bodies) unknowns += 2 * static_cast<double>(part.mesh.n_nodes());
  const double growth = unknowns / static_cast<double>(smaller->unknowns);
  return std::pow(growth, 1.5) * median(last->second) < longest;
}

/// K with the springs that condense() gives to the factor, for yardsticks that take one matrix.
Eigen::SparseMatrix<double> grounded_stiffness(const Model& model) {
  Eigen::SparseMatrix<double> K = model.programme.stiffness;
  for (const Eigen::Index unknown : grounding(model.modes)) K.coeffRef(unknown, unknown) *= 2;
  return K;
}

}  // namespace

bool is_certified(const Solution& solution) {
  return solution.contact.report.status == SolveStatus::Solved && solution.certificate.holds();
}

std::string ratio(const Cost& cost, const std::string& way, const std::string& over) {
  std::vector<double> ratios;
  if (cost.times.count(way) == 0 || cost.times.count(over) == 0) return "-";
  const std::vector<double>& a = cost.times.at(way);
  const std::vector<double>& b = cost.times.at(over);
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) ratios.push_back(a[k] / b[k]);
  return number(median(ratios), "%.2f");
}

Cost measure(const Scene& scene, int rounds, const Cost* smaller,
             const std::vector<Yardstick>& others) {
  Cost cost;
  for (int round = 0; round < rounds; ++round) {
    forget_peak();
    const double before = megabytes("VmRSS:");
    const Round ours = contact_round(scene, cost);
    if (round == 0) cost.megabytes = megabytes("VmHWM:");
    if (round == 0) cost.rise["whole"] = cost.megabytes - before;
    const Eigen::SparseMatrix<double> K = grounded_stiffness(ours.model);
    plain_round(ours.model, K, cost);
    for (const Yardstick& other : others)
      if (round == 0 ? in_time(other, scene, smaller)
                     : cost.times.count(other.name) > 0 && cost.times[other.name][0] < once)
        yardstick_round(other, ours, K, cost);
  }
  return cost;
}

}  // namespace signorini::bench
