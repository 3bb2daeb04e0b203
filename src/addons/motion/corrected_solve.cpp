// # What the tangent leaves out
//
// If bodies move by d, contact forces turn: those along normals by \f$ B\,d \f$, and friction by \f$ C\,d \f$. Newton's method has both
// on the left,
// \f[ (K - B - C)\,d = p - f - A^T\lambda, \f]
// but C is not symmetric, and with it the matrix would have no Cholesky factor. And B makes a matrix indefinite that was not. So both
// stand on the right, where d is known from the solution before:
// \f[ K\,d_{k+1} = p - f - A^T\lambda_{k+1} + (B + C)\,w_k, \qquad w_0 = 0. \f]
// With \f$ w_k = d_k \f$ an error becomes a share q of itself, which is a tenth at strains of a few percent, more than half at large
// ones, and above 1 where only contact holds a body. What is left over, \f$ r_k = d_{k+1} - w_k \f$, tells better. To first order
// a mean of ways leaves the mean of what these leave; so \f$ w_k \f$ is that mean, with weights that add up to 1, of which least is
// left. This is Anderson's way of 1965 [\ref Anderson1965], and where no pair changes its status it is the method of minimal residuals for
// \f$ K - B - C \f$ with K as its preconditioner. The load is linear in the way: a mean of ways has the mean of their loads.
//
// What contact forces do along d need not be derived. They are found where the bodies would stand if they went a
// little of the way, and the difference says it.

#include "addons/motion/corrected_solve.hpp"

#include <limits>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/portfolio.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// A factor costs as much as a dozen solves with it, and a correction two of them and a search: more of them cost more than
/// the iteration that they save.
constexpr Index most_corrections = 6;

/// Of a way that is this near to its own load an iteration leaves as much as the next one of Newton's method can mend.
constexpr double near_enough = 0.01;

/// Means that leave more than this of what the first way left have not come nearer: the next would not either, and a load that is as
/// wrong as none is dropped.
constexpr double come_nearer = 0.5;

/// What a method says of a linear problem, before anything is refined.
struct FirstAnswer {
  VectorXd way = {};    ///< d; empty: it was not solved
  VectorXd force = {};  ///< lambda and tau
  std::vector<ContactStatus> statuses = {};
};

FirstAnswer first_answer(const Model& model, const Condensed& condensed, const SolverOptions& options,
              Ledger& ledger) {
  const ContactState state = in_these_units(condensed.problem, [&] {
    return solve(condensed.problem, Solver(model.solver).before({}), options);
  });
  ledger.count("claims", 1);
  if (state.report.status != SolveStatus::Solved) return {};
  VectorXd force = all_forces(state);
  VectorXd way =
      condensed.factor.solve(model.programme.load - model.programme.A.transpose() * force);
  if (state.amplitude.size() > 0) way += mode_shapes(model.modes) * state.amplitude;
  return {std::move(way), std::move(force), state.contact_status};
}

void put_load(VectorXd load, Model& model, Condensed& condensed) {
  model.programme.load = std::move(load);
  move_freely(model, condensed.factor.solve(model.programme.load), condensed);
}

/// The weights, adding up to 1, with which columns leave least.
VectorXd weights_of_least(const MatrixXd& left) {
  const Index last = left.cols() - 1;
  VectorXd weights = VectorXd::Ones(last + 1);
  if (last == 0) return weights;
  weights.head(last) =
      least_norm_solution(left.leftCols(last).colwise() - left.col(last), -left.col(last));
  weights(last) = 1 - weights.head(last).sum();
  return weights;
}

}  // namespace

Corrected corrected_solve(Model& model, const TurnedForces& turned, SolverOptions options,
                          Condensed& condensed, Ledger ledger) {
  if (!turned) return {solve(model, condensed, model.solver, std::move(ledger), options)};
  bool closer = true;
  const VectorXd load = model.programme.load;
  {
    const Ledger::Phase phase(ledger, "corrections");
    MatrixXd ways(load.size(), most_corrections);
    MatrixXd left(load.size(), most_corrections);
    MatrixXd loads(load.size(), most_corrections);
    VectorXd guess = VectorXd::Zero(load.size());
    double last = 0;
    for (Index k = 0; k < most_corrections; ++k) {
      const FirstAnswer answer = first_answer(model, condensed, options, ledger);
      const bool found = answer.way.size() > 0;
      if (found) left.col(k) = answer.way - guess;
      last = found ? left.col(k).norm() : std::numeric_limits<double>::infinity();
      if (!found || last <= near_enough * answer.way.norm()) break;
      ways.col(k) = answer.way;
      loads.col(k) = turned(answer.way, answer.force);
      options.start = answer.statuses;
      const VectorXd weights = weights_of_least(left.leftCols(k + 1));
      guess = ways.leftCols(k + 1) * weights;
      put_load(load + loads.leftCols(k + 1) * weights, model, condensed);
    }
    closer = guess.isZero(0) || last <= come_nearer * left.col(0).norm();
    if (!closer) {
      put_load(load, model, condensed);
      ledger.count("dropped", 1);
    }
  }
  Solution solution = solve(model, condensed, model.solver, std::move(ledger), options);
  model.programme.load = load;
  return {std::move(solution), closer};
}

}  // namespace signorini
