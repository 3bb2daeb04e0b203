#include "addons/certified/proofs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "addons/certified/bounded_least_squares.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// The resultants that contact can give: one edge of each friction cone on either side, and then the tangential
/// direction of each cohesive pair, of which only so much can be had; with cohesion the load counts from -c.
BoundedWeights cone_generators(const ScaledProblem& problem) {
  const Index pairs = problem.pairs();
  const Index slips = problem.law.coefficient.size();
  const Index cohesive = (problem.law.cohesion.array() > 0).count();
  BoundedWeights all{
      MatrixXd(pairs + slips + cohesive, problem.rigid.cols()),
      VectorXd::Constant(pairs + slips + cohesive, std::numeric_limits<double>::infinity()),
      problem.resultant};
  all.direction.topRows(pairs) = problem.rigid.topRows(pairs);
  Index last = pairs + slips;
  for (Index k = 0; k < slips; ++k) {
    const Index pair = problem.law.pair[at(k)];
    const double mu = problem.law.coefficient(k);
    const double c = problem.law.cohesion(k);
    all.direction.row(pair) += mu * problem.rigid.row(pairs + k);
    all.direction.row(pairs + k) = problem.rigid.row(pair) - mu * problem.rigid.row(pairs + k);
    if (!(c > 0)) continue;
    all.direction.row(last) = problem.rigid.row(pairs + k);
    all.target += c * problem.rigid.row(pairs + k).transpose();
    all.most(last++) = 2 * c;
  }
  return all;
}

/// Whether amplitudes prove that nothing balances r, on any data; sums in twice the working precision.
bool is_unbounded_direction(const MatrixXd& rigid, const VectorXd& resultant,
                            const FrictionLaw& law, const VectorXd& way) {
  const Index pairs = rigid.rows() - static_cast<Index>(law.pair.size());
  ExactVector sum(VectorXd::Zero(rigid.rows()));
  sum.add_products(rigid.transpose(), way);
  const VectorXd moved = sum.value();
  const VectorXd size = rigid.cwiseAbs() * way.cwiseAbs();
  ExactSum work;
  for (Index j = 0; j < way.size(); ++j) work.add_product(resultant(j), way(j));
  double terms = resultant.cwiseAbs().dot(way.cwiseAbs());
  VectorXd opening = moved.head(pairs);
  VectorXd rounding = VectorXd::Constant(pairs, proof_rounding * largest(size));
  for (Index k = 0; k < law.coefficient.size(); ++k) {
    const Index pair = law.pair[at(k)];
    const double slip = std::abs(moved(pairs + k));
    opening(pair) -= law.coefficient(k) * slip;
    rounding(pair) *= 1 + law.coefficient(k);
    work.add_product(law.cohesion(k), slip);
    terms += law.cohesion(k) * slip;
  }
  return (opening.array() >= -rounding.array()).all() && work.value() < -proof_rounding * terms;
}

/// An unbounded direction that holds for the modes and the load as posed too; only the rows are measured in the units of the
/// problem.
VectorXd posed_unbounded_direction(const ContactProblem& problem, const ScaledProblem& scaled) {
  const VectorXd way = unbounded_direction(scaled);
  if (way.size() == 0) return {};
  const MatrixXd rigid = scaled.scale.asDiagonal() * problem.rigid;
  return is_unbounded_direction(rigid, problem.resultant, scaled.law, way) ? way : VectorXd();
}

}  // namespace

VectorXd farkas_certificate(const ScaledProblem& problem) {
  const Index n = problem.pairs();
  BoundedWeights gaps{MatrixXd(2 * n, n),
                      VectorXd::Constant(2 * n, std::numeric_limits<double>::infinity()),
                      problem.free};
  gaps.direction << MatrixXd::Identity(n, n), -problem.compliance.transpose();
  VectorXd y = bounded_least_squares(gaps);
  const double rounding = static_cast<double>(2 * n) * epsilon * largest(y);
  y = (y.array() > rounding).select(y, 0.0);  // what is no rounding shows in F^T y
  if (y.isZero(0)) return {};
  y /= y.sum();
  return verify_farkas(as_posed(problem), y) ? VectorXd(problem.scale.cwiseProduct(y)) : VectorXd();
}

