// # Linear about a place
//
// Where the bodies stand, forces, gaps and slips are written anew, and count from there. Two sets of numbers must not be mixed
// up. The way d of an iteration counts from the place, and ends at 0. What a scene is told, displacements, counts from the scene.
// So the last thing that is done is to count anew.
//
// Supports give what they have left with the first way. It is a load of the linear problem: the tangent of the cells that they
// hold, times what is left.

#include "addons/motion/linearised_model.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "addons/equations/take_equations.hpp"
#include "addons/motion/moved_pairs.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/residual.hpp"
#include "signorini/scene/balance.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// How far the unknowns have moved, less the mean of their body: a body that is carried far is no better measured by that. At
/// least so much that certificate_tolerance of it is the rounding of places: bodies that only touch, and bear nothing, leave no more.
VectorXd moved_within(const Model& model, const Displaced& at) {
  NodeArray moved = at.high;
  for (const BodyModel& body : model.bodies) {
    auto own = moved.middleRows(body.first_node, body.mesh.n_nodes());
    const double farthest =
        body.mesh.nodes.cwiseAbs().maxCoeff() + own.cwiseAbs().maxCoeff();
    own.rowwise() -= own.colwise().mean().eval();
    own = own.cwiseAbs().cwiseMax(rounding_of_places(0, farthest) / certificate_tolerance).eval();
  }
  return restricted(model.unknowns, moved);
}

/// The displacements of a body less that of its first node; in axial symmetry a shift along the radius strains, and stays.
NodeArray less_carried(const BodyModel& body, const Displaced& at) {
  const auto high = at.high.middleRows(body.first_node, body.mesh.n_nodes());
  Eigen::RowVector2d carried = high.row(0);
  if (is_axial(body)) carried.x() = 0;
  return NodeArray(high.rowwise() - carried) + at.low.middleRows(body.first_node, body.mesh.n_nodes());
}

/// What supports still have to give.
NodeArray left_to_give(const Unknowns& unknowns, const Displaced& at) {
  return (unknowns.number < 0).select((unknowns.held - at.high) - at.low, 0);
}

/// Those of nodes that have rows, and those that equations have put into the rows in the place of others. A normal along an axis has no
/// entry across it, but across it nodes turn it.
std::vector<Index> unknowns_of_pairs(const Model& model) {
  std::set<Index> all;
  for (Index pair = 0; pair < model.programme.A.rows(); ++pair)
    for (NodalRows::InnerIterator entry(model.programme.A, pair); entry; ++entry)
      all.insert(entry.col());
  for (Index pair = 0; pair < model.pairs.opening.rows(); ++pair)
    for (NodalRows::InnerIterator entry(model.pairs.opening, pair); entry; ++entry)
      for (const Index axis : {0, 1})
        if (const Index k = model.unknowns.number(entry.col() / 2, axis); k >= 0) all.insert(k);
  return {all.begin(), all.end()};
}

}  // namespace

Model without_stiffness(Model& model) {
  Eigen::SparseMatrix<double> aside;
  aside.swap(model.programme.stiffness);
  Model copy = model;
  aside.swap(model.programme.stiffness);
  return copy;
}

LinearisedModel::LinearisedModel(const PlacePairs& place, const Displaced& before, Model& model)
    : place_(place),
      before_(before),
      model_(model),
      bodies_(model),
      stiffness_(model.programme.stiffness),
      load_(model.programme.load),
      outer_(outer_forces(model)),
      at_(before) {}

bool LinearisedModel::arrived() const { return left_to_give(model_.unknowns, at_).isZero(0); }

void LinearisedModel::move(const Displaced& there, Ledger& ledger) {
  QuadraticProgramme& programme = model_.programme;
  const NodeArray left = left_to_give(model_.unknowns, there);
  const bool rest = there.high.isZero(0) && there.low.isZero(0);
  BodyAnswer answer;
  if (!rest) {
    const Ledger::Phase phase(ledger, "forces");
    answer = bodies_.at(model_, there, left, finite() ? &tangent_ : nullptr);
  }
  {
    const Ledger::Phase phase(ledger, "pairs");
    ledger.count("searches", 1);
    place_(there, before_, model_);
  }
  at_ = there;
  if (rest) return;
  if (finite()) programme.stiffness.swap(tangent_);
  programme.load = outer_ - answer.force - answer.ahead;
  programme.reached = {moved_within(model_, at_), std::move(answer.terms)};
  if (model_.equations) take_equations_of_forces(at_, finite(), model_);
}

