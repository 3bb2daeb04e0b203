#include "signorini/estimate/accuracy.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/estimate/facing_marks.hpp"
#include "signorini/estimate/hindrance.hpp"
#include "signorini/estimate/marking.hpp"
#include "signorini/refinement/refine.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/steps_limit.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// A contact of fewer closed pairs is not resolved: with fewer, estimates mislead; with more, the first meshes cost more.
constexpr std::size_t fewest_closed = 6;
/// What a round leaves of the error at least: with less, estimates of coarse meshes make meshes far finer than asked for;
/// with more, there are more rounds.
constexpr double least_left = 0.25;
/// A round aims at so much of the target: at more, many fall short by a little and need another round; at less, the last
/// mesh is finer than it need be.
constexpr double aim = 0.85;
/// A mesh confirms an earlier one if it has so many times its unknowns: with fewer, two meshes that overlook the same agree;
/// with more, confirming costs more than solving.
constexpr double confirming = 1.5;
/// So many times the unknowns should leave a quarter of the error even at a corner...
constexpr Index patience = 16;
/// ... and so many halvings should close enough pairs.
constexpr int most_unresolved = 12;
/// So often all cells are halved before contact is said not to close: coarse meshes are too stiff.
constexpr int most_doubts = 2;

/// What the answer may be wrong by, if the estimate is within a factor of two: where it has a sign and is added, the sum
/// of the sizes of the parts, which can cancel by luck; of one without a sign twice it, which is no less.
double left_by(const Estimate& estimate) {
  if (!estimate.is_signed) return 2 * estimate.error;
  const ErrorParts& parts = estimate.parts;
  return std::abs(parts.interior) + std::abs(parts.gap) + std::abs(parts.reading) +
         std::abs(parts.free_boundary);
}

/// What the estimates overlook, as the last change of the value shows it: nothing while that is within what both allow
/// for. What was overlooked falls by halves at best, and no faster than unknowns grow: it is not forgotten at once.
double overlooked_since(const AccuracyRound& last, const AccuracyRound& now) {
  const double change = std::abs(now.value - last.value);
  const double allowed = last.of_estimate + now.of_estimate;
  const double coarser = static_cast<double>(last.unknowns) / static_cast<double>(now.unknowns);
  return std::max(change > allowed ? change : 0, std::max(0.5, coarser) * last.overlooked);
}

bool any_marked(const std::vector<MarkedEdges>& marks) {
  return std::any_of(marks.begin(), marks.end(), [](const MarkedEdges& body) {
    return std::any_of(body.halved.begin(), body.halved.end(),
                       [](char times) { return times > 0; });
  });
}

