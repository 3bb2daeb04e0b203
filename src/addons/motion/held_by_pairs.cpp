// # Tangents that are not positive definite
//
// A block of rubber between rough plates is stable when it is pressed to half of its height. Its tangent is not positive
// definite from a sixth on: without the plates it would buckle, and the tangent does not know of the plates. Their hold is
// in the rows of contact. So it is put into K, where the factor sees it:
// \f[ K + \rho A_c^T A_c, \qquad p + \rho A_c^T g_c \f]
// with the rows c of pairs that press. If they do hold, \f$ A_c u = g_c \f$, both sides of \f$ Ku = p - A^T\lambda \f$ have got
// the same, and neither u nor \f$ \lambda \f$ is another. By hand: K = -1, one row A = 1, g = 0 and p = 2 have u = 0 and the
// force 2. With \f$ \rho = 3 \f$ the matrix is 2, positive, and u = 0 with the force 2 solves that too.

#include "addons/motion/held_by_pairs.hpp"

#include "signorini/contact/gaps.hpp"
#include "signorini/core/index.hpp"

namespace signorini {

using Eigen::Index;

std::vector<Index> held_rows(const std::vector<ContactStatus>& statuses, const FrictionLaw& law) {
  std::vector<Index> rows;
  const Index pairs = static_cast<Index>(statuses.size());
  for (Index pair = 0; pair < pairs; ++pair)
    if (statuses[at(pair)] != ContactStatus::Open) rows.push_back(pair);
  for (std::size_t k = 0; k < law.pair.size(); ++k)
    if (statuses[at(law.pair[k])] == ContactStatus::Stick)
      rows.push_back(pairs + static_cast<Index>(k));
  return rows;
}

Eigen::SparseMatrix<double> hold_by_pairs(const std::vector<Index>& rows, double stiffness,
                                          QuadraticProgramme& programme) {
  const NodalRows held = selected_rows(programme.A, rows);
  programme.load += stiffness * (held.transpose() * programme.initial_gap(rows));
  return stiffness * (held.transpose() * held);
}

}  // namespace signorini
