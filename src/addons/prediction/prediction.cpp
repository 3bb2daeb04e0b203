#include "addons/prediction/prediction.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "addons/certified/many_bodies.hpp"
#include "addons/certified/separate.hpp"
#include "addons/certified/working_set.hpp"
#include "addons/frontal/backend.hpp"
#include "addons/prediction/front_speed.hpp"
#include "addons/prediction/pattern.hpp"
#include "addons/prediction/sample.hpp"
#include "signorini/core/bytes.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/fem/along_boundary.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;

BodySummary summary_of(const BodyModel& body) {
  const NodeArray load = nodal_loads(body.mesh, body.element, body.material, body.loads);
  Resultant sum;
  for (Index node = 0; node < load.rows(); ++node)
    sum.add(body.mesh.nodes.row(node).transpose(), load.row(node).transpose());
  BodySummary summary{body.mesh.name, body.unknowns.count, static_cast<Index>(body.pieces.size()),
                      sum.force, sum.moment};
  if (is_axial(body)) {  // all round the axis, these cancel
    summary.force.x() = 0;
    summary.moment = 0;
  }
  return summary;
}

bool is_default(const Solver& solver) { return solver.solve == Scene().solver.solve; }

/// Why the run will go the way it goes.
std::string method_of(const Plan& plan) {
  if (plan.gaps.A.rows() == 0) return "one linear solve: nothing touches";
  const Solver& solver = plan.solver;
  std::string why =
      text("solver ", solver.name, is_default(solver) ? ", the default," : ", as asked for,",
           solved_whole(plan) ? " by the entries of K and A, without a condensed problem ("
                              : " on the condensed problem (",
           solver.summary, ")");
  if (!plan.law.pair.empty()) why += "; it takes friction";
  if (!plan.modes.empty())
    why += text("; ", plan.modes.size(),
                plan.modes.size() == 1 ? " rigid motion is an unknown of its own"
                                       : " rigid motions are unknowns of their own",
                solver.rigid_modes ? "" : ", held by springs that carry nothing in the end");
  return why + "; certified from K, p, A, g";
}

/// Why the number of contact iterations is not known beforehand; empty if it is known.
std::string why_not_counted(const Plan& plan) {
  if (plan.gaps.A.rows() == 0) return "";
  std::string why;
  if (!is_default(plan.solver)) why += text(", solver ", plan.solver.name);
  if (!plan.law.pair.empty()) why += text(", pairs that rub: ", plan.law.pair.size());
  if (!plan.modes.empty()) why += text(", rigid motions: ", plan.modes.size());
  if (why.empty()) return why;
  return text("how many iterations contact takes depends on the numbers and is not known before (",
              why.substr(2), ')');
}

/// Whether iterations have a K of their own each. The forecast has one factor.
bool factors_again(const Plan& plan) {
  return std::any_of(plan.bodies.begin(), plan.bodies.end(),
                     [](const BodyModel& body) { return body.material.base.law != nullptr; });
}

/// Collects the figures phase by phase.
class Figures {
 public:
  Figures(const Plan& plan, const Pattern& known)
      : plan_(plan),
        known_(known),
        rows_(static_cast<double>(known.rows.rows())),
        speed_(measure_speed(known.fronts, known.paths)),
        sample_(sample_of(plan, known.stiffness.nonZeros())),
        steps_(std::max(1.0, static_cast<double>(plan.path.times.size()))),
        of_factor_(factors_again(plan) ? Certainty::AtLeast
                   : plan.backend.factor == Scene().backend.factor ? Certainty::Exact
                                                                   : Certainty::Estimate),
        few_(working_set_pays(plan, largest_of(known.systems), known.fronts.operations())),
        counted_(why_not_counted(plan).empty()) {}

  std::vector<PredictedFigure> all() {
    assembly();
    factor();
    condensation();
    const double once = seconds_;
    contact();
    refinement();
    const Certainty certainty = counted_ ? Certainty::Estimate : Certainty::AtLeast;
    if (steps_ > 1)
      add(Frequency::PerStep, later_step, "seconds", (seconds_ - once) / steps_, certainty);
    add(Frequency::Once, all_phases, "seconds", seconds_, certainty);
    return std::move(figures_);
  }

 private:
  static constexpr double number = sizeof(double);

  void add(Frequency frequency, const char* phase, const char* what, double amount,
           Certainty certainty) {
    figures_.push_back({frequency, phase, what, amount, certainty});
  }
  void seconds(Frequency frequency, const char* phase, double amount,
               Certainty certainty = Certainty::Estimate) {
    seconds_ += amount;
    add(frequency, phase, "seconds", amount, certainty);
  }
  [[nodiscard]] double factor_bytes() const {
    return number * static_cast<double>(known_.fronts.entries);
  }

