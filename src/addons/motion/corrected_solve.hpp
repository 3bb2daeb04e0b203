// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The linear problem of an iteration, with contact forces that turn as its own solution says.
#pragma once
#include <functional>
#include <vector>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// What the matrix of a linear problem lacks, as a load: the change of \f$ N^T\lambda + S^T\tau \f$ along a way with
/// the forces fixed, see LinearisedModel::turned().
struct TurnedForces {
  std::vector<Eigen::Index> unknowns = {};  ///< that the load knows and changes, rising; none: there is no such load
  /// The load on them [force], of d of them [length] and all of lambda and tau `n_c + n_s` [force].
  std::function<Eigen::VectorXd(const Eigen::VectorXd& way, const Eigen::VectorXd& force)> along = {};
};

/// What became of a linear problem.
struct Corrected {
  Solution solution;   ///< in the way d
  bool closer = true;  ///< whether corrections led closer to a way that is its own load; else the solution is without them
};

/// Solves a linear problem whose contact forces turn with the way d that is its solution. They are a load, which needs d, so the
/// problem is solved up to a dozen times with one factor, without refinement and of the unknowns of that load alone, and then once
/// as any other.
/// \param model      with p, which it keeps
/// \param turned     what the load lacks
/// \param options    for the solver
/// \param condensed  with the factor and the compliance of the model; gets free displacements
/// \param ledger     goes on in the solution, with the phase `corrections`
/// \return the solution
[[nodiscard]] Corrected corrected_solve(Model& model, const TurnedForces& turned,
                                        SolverOptions options, Condensed& condensed,
                                        Ledger ledger);

}  // namespace signorini
