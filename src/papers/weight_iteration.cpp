// # Better weights, step by step
//
// At the weights \f$ \xi \f$ the pairs still overlap by \f$ b - \eta G\xi \f$, and the slope of s
// is \f$ \eta \f$ times that. The linear programme (28) of the paper, the largest linear increase
// over the simplex, is solved by looking for the largest overlap: all weight goes to that pair.
// Taken literally this hops. In the example of [surrogate_dual.cpp](surrogate_dual.cpp) pair 1
// alone leaves pair 2 an overlap of \f$ 5 - 7/2 = 3/2 \f$, and pair 2 alone leaves pair 1 an
// overlap of \f$ 7 - 5/2 = 9/2 \f$: each vertex answers with the other, for ever, although the
// solution needs both.
//
// As a direction the vertex is right. From equal weights towards the first vertex the five numbers
// of the line are \f$ b_0 = 6,\ b_1 = 1,\ c_0 = 3/2,\ c_1 = 0,\ c_2 = 1/2 \f$, and the best step is
// \f[ t = \frac{b_0 c_1 - b_1 c_0}{b_1 c_1 - b_0 c_2} = \frac{-3/2}{-3} = \frac12, \f]
// which arrives at the solution (3/4, 1/4). With more pairs it takes more steps, and the rules
// differ in how they avoid going to and fro.

#include "papers/weight_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

// The last rule starts at the vertex with the largest overlap, because a face begins with one
// vertex. The others start in the middle.
WeightIteration::WeightIteration(const ContactProblem& problem, WeightRule rule)
    : problem_(problem),
      rule_(rule),
      root_(problem.compliance.diagonal().cwiseMax(0.0).cwiseSqrt()),
      weights_(start_weights(problem)),
      face_(problem),
      visited_(static_cast<std::size_t>(problem.free_gap.size())) {
  Index best = 0;
  const bool one_vertex = rule == WeightRule::FullyCorrective && weights_.sum() > 0;
  if (one_vertex && problem.free_gap.minCoeff(&best) < 0) take_in(best);
  renew();
  evaluate();
}

// A step changes \f$ G\xi \f$ by a column of G or two, which costs little and collects rounding. Now and
// then, and in the last rule at every step, it is computed anew.
void WeightIteration::renew() {
  if (weights_.size() > 0 && weights_.sum() > 0) weights_ /= weights_.sum();
  product_.noalias() = problem_.compliance * weights_;
}

// All that a step asks for: the weighted overlap, the total force, s, and what every pair still
// overlaps by.
// If the weights move no pair and still overlap, the total force is infinite, and the overlaps are
// those without contact.
void WeightIteration::evaluate() {
  const double weighted = -problem_.free_gap.dot(weights_);
  compliance_ = weights_.dot(product_);
  total_force_ = weighted > 0 ? weighted / compliance_ : 0;
  value_ = 0.5 * weighted * total_force_;
  overlap_ = -problem_.free_gap;
  if (std::isfinite(total_force_)) overlap_ -= total_force_ * product_;
}

// s cannot grow by more than about \f$ \eta \f$ times the largest overlap. Divided by s this is a
// number without unit, which says when to stop.
double WeightIteration::relative_gap() const {
  const double worst = overlap_.size() > 0 ? overlap_.maxCoeff() : 0;
  if (worst <= 0) return 0;
  return value_ > 0 && std::isfinite(value_) ? total_force_ * worst / value_
                                             : std::numeric_limits<double>::infinity();
}

// An end has a reason, and the caller has only to know that nothing moved.
bool WeightIteration::stop(WeightEnd why) {
  end_ = why;
  return false;
}

// Before it moves, a step looks for two ends. Weights that move no pair and still overlap prove
// that the gaps contradict each other. And if no pair overlaps by more than the rounding of its own
// terms, all conditions hold.
// All rules but the literal and the harmonic one raise s with every step. If s falls by more than rounding
// nevertheless, the iteration ends.
bool WeightIteration::step() {
  if (end_ != WeightEnd::None) return false;
  if (weights_.size() == 0) return stop(WeightEnd::Optimal);
  const double n = static_cast<double>(weights_.size());
  const double rounding = n * epsilon;
  const double size = root_.dot(weights_);
  if (problem_.free_gap.dot(weights_) < 0 &&
      (product_.array().abs() <= rounding * size * root_.array()).all()) {
    infeasibility_ = weights_;
    return stop(WeightEnd::Unbounded);
  }
  Index best = 0;  // the vertex that (28) returns: the most violated pair
  overlap_.maxCoeff(&best);
  const double terms = std::abs(problem_.free_gap(best)) + total_force_ * root_(best) * size;
  if (overlap_(best) <= rounding * terms) return stop(WeightEnd::Optimal);
  if (rule_ == WeightRule::FullyCorrective) return correct(best);
  if (rule_ == WeightRule::LiteralVertex) return jump(best);
  const Direction towards = direction(best);
  const double length = step_length(towards);
  if (length == 0) return stop(WeightEnd::Still);
  const double before = value_;
  move(towards, length);
  if (++steps_ % weights_.size() == 0) renew();
  evaluate();
  if (rule_ != WeightRule::Harmonic && value_ < before * (1 - rounding))
    return stop(WeightEnd::Still);
  return true;
}