  void assembly() {
    const char* const phase = "assembly";
    const auto exact = [&](const char* what, Index amount) {
      add(Frequency::Once, phase, what, static_cast<double>(amount), Certainty::Exact);
    };
    exact("unknowns", plan_.unknowns.count);
    exact("pairs", plan_.gaps.A.rows());
    exact("rows", known_.rows.rows());
    exact("stiffness entries", known_.stiffness.nonZeros());
    exact("bytes", bytes_of(known_.stiffness) + bytes_of(known_.rows));
    seconds(Frequency::Once, phase, sample_.assembly);
  }

  void factor() {
    const Fronts& fronts = known_.fronts;
    seconds(Frequency::Once, "factor/ordering", known_.taken.seconds("factor/ordering"));
    seconds(Frequency::Once, "factor/symbolic", known_.analysis);
    const char* const phase = "factor/numeric";
    add(Frequency::Once, phase, "nonzeros", static_cast<double>(fronts.nonzeros()), of_factor_);
    add(Frequency::Once, phase, "operations", fronts.operations(), of_factor_);
    add(Frequency::Once, phase, "bytes", factor_bytes(), of_factor_);
    add(Frequency::Once, phase, "stack bytes",
        number * static_cast<double>(fronts.update_stack().most()), of_factor_);
    double handed_on = 0;
    for (const Front& front : fronts.all)
      handed_on += number * static_cast<double>(front.rim() * front.rim());
    // Every entry of L and of an update is cleared once, and an update is read once by the front above.
    seconds(Frequency::Once, phase,
            over(fronts.operations(), speed_.elimination) +
                over(factor_bytes() + 2 * handed_on, speed_.memory));
  }

  void condensation() {
    const char* const phase = "condensation";
    const Certainty of_rows = few_ ? Certainty::Estimate : of_factor_;
    add(Frequency::PerStep, phase, "operations of one solve", known_.fronts.solve_operations(),
        of_factor_);
    if (solved_whole(plan_)) {  // by its entries: u0 is all that is made
      add(Frequency::Once, phase, "operations", known_.fronts.solve_operations(), of_factor_);
      seconds(Frequency::Once, phase, solve());
      return;
    }
    add(Frequency::Once, phase, "operations",
        known_.fronts.solve_operations() + known_.paths.operations, of_rows);
    add(Frequency::Once, phase, "bytes", number * rows_ * rows_,
        few_                   ? Certainty::Estimate
        : factors_again(plan_) ? Certainty::AtLeast
                               : Certainty::Exact);
    add(Frequency::Once, phase, "stack bytes", static_cast<double>(known_.paths.bytes()), of_rows);
    const double all =
        1 + static_cast<double>(plan_.parts.size());  // each part of a path has its u0
    // The compliance is cleared and filled, and every rigid motion meets every row.
    const double modes = static_cast<double>(plan_.modes.size());
    const double touched = 2 * rows_ * rows_ + modes * static_cast<double>(plan_.unknowns.count) +
                           modes * 2 * static_cast<double>(known_.rows.nonZeros());
    seconds(Frequency::Once, phase,
            all * solve() + over(known_.paths.operations, speed_.carrying) +
                over(number * touched, speed_.memory));
  }

  /// Whether the system is solved by its entries: then no dense factor is made of it.
  [[nodiscard]] bool few_entries(const SystemParts& system) const {
    return solved_whole(plan_) ||
           many_bodies(static_cast<Index>(system.modes.size()), plan_.solver, {});
  }
  /// Seconds of a set by its entries: a factor with pivots and sweeps with exact residuals took 89 to 97 times a residual on
  /// stacks of 100 to 1000 blocks.
  [[nodiscard]] double sparse_set(const SystemParts& system) const {
    return 90 * sample_.residual * part_of_all(system);
  }
  [[nodiscard]] double part_of_all(const SystemParts& system) const {
    return static_cast<double>(system.unknowns.size()) /
           static_cast<double>(std::max<Index>(1, plan_.unknowns.count));
  }
  /// Seconds of the equations of a set with half of the rows closed. Rigid motions and slips, which follow the forces
  /// of their pairs, leave no symmetric matrix.
  [[nodiscard]] double closing(const SystemParts& system) const {
    const double modes = static_cast<double>(system.modes.size());
    const double closed = 0.5 * static_cast<double>(system.rows.size()) + modes;
    const double triangles = plan_.law.pair.empty() && modes == 0 ? 1 : 2;
    return over(triangles * closed * closed * closed / 3, speed_.elimination) +
           over(2 * number * closed * closed, speed_.memory);
  }
  /// Seconds of the orthonormal rigid motions of the rows, which every pass of contact and of refinement makes anew: two
  /// bidiagonal factors and their vectors.
  [[nodiscard]] double orthonormal(const SystemParts& system) const {
    const double rows = static_cast<double>(system.rows.size());
    const double modes = static_cast<double>(system.modes.size());
    return over((4 * rows + 22 * modes) * modes * modes, speed_.elimination);
  }

