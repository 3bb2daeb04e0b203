// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Systems that nothing connects are solved one by one.
#pragma once
#include <vector>

#include "addons/certified/certified_solve.hpp"
#include "signorini/problem/systems.hpp"

namespace signorini {

/// The certified_solve() of each system, put together.
///
/// Rounding, scales and steps of one system are then none of another: loads of 1 and 1e-13 side by side are solved
/// like each of them alone. The status is that of the first system that is not solved, iterations add up, the
/// certificate has the worst figures.
/// \param programme     K, p, A, g as they were posed; slips in the last rows of A
/// \param condensed     made of it
/// \param null_vectors  N `n x n_r`, or nothing
/// \param systems       unconnected_systems() of these
/// \param solver        a member that takes such problems
/// \param options       handed to it
/// \param ledger        gets what each system adds
/// \return the end of all; without numbers if one system has none
/// \throws ProblemError, std::invalid_argument as the solver
[[nodiscard]] CertifiedSolution separate_solutions(const QuadraticProgramme& programme,
                                                   const CondensedProgramme& condensed,
                                                   const Eigen::MatrixXd& null_vectors,
                                                   const std::vector<SystemParts>& systems,
                                                   const Solver& solver,
                                                   const SolverOptions& options, Ledger& ledger);

/// \param systems  any
/// \return rows of the system that has most of them; 0 of none
[[nodiscard]] Eigen::Index largest_of(const std::vector<SystemParts>& systems);

/// \param programme  K and A
/// \param law        of the frictional pairs
/// \return what they say: valid until K, the entries of A that are not 0, or the pairs of the law change
[[nodiscard]] KnownMatrices known_matrices(const QuadraticProgramme& programme,
                                           const FrictionLaw& law);

}  // namespace signorini
