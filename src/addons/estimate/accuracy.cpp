#include "addons/estimate/accuracy.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "addons/estimate/finer_meshes.hpp"
#include "addons/estimate/limiting_cause.hpp"
#include "addons/estimate/marking.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// A contact of fewer closed pairs is not resolved: with fewer, estimates mislead; with more, the first meshes cost more.
constexpr std::size_t fewest_closed = 6;
/// What a round leaves of the error at least: with less, estimates of coarse meshes make meshes far finer than asked for;
/// with more, there are more rounds.
constexpr double least_left = 0.125;
/// A round aims at so much of the target: at more, many fall short by a little and need another round; at less, the last
/// mesh is finer than it need be.
constexpr double aim = 0.85;
/// A mesh confirms an earlier one if it has so many times its unknowns: with fewer, two meshes that overlook the same agree;
/// with more, confirming costs more than solving.
constexpr double confirming = 2;
/// If the estimate is too large on a mesh that would confirm an earlier one, the next has so many times its nodes at least:
/// with fewer, rounds that fall short by a little cost as much as the last; with more, the last mesh is finer than it need be.
constexpr double worthwhile = 1.5;
/// So many times the unknowns should leave a quarter of the error even at a corner...
constexpr Index patience = 16;
/// ... and so many halvings should close enough pairs.
constexpr int most_unresolved = 12;
/// So often all cells are halved before contact is said not to close: coarse meshes are too stiff.
constexpr int most_full_halvings = 2;

/// What the answer may be wrong by, if the estimate is within a factor of two: where it has a sign and is added, the sum
/// of the sizes of the parts, which can cancel by luck; of one without a sign twice it, which is no less.
double left_by(const Estimate& estimate) {
  return estimate.is_signed ? estimate.parts.sizes() : 2 * estimate.error;
}

/// What the estimates overlook, as the last change of the value shows it: by how much it is beyond what both allow for.
/// The saturation falls no faster than the number of unknowns grows.
double saturation_since(const AccuracyRound& last, const AccuracyRound& now) {
  const double change = std::abs(now.value - last.value);
  const double allowed = last.of_estimate + now.of_estimate;
  const double coarser = static_cast<double>(last.unknowns) / static_cast<double>(now.unknowns);
  return std::max(change - allowed, coarser * last.saturation);
}

/// What is still to come if answers go on as from the mesh before, see solve_to_accuracy().
double to_come_since(const AccuracyRound& last, const AccuracyRound& now, bool is_signed) {
  const double coarser = static_cast<double>(last.unknowns) / static_cast<double>(now.unknowns);
  const double foreseen = std::max(now.of_estimate / last.of_estimate, least_left);
  const double left = is_signed || !(foreseen < coarser) ? coarser : foreseen;
  return left < 1 ? std::abs(now.value - last.value) * left / (1 - left) : 0;
}

class Loop {
 public:
  Loop(Scene scene, const Accuracy& wanted) : wanted_(wanted) {
    run_.scene = std::move(scene);
    require_input(wanted.target > 0 && std::isfinite(wanted.target),
                  "accuracy: expected a target above 0, got ", wanted.target);
    require_input(
        !run_.scene.path,
        "accuracy: the error of load steps is not estimated; leave the accuracy or the steps out");
  }

  AccurateSolution run(const std::function<void(const AccuracyRound&)>& observe) {
    Scene next = std::move(run_.scene);
    do {
      if (!look(std::move(next))) break;
      if (observe) observe(run_.rounds.back());
    } while (go_on(next));
    return std::move(run_);
  }

 private:
  /// Solves a scene. An answer that there is already outlives what goes wrong with a finer mesh.
  /// \return whether it is now the last answer
  bool look(Scene scene) {
    if (run_.rounds.empty()) return solve(std::move(scene));
    try {
      return solve(std::move(scene));
    } catch (const std::exception& error) {
      return stop(text("the next mesh gives no answer: ", error.what()));
    }
  }

