// # The seam to the linear solver
//
// Contact asks two things of a stiffness matrix, and these are all that a factor must know:
//
// \f[ u = K^{-1}p \qquad\text{and}\qquad G = A K^{-1} A^T. \f]
//
// The first is the body without contact. The second is the *compliance* of the pairs: column
// \f$j\f$ says how far the gaps open when a force of 1 presses pair \f$j\f$. With \f$n\f$ unknowns
// and \f$n_c\f$ pairs it is \f$n_c \times n_c\f$, and from there on the methods of contact work
// with it alone.
//
// A factor is a bundle of functions, so that our sparse Cholesky factor, the frontal one of an
// add-on and a library that works with many processes look alike. The sizes of what goes in are
// checked here, once, and no back end repeats it.

#include "signorini/fem/factor.hpp"

#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

VectorXd Factor::solve(const Eigen::Ref<const VectorXd>& load) const {
  require_argument(load.size() == size(), "Factor::solve: load must have ", size(),
                   " entries (one per unknown), got ", load.size());
  return solve_(load);
}

std::optional<Factor::Part> Factor::part(const std::vector<Index>& unknowns) const {
  if (!parts_) return {};
  return parts_(unknowns);
}

Eigen::MatrixXd Factor::compliance(const Rows& A, Ledger& ledger) const {
  require_argument(A.cols() == size(), "Factor::compliance: A must have ", size(),
                   " columns (one per unknown), got ", A.cols());
  return compliance_(A, ledger);
}

// A program fills the family in its first lines. A table in the library would have to name the
// add-ons, and whoever links the library would link all of them.
const std::vector<Backend>& backends() { return open_family<Backend>(); }

void add_backend(const Backend& member) { add_member(member, open_family<Backend>()); }

Backend default_backend() { return backends().empty() ? sparse_cholesky() : backends().front(); }

}  // namespace signorini
