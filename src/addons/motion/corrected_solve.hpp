// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The linear problem of an iteration, with contact forces that turn as its own solution says.
#pragma once
#include <Eigen/SparseCore>
#include <functional>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// The change of \f$ N^T\lambda + S^T\tau \f$ along a way d [force], with the forces fixed: see LinearisedModel::turned().
/// \param way    d `n` [length]
/// \param force  `n_c + n_s` lambda and tau [force]
using TurnedForces =
    std::function<Eigen::VectorXd(const Eigen::VectorXd& way, const Eigen::VectorXd& force)>;

/// Solves a linear problem whose contact forces turn with the way d that is its solution. K has at most the symmetric
/// part B of this change, and what is left is a load. It needs d, so the problem is solved up to three times with one factor: twice for d
/// alone, without refinement, and then as any other.
/// \param model      with p, which it keeps
/// \param turned     the change of contact forces
/// \param known      B `n x n`, which K has already; or without entries [force/length]
/// \param options    for the solver
/// \param condensed  with the factor and the compliance of the model; gets free displacements
/// \param ledger     goes on in the solution, with the phase `corrections`
/// \return the solution; without corrections if the second way differs from the first by more than half of it, or is not found
[[nodiscard]] Solution corrected_solve(Model& model, const TurnedForces& turned,
                                       const Eigen::SparseMatrix<double>& known,
                                       SolverOptions options, Condensed& condensed, Ledger ledger);

}  // namespace signorini