  /// Solves a scene, and estimates the error if its mesh resolves it.
  bool solve(Scene scene) {
    const auto begin = std::chrono::steady_clock::now();
    Ledger ledger;
    AccuracyRound round;
    Model model = build(scene, ledger);
    round.unknowns = count_unknowns(model.bodies);
    const Condensed condensed = condense(model, ledger);
    Solution solution = wanted_.solve ? wanted_.solve(scene, model, condensed, std::move(ledger))
                                      : signorini::solve(model, condensed, std::move(ledger));
    const bool solved = solution.contact.report.status == SolveStatus::Solved;
    if (!solved && !run_.rounds.empty())
      return stop(text("the problem is not solved on the next mesh, of ", round.unknowns,
                       " unknowns: ", to_string(solution.contact.report.status)));
    std::optional<Estimate> estimated;
    std::vector<MarkedEdges> coarse;
    if (solved) {
      coarse = marks_where_coarse(model, solution, fewest_closed);
      if (coarse.empty()) {
        estimated = estimate(model, condensed, solution, wanted_.goal, solution.ledger);
        round.model_error = model_error(model, solution, wanted_.goal);
        describe(*estimated, solution.ledger, round);
      }
    }
    run_.scene = std::move(scene);
    run_.model = std::move(model);
    run_.solution = std::move(solution);
    run_.estimate = std::move(estimated);
    marks_ = std::move(coarse);
    round.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    run_.rounds.push_back(round);
    return true;
  }

  void describe(const Estimate& estimated, const Ledger& ledger, AccuracyRound& round) const {
    round.parts = estimated.parts;
    round.of_mesh = estimated.value;
    round.of_estimate = left_by(estimated);
    round.value = round.of_mesh + (estimated.is_signed ? estimated.error : 0);
    round.algebraic = estimated.algebraic;
    round.estimating = ledger.seconds("estimate");
    const auto last =
        std::find_if(run_.rounds.rbegin(), run_.rounds.rend(),
                     [](const AccuracyRound& other) { return other.error.has_value(); });
    if (last != run_.rounds.rend()) {
      round.saturation = saturation_since(*last, round);
      round.to_come = to_come_since(*last, round, estimated.is_signed);
    }
    round.error = std::max({round.of_estimate, round.saturation, round.to_come, round.model_error});
  }

  /// Says how it stands.
  /// \param[out] next  scene with finer meshes
  /// \return whether that is to be solved
  bool go_on(Scene& next) {
    const AccuracyRound& now = run_.rounds.back();
    if (run_.solution.contact.report.status != SolveStatus::Solved)
      return stop("the problem is not solved on this mesh");
    if (now.error) {
      const double target = wanted_.target * std::abs(now.value);
      if (is_nothing(now.value)) {
        if (nothing_closes() && halve_all(halvings_as_none_closed_)) return refine(next);
        return stop(
            text("the value is 0, which no error can be compared with",
                 nothing_closes()
                     ? "; no contact closes, also with all cells halved; if these are still too "
                       "stiff, begin with a finer mesh"
                     : ""));
      }
      if (wanted_.warnings)
        for (const std::string& warning : wanted_.warnings(run_.model, run_.solution))
          return stop(warning);
      if (now.algebraic > target)
        return stop(
            "algebraic: rounding of the equations alone may do so much; a finer mesh makes it "
            "worse");
      const bool small = *now.error <= target;
      run_.met = small && confirmed();
      if (run_.met) return stop("met");
      if (reads_what_is_not_there(target)) return stop(limiting_cause(run_));
      if (stagnates()) return stop("refinement no longer helps: " + limiting_cause(run_));
      const double part =
          now.of_estimate <= target ? 1 : std::max(aim * target / now.of_estimate, least_left);
      const double growth = part < 1 && confirmed() ? worthwhile : confirming;
      marks_ = mark_elements(run_.model, run_.solution, *run_.estimate, part, growth);
    } else if (stagnates() && !halve_all(halvings_as_few_closed_)) {
      return stop(
          "refinement, also of all cells, does not close more pairs of a contact: it touches at "
          "points, or the meshes are too stiff");
    }
    return refine(next);
  }

  /// Whether a value is 0, or what rounding leaves of terms that cancel: half of their digits.
  [[nodiscard]] bool is_nothing(double value) const {
    return std::abs(value) <=
           std::sqrt(epsilon) * terms_of(run_.model, run_.solution, wanted_.goal);
  }

  /// Marks all edges, unless that was done often enough. \return whether they are marked
  bool halve_all(int& times) {
    if (times == most_full_halvings) return false;
    ++times;
    marks_.clear();
    for (const BodyModel& body : run_.model.bodies) marks_.push_back(marked_alike(body.mesh, 1));
    return true;
  }

  bool stop(const std::string& verdict) {
    run_.verdict = verdict;
    return false;
  }

  /// How many of the last rounds have an estimate. One that was too coarse shows that the coarser ones before it did not
  /// resolve contact either, whatever they estimated, as where nothing closed yet: they confirm nothing.
  [[nodiscard]] std::ptrdiff_t trusted() const {
    const auto coarse =
        std::find_if(run_.rounds.rbegin(), run_.rounds.rend(),
                     [](const AccuracyRound& round) { return !round.error.has_value(); });
    return coarse - run_.rounds.rbegin();
  }

