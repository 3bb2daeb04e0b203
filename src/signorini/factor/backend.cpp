#include "signorini/factor/backend.hpp"

#include <map>
#include <set>

#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd Factor::solve(const Eigen::Ref<const VectorXd>& load) const {
  require(load.size() == size(), "Factor::solve: load must have ", size(),
          " entries (one per unknown), got ", load.size());
  return solve_(load);
}

std::optional<Factor::Part> Factor::part(const std::vector<Index>& unknowns) const {
  if (!parts_) return {};
  return parts_(unknowns);
}

Eigen::MatrixXd Factor::compliance(const Rows& A, Ledger& ledger) const {
  require(A.cols() == size(), "Factor::compliance: A must have ", size(),
          " columns (one per unknown), got ", A.cols());
  return compliance_(A, ledger);
}

const Backend& find_backend(const std::string& name) {
  // Those of cmake/Backends.cmake, here too for programs that are built without them.
  static const std::map<std::string, const char*> packages = {
      {"cholmod", "libsuitesparse-dev"}, {"mumps", "libmumps-dev and libopenmpi-dev"}};
  try {
    return find_member(backends(), name, "back end");
  } catch (const ProblemError& error) {
    const auto known = packages.find(name);
    if (known == packages.end()) {
      std::set<std::string> names;
      for (const Backend& backend : backends()) names.insert(backend.name);
      for (const auto& [other, needed] : packages) names.insert(other);
      throw ProblemError(text("unknown back end ", in_quotes(name),
                              suggestion(name, {names.begin(), names.end()})));
    }
    throw ProblemError(text(error.what(), ". It needs ", known->second,
                            ": install them with tools/setup.sh parallel, then type make"));
  }
}

void check_held(const Stiffness& stiffness, const Factor::Solve& solve) {
  const Eigen::SparseMatrix<double>& K = stiffness.matrix;
  const Index n = K.cols();
  if (n == 0) return;
  const VectorXd root = VectorXd(K.diagonal()).cwiseSqrt();
  Random random(1);
  VectorXd load = root;
  for (Index k = 0; k < n; ++k)
    if (random.whole(0, 1) == 0) load(k) = -load(k);
  const VectorXd moved = solve(load).cwiseProduct(root);
  if (moved.allFinite() && epsilon * static_cast<double>(n) * largest(moved) < 1) return;
  Ledger unused;
  static_cast<void>(backends().front().factor(stiffness, unused));  // throws unless it is held
}

void refuse(const Stiffness& stiffness, const char* backend) {
  Ledger unused;
  static_cast<void>(backends().front().factor(stiffness, unused));
  throw ProblemError(text("back end ", backend,
                          ": it could not factor the stiffness matrix, which ",
                          backends().front().name, " can: leave out --backend"));
}

}  // namespace signorini
