#include "addons/frontal/backend.hpp"

#include <algorithm>

#include "signorini/core/errors.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

std::vector<MissingBackend> missing_backends() {
  std::vector<MissingBackend> missing = {SIGNORINI_OTHER_BACKENDS};
  const auto built = [](const MissingBackend& one) {
    return std::any_of(backends().begin(), backends().end(),
                       [&](const Backend& backend) { return backend.name == one.name; });
  };
  missing.erase(std::remove_if(missing.begin(), missing.end(), built), missing.end());
  for (MissingBackend& one : missing)
    one.needed += ": install them with tools/setup.sh parallel, then type make";
  return missing;
}

const Backend& find_backend(const std::string& name) {
  std::vector<std::string> names;
  for (const Backend& backend : backends()) {
    if (backend.name == name) return backend;
    names.emplace_back(backend.name);
  }
  std::string needed;
  for (const MissingBackend& missing : missing_backends()) {
    if (missing.name == name) needed = ", which is not built; it needs " + missing.needed;
    names.push_back(missing.name);
  }
  throw ProblemError(text("unknown back end ", in_quotes(name),
                          needed.empty() ? suggestion(name, names) : needed));
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
  static_cast<void>(frontal().factor(stiffness, unused));  // throws unless it is held
}

void refuse(const Stiffness& stiffness, const char* backend) {
  Ledger unused;
  static_cast<void>(frontal().factor(stiffness, unused));
  throw ProblemError(text("back end ", backend,
                          ": it could not factor the stiffness matrix, which ", frontal().name,
                          " can: leave out --backend"));
}

}  // namespace signorini