  void contact() {
    if (rows_ == 0) return;
    const char* const phase = "contact";
    const double systems = static_cast<double>(
        std::count_if(known_.systems.begin(), known_.systems.end(),
                      [](const SystemParts& system) { return !system.rows.empty(); }));
    double round = 0;  // of all systems
    for (const SystemParts& system : known_.systems)
      if (!system.rows.empty())
        round += few_entries(system) ? sparse_set(system) : closing(system) + orthonormal(system);
    if (!counted_) {
      const double unknown = std::numeric_limits<double>::quiet_NaN();
      add(Frequency::PerIteration, phase, "iterations", unknown, Certainty::Unknown);
      add(Frequency::PerIteration, phase, one_iteration, round / systems, Certainty::Estimate);
      add(Frequency::PerIteration, phase, "seconds", unknown, Certainty::Unknown);
      return;
    }
    constexpr double usual = 5;
    add(Frequency::PerIteration, phase, "iterations", usual * steps_ * systems,
        Certainty::Estimate);
    seconds(Frequency::PerIteration, phase, usual * steps_ * round);
  }

  void refinement() {
    const char* const phase = "refinement";
    // A solve mends u without contact. Contact forces move it, a sweep mends both, and what it changes of the forces moves
    // u again; rigid motions take two sweeps more.
    // Every system has its own, which walk through its own part of the factor.
    double all_solves = 0;
    double walks = 0;
    double equations = 0;                                       // [s]
    double residuals = known_.systems.size() > 1 ? steps_ : 0;  // of the certificate of all
    for (const SystemParts& system : known_.systems) {
      const double part = part_of_all(system);
      const bool sparse = few_entries(system);  // refined already: one solve tells rigid motions
      const double solves =
          (system.rows.empty() || sparse ? 1 : system.modes.empty() ? 3 : 5) * steps_;
      all_solves += solves;
      walks += part * solves;
      if (!sparse) equations += steps_ * (closing(system) + orthonormal(system));
      // A residual for every solve that mends, and one for the certificate; by entries, that certificate and the equations
      // of rigid motions, which took 9 to 18 times a residual.
      residuals +=
          part * (system.rows.empty() ? 2 * steps_ : sparse ? 12 * steps_ : solves - steps_);
    }
    // Bodies that move take several iterations a step, and how many is not known before.
    const Certainty certainty = plan_.loop ? Certainty::AtLeast : Certainty::Estimate;
    add(Frequency::PerIteration, phase, "solves", all_solves, certainty);
    add(Frequency::PerIteration, phase, "operations", walks * known_.fronts.solve_operations(),
        certainty);
    seconds(Frequency::PerIteration, phase,
            walks * solve() + residuals * sample_.residual + equations, certainty);
  }

  /// Seconds of one solve: two walks through L.
  [[nodiscard]] double solve() const { return over(2 * factor_bytes(), speed_.memory); }
  [[nodiscard]] static double over(double amount, double speed) {
    return amount > 0 ? amount / speed : 0;
  }

  const Plan& plan_;
  const Pattern& known_;
  double rows_;
  FrontSpeed speed_;
  Sample sample_;
  double steps_;
  Certainty of_factor_;  // its fronts are those of ours
  bool few_;             // whether only pairs that may close are condensed: which, is not known before
  bool counted_;         // whether the iterations of contact are known beforehand
  std::vector<PredictedFigure> figures_;
  double seconds_ = 0;
};

}  // namespace

double Prediction::amount(const std::string& phase, const std::string& what) const {
  for (const PredictedFigure& figure : figures)
    if (figure.phase == phase && figure.what == what) return figure.amount;
  return 0;
}

Prediction predict(const Plan& plan) {
  Prediction prediction;
  for (const BodyModel& body : plan.bodies) prediction.bodies.push_back(summary_of(body));
  prediction.method = method_of(plan);
  prediction.unknown = why_not_counted(plan);
  const Pattern known = pattern_of(plan);
  prediction.figures = Figures(plan, known).all();
  if (plan.backend.factor == frontal().factor) {
    prediction.order = known.order;
    prediction.taken = known.taken;
  }
  return prediction;
}

}  // namespace signorini