// What supports give is gone to its end exactly.
Displaced LinearisedModel::ahead(const PrimalDual& way, double share) const {
  Displaced there = at_;
  const Unknowns& unknowns = model_.unknowns;
  const NodeArray left = left_to_give(unknowns, at_);
  for (Index node = 0; node < there.high.rows(); ++node)
    for (const Index axis : {0, 1}) {
      const Index k = unknowns.number(node, axis);
      double& high = there.high(node, axis);
      double& low = there.low(node, axis);
      add_to(high, low, share * (k >= 0 ? way.displacement(k) : left(node, axis)));
      if (k >= 0 && way.displacement_low.size() > 0)
        add_to(high, low, share * way.displacement_low(k));
      if (k < 0 && share == 1) {
        high = unknowns.held(node, axis);
        low = 0;
      }
    }
  return there;
}

TurnedForces LinearisedModel::turned(double look) const {
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& A = model_.programme.A;
  const std::vector<Index> own = unknowns_of_pairs(model_);
  auto along = [this, &A, own, look, there = without_stiffness(model_)](
                   const VectorXd& way, const VectorXd& force) mutable -> VectorXd {
    VectorXd all = VectorXd::Zero(A.cols());
    all(own) = way;
    const double share = std::min(1.0, look / largest(way));
    try {
      place_(ahead({all, {}, {}}, share), before_, there);
    } catch (const ProblemError&) {
      return VectorXd::Zero(way.size());
    }
    if (there.programme.A.rows() != A.rows() || names_of_pairs(there) != names_of_pairs(model_))
      return VectorXd::Zero(way.size());
    const VectorXd load = (A - there.programme.A).transpose() * force;
    return load(own) / share;
  };
  return {own, std::move(along)};
}

Certificate LinearisedModel::certificate(const Solution& solution) const {
  if (!arrived()) return uncertified();
  const VectorXd& force = solution.refined.force;
  Certificate here =
      certify(model_.programme, {VectorXd::Zero(model_.unknowns.count), {}, force}, model_.law);
  here.balance = imbalance(model_, solution.contact, force);
  return here;
}

void LinearisedModel::conclude(Solution& solution) const {
  QuadraticProgramme& programme = model_.programme;
  solution.refined.displacement = restricted(model_.unknowns, at_.high);
  solution.refined.displacement_low = restricted(model_.unknowns, at_.low);
  solution.refined.rigid = {};
  solution.strains.clear();
  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    const BodyModel& body = model_.bodies[b];
    solution.displacements[b] = at_.high.middleRows(body.first_node, body.mesh.n_nodes());
    solution.strains.push_back(less_carried(body, at_));
  }
  count_from_the_scene(at_, model_);
  if (finite())
    programme.load += stiffness_ * solution.refined.displacement;
  else
    programme.load = load_;
}

void LinearisedModel::restore() const {
  model_.programme.stiffness = stiffness_;
  model_.order.reset();  // a step that is read from a file has none either
  model_.programme.reached = {};
}

Certificate certificate_where_it_stands(const PrimalDual& claim, Model model) {
  const Displaced at = displaced(model.unknowns, claim);
  const NodeArray still = NodeArray::Zero(at.high.rows(), 2);
  const BodyAnswer answer = BodyAnswers(model).at(model, at, still, nullptr);
  QuadraticProgramme& programme = model.programme;
  programme.initial_gap -= programme.A * restricted(model.unknowns, at.high + at.low);
  programme.load = outer_forces(model) - answer.force;
  programme.reached = {moved_within(model, at), answer.terms};
  if (model.equations) take_equations_of_forces(at, false, model);
  return certify(programme, {VectorXd::Zero(claim.displacement.size()), {}, claim.force},
                 model.law);
}

}  // namespace signorini
