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
// little of the way, and the difference says it. Only nodes of pairs have such forces, and only their ways change them. So a correction
// solves for these alone: in a mesh of 10 000 nodes with 50 pairs that takes a fifth of the operations of a whole solve.

#include "addons/motion/corrected_solve.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "addons/motion/moved_pairs.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/portfolio.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// A correction walks twice through the part of the factor above the unknowns of contact, and searches: more of them cost more than
/// the iteration that they save.
constexpr Index most_corrections = 12;

/// Where a tangent has a factor of rounding, ways are about 1 / epsilon times too long. Those that are longer than this, in sizes of
/// the smallest body, are such ones.
constexpr double endless = 1e8;

/// A way of the length e, in sizes of the smallest body, leaves about \f$ e^2 \f$ since the equations are not linear along it. It is
/// near enough to its own load if that leaves no more, nor more than a tenth of what a certificate counts as zero. A thousandth is
/// asked of long ways, too: a body that is about to lose its stability takes what is left over for a push.
/// \return which part of the way its load may miss [-]
double near_enough(double length) {
  return std::max(std::min(length, 0.001), certificate_tolerance / (10 * length));
}

/// Means that leave more than this of what the first way left have not come nearer: the next would not either, and a load that is as
/// wrong as none is dropped.
constexpr double come_nearer = 0.5;

/// Solves for some unknowns. \param own  each once \param factor  of K; both must outlive the solve
Factor::Solve solve_of(const std::vector<Index>& own, const Factor& factor) {
  const bool some = static_cast<Index>(own.size()) < factor.size();
  if (std::optional<Factor::Part> part = some ? factor.part(own) : std::nullopt)
    return std::move(part->solve);
  return [&own, &factor](const Eigen::Ref<const VectorXd>& load) -> VectorXd {
    VectorXd all = VectorXd::Zero(factor.size());
    all(own) = load;
    return factor.solve(all)(own);
  };
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

/// The linear problem restricted to some unknowns, before anything was added to their loads.
struct Restriction {
  const std::vector<Index>& unknowns;
  Factor::Solve solve;  ///< for them
  VectorXd load;        ///< p `n` of all unknowns [force]
  VectorXd free;        ///< displacements without pairs `n` of all unknowns [length]

  /// The way that a state of the pairs leads to.
  [[nodiscard]] VectorXd way(const ContactState& state, const Model& model, const Condensed& condensed) const {
    const VectorXd push = model.programme.A.transpose() * all_forces(state);
    VectorXd way = condensed.free_displacement(unknowns) - solve(push(unknowns));
    if (state.amplitude.size() > 0)
      way += mode_shapes(model.modes)(unknowns, Eigen::all) * state.amplitude;
    return way;
  }

  /// Free displacements of other unknowns stay as they were: no row of A has them.
  void add(const VectorXd& lacking, Model& model, Condensed& condensed) const {
    model.programme.load(unknowns) = load(unknowns) + lacking;
    VectorXd there = free;
    there(unknowns) += solve(lacking);
    move_freely(model, std::move(there), condensed);
  }
};

/// Adds to p the forces that turn with the way.
/// \return whether the way came closer to its own load, or is its own load, and is not endless; else p is as it was
bool add_turned(const TurnedForces& turned, Model& model, SolverOptions& options, Condensed& condensed,
                Ledger& ledger) {
  const Ledger::Phase phase(ledger, "corrections");
  const Restriction own{turned.unknowns, solve_of(turned.unknowns, condensed.factor),
                        model.programme.load, condensed.free_displacement};
  const double size = smallest_size(model);
  MatrixXd ways(turned.unknowns.size(), most_corrections), left = ways, loads = ways;
  VectorXd guess = VectorXd::Zero(ways.rows());
  double last = 0;
  bool away = false;
  for (Index k = 0; k < most_corrections; ++k) {
    const ContactState state = in_these_units(condensed.problem, [&] {
      return solve(condensed.problem, Solver(model.solver).before({}), options);
    });
    ledger.count("claims", 1);
    last = std::numeric_limits<double>::infinity();
    if (state.report.status != SolveStatus::Solved) break;
    ways.col(k) = own.way(state, model, condensed);
    left.col(k) = ways.col(k) - guess;
    last = left.col(k).norm();
    const double length = largest(ways.col(k)) / size;
    if (last <= near_enough(length) * ways.col(k).norm()) break;
    loads.col(k) = turned.along(ways.col(k), all_forces(state));
    const bool ends = length <= endless;
    away = !ends && !loads.col(k).isZero(0);
    if (!ends) break;
    options.start = state.contact_status;
    const VectorXd weights = weights_of_least(left.leftCols(k + 1));
    guess = ways.leftCols(k + 1) * weights;
    own.add(loads.leftCols(k + 1) * weights, model, condensed);
  }
  if (guess.isZero(0)) return !away;
  const bool closer = !away && last <= come_nearer * left.col(0).norm();
  if (!closer) {
    model.programme.load = own.load;
    ledger.count("dropped", 1);
  }
  move_freely(model, condensed.factor.solve(model.programme.load), condensed);
  return closer;
}

}  // namespace

Corrected corrected_solve(Model& model, const TurnedForces& turned, SolverOptions options,
                          Condensed& condensed, Ledger ledger) {
  const VectorXd load = model.programme.load;
  const bool closer = turned.unknowns.empty() || add_turned(turned, model, options, condensed, ledger);
  Corrected corrected{solve(model, condensed, model.solver, std::move(ledger), options), closer};
  model.programme.load = load;
  return corrected;
}

}  // namespace signorini