// A vertex alone determines the next one. So the first that comes back closes a cycle, and there is
// no point in going on.
bool WeightIteration::jump(Index best) {
  if (visited_[static_cast<std::size_t>(best)]) return stop(WeightEnd::Repeats);
  visited_[static_cast<std::size_t>(best)] = true;
  move({best, best, 1, 0, -1, 1}, 1);
  evaluate();
  return true;
}

// The last rule needs no length of a step: the face takes the vertex in and moves to its best point.
// Each of these points is better than the one before, and there are finitely many faces, so this
// rule ends by itself.

// [face step]
bool WeightIteration::correct(Index best) {
  const double before = value_;
  if (!take_in(best)) return false;
  renew();
  evaluate();
  return value_ > before || stop(WeightEnd::Still);
}

bool WeightIteration::take_in(Index vertex) {
  if (face_.add(vertex)) {
    weights_ = face_.forces();
    return true;
  }
  infeasibility_ = face_.farkas_certificate();
  return stop(WeightEnd::Unbounded);
}
// [face step]

// A direction is \f$ \delta = p\,e_{to} - q\,e_{from} + r\,\xi \f$. Towards a vertex it is
// \f$ e_{to} - \xi \f$, with steps up to 1. Away from the vertex that is wanted least it is
// \f$ \xi - e_{from} \f$; its weight w becomes \f$ w(1 + t) - t \f$, which vanishes at
// \f$ t = w/(1 - w) \f$. We go away if the gap of that vertex is larger than the largest overlap.
// The pairwise rule moves weight from one vertex to another, at most all of it.
WeightIteration::Direction WeightIteration::direction(Index best) const {
  const Direction towards{best, best, 1, 0, -1, 1};
  if (rule_ != WeightRule::AwaySteps && rule_ != WeightRule::Pairwise) return towards;
  Index worst = best;  // of the vertices in use
  for (Index i = 0; i < weights_.size(); ++i)
    if (weights_(i) > 0 && (weights_(worst) == 0 || overlap_(i) < overlap_(worst))) worst = i;
  const double weight = weights_(worst);
  if (rule_ == WeightRule::Pairwise) return {best, worst, 1, 1, 0, weight};
  if (weight >= 1 || -overlap_(worst) <= overlap_(best)) return towards;
  return {worst, worst, 0, 1, 1, weight / (1 - weight)};
}

// The five numbers of the line follow from \f$ b^T\xi \f$, \f$ \xi^T G\xi \f$ and the vector
// \f$ G\xi \f$, which are at hand, and three entries of G. No product with G is needed.
double WeightIteration::step_length(const Direction& along) const {
  if (rule_ == WeightRule::Harmonic) return 2 / static_cast<double>(steps_ + 2);
  const auto [to, from, p, q, r, largest] = along;
  const Eigen::MatrixXd& G = problem_.compliance;
  const Eigen::VectorXd& d = problem_.free_gap;
  const double weighted = -d.dot(weights_);
  const WeightLine line{weighted, r * weighted - p * d(to) + q * d(from), compliance_,
                        r * compliance_ + p * product_(to) - q * product_(from),
                        r * r * compliance_ + p * p * G(to, to) + q * q * G(from, from) -
                            2 * p * q * G(to, from) +
                            2 * r * (p * product_(to) - q * product_(from))};
  return best_step(line, largest);
}

// A vertex that gives away all its weight gets exactly zero: otherwise it would stay in use for
// ever.
void WeightIteration::move(const Direction& along, double step) {
  const auto [to, from, p, q, r, largest] = along;
  weights_ *= 1 + r * step;
  product_ *= 1 + r * step;
  if (p != 0) {
    weights_(to) += step;
    product_ += step * problem_.compliance.col(to);
  }
  if (q != 0) {
    weights_(from) = step < largest ? std::max(0.0, weights_(from) - step) : 0;
    product_ -= step * problem_.compliance.col(from);
  }
}

// Figures show which pairs carry weight. They want all steps, not only the last.
// Rows are taken as they come. The paper scales none, surrogate_dual() scales all: the caller decides.
std::vector<std::vector<Index>> weight_supports(const ContactProblem& problem, WeightRule rule,
                                                Index limit) {
  check_plain(problem, "weight_supports");
  WeightIteration run(problem, rule);
  std::vector<std::vector<Index>> supports;
  do {
    supports.emplace_back();
    for (Index i = 0; i < problem.free_gap.size(); ++i)
      if (run.weights()(i) > 0) supports.back().push_back(i);
  } while (static_cast<Index>(supports.size()) <= limit && run.step());
  return supports;
}

}  // namespace signorini
