#include "signorini/fem/factor.hpp"

#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

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

namespace {

std::vector<Backend>& family() {
  static std::vector<Backend> members;
  return members;
}

}  // namespace

const std::vector<Backend>& backends() { return family(); }

void add_backend(const Backend& member) { add_member(member, family()); }

Backend default_backend() { return backends().empty() ? sparse_cholesky() : backends().front(); }

}  // namespace signorini