  [[nodiscard]] bool nothing_closes() const {
    return !run_.scene.contacts.empty() && run_.solution.contact.active().empty();
  }

  /// Whether the last mesh is so much finer than one that was estimated that what both overlook would show.
  [[nodiscard]] bool confirmed() const {
    const auto unknowns = static_cast<double>(run_.rounds.back().unknowns);
    return std::any_of(run_.rounds.end() - trusted(), run_.rounds.end(),
                       [&](const AccuracyRound& round) {
                         return confirming * static_cast<double>(round.unknowns) <= unknowns;
                       });
  }

  /// Whether all errors but the model error are small enough, and a finer mesh has not halved the model error.
  [[nodiscard]] bool reads_what_is_not_there(double target) const {
    const std::vector<AccuracyRound>& rounds = run_.rounds;
    const AccuracyRound& now = rounds.back();
    return now.model_error > target && *now.error == now.model_error && now.of_estimate <= target &&
           trusted() > 1 && now.model_error > rounds[rounds.size() - 2].model_error / 2;
  }

  /// Whether the value hardly moves and `patience` has not halved the largest error since then, or contact is still not
  /// resolved.
  [[nodiscard]] bool stagnates() const {
    const std::vector<AccuracyRound>& rounds = run_.rounds;
    if (!rounds.back().error) return halvings_ >= most_unresolved;
    if (trusted() > 1 && std::abs(rounds.back().value - rounds[rounds.size() - 2].value) >
                             wanted_.target * std::abs(rounds.back().value))
      return false;
    double largest = 0;
    for (auto round = rounds.rbegin(); round != rounds.rbegin() + trusted(); ++round) {
      largest = std::max(largest, *round->error);
      if (patience * round->unknowns <= rounds.back().unknowns)
        return *rounds.back().error > largest / 2;
    }
    return false;
  }

  /// Makes the next scene of what is marked. \return whether it is to be solved
  bool refine(Scene& next) {
    if (!any_marked(marks_))
      return stop("no cell has a share of the error; " + limiting_cause(run_));
    FinerMeshes finer = finer_meshes(run_.scene.contacts, run_.model.bodies, std::move(marks_),
                                     wanted_.most_unknowns);
    if (finer.halvings == 0)
      return stop(finer.obstacle + (finer.too_many ? "; " + limiting_cause(run_) : ""));
    halvings_ += finer.halvings;
    next = run_.scene;
    for (std::size_t b = 0; b < next.bodies.size(); ++b)
      next.bodies[b].mesh = std::move(finer.meshes[b]);
    return affordable(next, finer.unknowns);
  }

  /// Whether the next mesh takes no longer than it may. Its seconds are those of the last by the forecasts of both, which
  /// are made only if the cube of the unknowns, of which contact may cost as much, says that it might.
  bool affordable(const Scene& next, Index unknowns) {
    const double last = run_.rounds.back().seconds;
    const double growth =
        static_cast<double>(unknowns) / static_cast<double>(run_.rounds.back().unknowns);
    if (last * std::pow(growth, 3) <= wanted_.most_seconds) return true;
    double seconds = last * std::pow(growth, 3);
    if (wanted_.forecast) try {
        seconds = last * wanted_.forecast(next) / wanted_.forecast(run_.scene);
      } catch (const std::exception& error) {
        return stop(text("the next mesh gives no answer: ", error.what()));
      }
    if (seconds <= wanted_.most_seconds) return true;
    double paid = 0;
    for (const AccuracyRound& round : run_.rounds) paid += round.seconds;
    run_.too_dear = unknowns;
    return stop(text("price: the next mesh, of about ", unknowns, " unknowns, would take some ",
                     number(seconds, "%.2g"), " s by the forecast, and all meshes so far took ",
                     number(paid, "%.2g"), " s; ", limiting_cause(run_)));
  }

  const Accuracy& wanted_;
  AccurateSolution run_;
  std::vector<MarkedEdges> marks_;
  int halvings_ = 0;
  int halvings_as_none_closed_ = 0;  // how often all cells were halved because nothing closed...
  int halvings_as_few_closed_ = 0;   // ... or too few pairs
};

}  // namespace

AccurateSolution solve_to_accuracy(Scene scene, const Accuracy& wanted,
                                   const std::function<void(const AccuracyRound&)>& observe) {
  return Loop(std::move(scene), wanted).run(observe);
}

}  // namespace signorini
