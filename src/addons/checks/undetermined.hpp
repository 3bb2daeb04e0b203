// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Which forces of a solution are not determined by it: a certificate holds for others as well.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/problem/certificate.hpp"
#include "signorini/problem/shared_forces.hpp"

namespace signorini {

/// A solution, and what its forces do.
struct Carried {
  /// `n x (n_c + n_s)`: forces that differ by f with `effect` f = 0 belong to the same movements
  Eigen::SparseMatrix<double> effect;
  FrictionLaw law;           ///< of the frictional pairs
  Eigen::VectorXd force;     ///< `n_c + n_s` [force]
  Eigen::VectorXd movement;  ///< `n_c + n_s`: gaps, then slips [length]
  Eigen::VectorXd rounding;  ///< `n_c + n_s`: a movement up to it is none [length]
  std::vector<ContactStatus>
      statuses;  ///< `n_c` what the pairs do: a closed pair has no gap, a sticking one no slip
  Eigen::Index equations = 0;  ///< so many of the first rows have forces of any sign
};

/// A solution of a programme; a movement counts as zero if it is at most as many roundings as check_signs() allows.
/// \param programme  A and g, slips in the last rows of A
/// \param solution   u and the forces of all rows
/// \param law        of the frictional pairs
/// \param statuses    `n_c` what the pairs do
/// \return all of it, for undetermined_forces()
[[nodiscard]] Carried carried(const QuadraticProgramme& programme, const PrimalDual& solution,
                              const FrictionLaw& law, std::vector<ContactStatus> statuses);

/// A solution of a condensed problem, or any M and q: other forces must move no gap and no slip.
/// \param problem  as it was posed
/// \param state    Solved
/// \return all of it, for undetermined_forces()
[[nodiscard]] Carried carried(const ContactProblem& problem, const ContactState& state);

/// Finds the forces that a solution leaves open.
///
/// Given the movements, the forces are a point of a polyhedron: what they do to the bodies is given, A^T f; open pairs
/// have none, closed ones lambda >= 0, where a pair slides tau = -b or b, and where it does not \f$ |\tau| \le b \f$.
/// They are determined if this polyhedron is a point. Otherwise columns of A^T depend on each other, as those
/// of a node in two contacts with friction, of a contact listed twice, or of more Gauss points than nodes. The exchanges, a
/// basis of \f$ A^T \Delta f = 0 \f$, are found by elimination: a column depends on those before it if what is left
/// of it is at most certificate_tolerance of the largest term that made it. Exchanges that have a pair in common
/// belong together, and for each of these groups every force is driven to both ends by Polyhedron. A slack that is at
/// most certificate_tolerance of the largest force counts as zero.
///
/// A pair with cohesion that touches and is open counts as open: closing it changes its bound.
/// \param carried  a solution
/// \param work     operations that all ranges together may take; what is beyond is not looked for
/// \return groups with forces that are not determined, with the widest range first; none if all are
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] std::vector<SharedForces> undetermined_forces(const Carried& carried,
                                                            double work = 1e8);

}  // namespace signorini