VectorXd unbounded_direction(const ScaledProblem& problem) {
  if (problem.unconstrained_resultant.size() > 0) return problem.unconstrained_resultant;
  if (problem.rigid.cols() == 0 || problem.resultant.isZero(0)) return {};
  const BoundedWeights all = cone_generators(problem);
  const VectorXd way = bounded_least_squares(all);
  // What is left of the load where rounding is all that is left proves nothing.
  if (!way.allFinite() || way.norm() <= proof_rounding * all.target.norm() ||
      !is_unbounded_direction(problem.rigid, problem.resultant, problem.law, way))
    return {};
  return problem.inverse * way;
}

double balanced_share(const ContactProblem& problem, const VectorXd& before) {
  require_argument(before.size() == problem.resultant.size(), "balanced_share: the load has ",
                   problem.resultant.size(), " resultants, but what it grows from ", before.size());
  const Index pairs = problem.free_gap.size();
  double share = 1;
  for (ContactProblem now = problem;;) {
    const VectorXd way = posed_unbounded_direction(now, equilibrate(now));
    if (way.size() == 0) break;
    ExactSum held, growth;
    for (Index j = 0; j < way.size(); ++j) {
      held.add_product(before(j), way(j));
      growth.add_product(problem.resultant(j), way(j));
      growth.add_product(-before(j), way(j));
    }
    for (Index k = 0; k < problem.law.cohesion.size(); ++k)
      held.add_product(problem.law.cohesion(k), std::abs(problem.rigid.row(pairs + k).dot(way)));
    if (!(held.value() > 0)) return 0;
    const double next = held.value() / -growth.value();
    if (!(next < share)) break;  // a proof that rounding alone could improve
    share = next;
    now.resultant = before + share * (problem.resultant - before);
  }
  return share;
}

std::optional<ContactState> infeasible_resultant(const ContactProblem& problem,
                                                 const ScaledProblem& scaled) {
  VectorXd way = posed_unbounded_direction(problem, scaled);
  if (way.size() == 0) return std::nullopt;
  ContactState state;
  fill_state(problem.law, statuses_of({}, scaled.pairs()), VectorXd::Zero(scaled.free.size()),
             free_movement(problem), state);
  state.amplitude = VectorXd::Zero(problem.resultant.size());
  state.report.status = SolveStatus::Infeasible;
  if (!problem.law.pair.empty())
    state.reason =
        "no contact forces within their friction bounds balance the load: the body moves away";
  state.unbounded_direction = std::move(way);
  return state;
}

bool proves_infeasible(const QuadraticProgramme& programme, const VectorXd& y, const VectorXd& u,
                       Index equations) {
  const Index m = y.size();
  require_argument(u.size() == programme.load.size(), "proves_infeasible: need ",
                   programme.load.size(), " displacements, got ", u.size());
  if (m == 0 || m > programme.initial_gap.size() || m < equations || !y.allFinite() ||
      (y.tail(m - equations).array() < 0).any())
    return false;
  ExactSum work;
  ExactVector moved(VectorXd::Zero(u.size()));
  const Eigen::SparseMatrix<double> columns = programme.A.transpose();
  for (Index i = 0; i < m; ++i) {
    work.add_product(programme.initial_gap(i), y(i));
    moved.add_product(columns, i, y(i));
  }
  const double movement = moved.value().cwiseProduct(u).lpNorm<1>();
  const double rounding = epsilon * programme.initial_gap.head(m).cwiseAbs().dot(y.cwiseAbs());
  return -work.value() > static_cast<double>(m) * rounding &&
         -work.value() * std::sqrt(epsilon) > movement;
}

}  // namespace signorini
