#include "support/checked_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/index.hpp"

namespace signorini_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;

VectorField times(double factor, const VectorField& field) {
  if (!field) return {};
  return [=](const Eigen::Vector2d& x) { return Eigen::Vector2d(factor * field(x)); };
}

/// 1 without a name, which it takes away.
double taken(const Path& path, double time, std::string& history) {
  const std::string name = std::exchange(history, {});
  for (const History& known : path.histories)
    if (known.name == name) return known.at(time);
  return 1;
}

/// Slips in total of the frictional pairs.
VectorXd slips_of(const Model& model, const VectorXd& held, const PrimalDual& found) {
  const Index pairs = model.pairs.weight.size();
  VectorXd slips(static_cast<Index>(model.law.pair.size()));
  for (Index k = 0; k < slips.size(); ++k) {
    long double sum = 0;
    for (NodalRows::InnerIterator it(model.pairs.sliding, model.law.pair[at(k)]); it; ++it)
      sum += static_cast<long double>(it.value()) * held(it.col());
    for (NodalRows::InnerIterator it(model.programme.A, pairs + k); it; ++it) {
      const long double low =
          found.displacement_low.size() > 0 ? found.displacement_low(it.col()) : 0;
      sum -= it.value() * (found.displacement(it.col()) + low);
    }
    slips(k) = static_cast<double>(sum);
  }
  return slips;
}

double ratio(double part, double whole) {
  return part == 0 ? 0 : whole > 0 ? part / whole : HUGE_VAL;
}

}  // namespace

Scene at_time(const Scene& scene, double time) {
  Scene now = scene;
  now.path.reset();
  const auto factor = [&](std::string& history) { return taken(*scene.path, time, history); };
  for (Body& body : now.bodies) {
    Loads& loads = body.loads;
    for (EdgeLoad& load : loads.edges) {
      const double f = factor(load.history);
      load.pressure *= f;
      load.traction = times(f, load.traction);
    }
    for (PointForce& load : loads.points) load.force *= factor(load.history);
    loads.body_force = times(factor(loads.body_force_history), loads.body_force);
    for (Support& support : body.supports)
      support.displacement = times(factor(support.history), support.displacement);
    if (!body.temperature) continue;
    const double f = factor(body.temperature->history);
    body.temperature->uniform *= f;
    body.temperature->gradient *= f;
  }
  for (ContactSpec& contact : now.contacts)
    if (contact.interference) *contact.interference *= factor(contact.interference_history);
  return now;
}

SceneErrors CheckedPath::add(const Model& model, const Step& step) {
  const PathState& state = step.state;
  const PrimalDual& found = state.solution;
  Ledger ledger;
  Model now = build(at_time(scene_, state.time), ledger);
  // A support along the contact that stands still then leaves nothing to slide, so the rows are those of the path.
  now.law = model.law;
  now.programme.A = model.programme.A;
  const Index pairs = now.pairs.weight.size();
  const Eigen::Map<const VectorXd> held(now.unknowns.held.data(), now.unknowns.held.size());
  const VectorXd slip = slips_of(now, held, found);
  if (slip_.size() == 0) slip_.setZero(slip.size());
  VectorXd& gap = now.programme.initial_gap;
  gap.resize(pairs + slip.size());
  gap.head(pairs) = now.pairs.initial_gap;
  if (slip.size() > 0)
    gap.tail(slip.size()) = selected_rows(now.pairs.sliding, now.law.pair) * held - slip_;
  SceneErrors errors = check_scene(now, step.solution, length_);

  const double length = errors.length;
  double force = 0;
  for (Index k = 0; k < slip.size(); ++k) {
    const double increment = slip(k) - slip_(k);
    const double friction = std::abs(found.force(pairs + k));
    force += friction;
    dissipation_ += friction * std::abs(increment);
    grow(errors.reading, ratio(std::abs(state.slip(k) - slip(k)), length));
    grow(errors.reading, ratio(std::abs(state.increment(k) - increment), length));
  }
  most_ = std::max({most_, dissipation_, force * length});
  grow(errors.reading, ratio(std::abs(state.dissipation.sum() - dissipation_), most_));
  slip_ = slip;
  length_ = length;

  meter_.add(model, step);
  const Work& work = meter_.work();
  for (const double term :
       {work.loads, work.supports, work.contacts, work.strain, work.dissipation})
    turnover_ = std::max(turnover_, std::abs(term));
  grow(missing_, std::abs(work.put_in() - work.strain - work.dissipation - work.between));
  const VectorXd squares = found.displacement.cwiseAbs2();
  rounding_ += 0x1p-52 * squares.dot(now.programme.stiffness.diagonal());
  return errors;
}

double CheckedPath::imbalance() const {
  return missing_ <= rounding_ ? 0 : ratio(missing_, turnover_);
}

}  // namespace signorini_test