class Loop {
 public:
  Loop(Scene scene, const Accuracy& wanted) : wanted_(wanted) {
    run_.scene = std::move(scene);
    pose(wanted.target > 0 && std::isfinite(wanted.target),
         "accuracy: expected a target above 0, got ", wanted.target);
    pose(!run_.scene.path,
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
    Solution solution = solve_to_limit(scene, model, condensed, std::move(ledger));
    const bool solved = solution.contact.report.status == Status::Solved;
    if (!solved && !run_.rounds.empty())
      return stop(text("the problem is not solved on the next mesh, of ", round.unknowns,
                       " unknowns: ", to_string(solution.contact.report.status)));
    std::optional<Estimate> estimated;
    std::vector<MarkedEdges> coarse;
    if (solved) {
      coarse = marks_where_coarse(model, solution, fewest_closed);
      if (coarse.empty()) {
        estimated = estimate(model, condensed, solution, wanted_.goal, solution.ledger);
        round.misfit = misfit(model, solution, wanted_.goal);
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
    if (last != run_.rounds.rend()) round.overlooked = overlooked_since(*last, round);
    round.error = std::max({round.of_estimate, round.overlooked, round.misfit});
  }

  /// Says how it stands.
  /// \param[out] next  scene with finer meshes
  /// \return whether that is to be solved
  bool go_on(Scene& next) {
    const AccuracyRound& now = run_.rounds.back();
    if (run_.solution.contact.report.status != Status::Solved)
      return stop("the problem is not solved on this mesh");
    if (now.error) {
      const double target = wanted_.target * std::abs(now.value);
      if (target == 0 && nothing_closes() && doubted(doubts_of_none_)) return refine(next);
      if (target == 0)
        return stop(
            text("the value is 0, which no error can be compared with",
                 nothing_closes()
                     ? "; no contact closes, also with all cells halved; if these are still too "
                       "stiff, begin with a finer mesh"
                     : ""));
      if (now.algebraic > target)
        return stop(
            "algebraic: rounding of the equations alone may do so much; a finer mesh makes it "
            "worse");
      const bool small = *now.error <= target;
      run_.met = small && confirmed();
      if (run_.met) return stop("met");
      if (reads_what_is_not_there(target)) return stop(hindrance(run_));
      if (stagnates()) return stop("refinement no longer helps: " + hindrance(run_));
      const double part =
          now.of_estimate <= target ? 1 : std::max(aim * target / now.of_estimate, least_left);
      marks_ = marks_for(run_.model, run_.solution, *run_.estimate, part, confirming);
    } else if (stagnates() && !doubted(doubts_of_few_)) {
      return stop(
          "refinement, also of all cells, does not close more pairs of a contact: it touches at "
          "points, or the meshes are too stiff");
    }
    return refine(next);
  }

  /// Marks all edges, unless that was done often enough. \return whether they are marked
  bool doubted(int& doubts) {
    if (doubts == most_doubts) return false;
    ++doubts;
    marks_.clear();
    for (const BodyModel& body : run_.model.bodies) {
      MeshEdges all = edges(body.mesh);
      const std::size_t count = all.size();
      marks_.push_back({std::move(all), std::vector<char>(count, 1)});
    }
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
    return !run_.scene.contacts.empty() && run_.solution.contact.active.empty();
  }

  /// Whether the last mesh is so much finer than one that was estimated that what both overlook would show.
  [[nodiscard]] bool confirmed() const {
    const auto unknowns = static_cast<double>(run_.rounds.back().unknowns);
    return std::any_of(run_.rounds.end() - trusted(), run_.rounds.end(),
                       [&](const AccuracyRound& round) {
                         return confirming * static_cast<double>(round.unknowns) <= unknowns;
                       });
  }

  /// Whether all but the misfit of a reading is small enough, and a finer mesh has not halved that.
  [[nodiscard]] bool reads_what_is_not_there(double target) const {
    const std::vector<AccuracyRound>& rounds = run_.rounds;
    const AccuracyRound& now = rounds.back();
    return now.misfit > target && *now.error == now.misfit && now.of_estimate <= target &&
           trusted() > 1 && now.misfit > rounds[rounds.size() - 2].misfit / 2;
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

  /// Halves what is marked, once and again. What cannot be done the second time is left for the next round.
  bool refine(Scene& next) {
    if (!any_marked(marks_)) return stop("no cell has a share of the error; " + hindrance(run_));
    std::vector<BodyModel> bodies = run_.model.bodies;
    bool finer = false;
    while (any_marked(marks_)) {
      mark_facing(run_.scene.contacts, bodies, marks_);
      std::vector<HalvedMesh> halved;
      for (std::size_t b = 0; b < bodies.size(); ++b)
        halved.push_back(halved_once(bodies[b].mesh, marks_[b]));
      const std::string obstacle = obstacle_of(halved);
      if (!obstacle.empty() && !finer) return stop(obstacle);
      if (!obstacle.empty()) break;
      for (std::size_t b = 0; b < bodies.size(); ++b) {
        bodies[b].mesh = std::move(halved[b].mesh);
        marks_[b] = std::move(halved[b].marks);
      }
      finer = true;
      ++halvings_;
    }
    next = run_.scene;
    for (std::size_t b = 0; b < bodies.size(); ++b) next.bodies[b].mesh = std::move(bodies[b].mesh);
    return true;
  }

  /// Why meshes cannot be solved; empty if they can.
  [[nodiscard]] std::string obstacle_of(const std::vector<HalvedMesh>& meshes) const {
    Index unknowns = 0;
    for (const HalvedMesh& finer : meshes) {
      try {
        check_mesh(finer.mesh);
      } catch (const ProblemError& error) {
        return text(
            "geometry: the sides are too long for the curve they follow, a finer mesh "
            "would have bad cells: ",
            error.what());
      }
      unknowns += 2 * finer.mesh.n_nodes();
    }
    if (unknowns <= wanted_.most_unknowns) return {};
    return text("budget of unknowns: the next mesh would have about ", unknowns, ", and ",
                wanted_.most_unknowns, " are allowed; ", hindrance(run_));
  }

  const Accuracy& wanted_;
  AccurateSolution run_;
  std::vector<MarkedEdges> marks_;
  int halvings_ = 0;
  int doubts_of_none_ = 0;  // how often all cells were halved because nothing closed...
  int doubts_of_few_ = 0;   // ... or too few pairs
};

}  // namespace

AccurateSolution solve_to_accuracy(Scene scene, const Accuracy& wanted,
                                   const std::function<void(const AccuracyRound&)>& observe) {
  return Loop(std::move(scene), wanted).run(observe);
}

}  // namespace signorini
