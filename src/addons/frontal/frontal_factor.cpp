#include "addons/frontal/frontal_factor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

namespace {

Index first_not_finite(const Eigen::SparseMatrix<double>& K) {
  for (Index k = 0; k < K.cols(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, k); entry; ++entry)
      if (!std::isfinite(entry.value())) return k;
  return K.cols();
}

}  // namespace

double stiffness_scale(const Eigen::SparseMatrix<double>& K) {
  const double most = K.nonZeros() > 0 ? K.coeffs().abs().maxCoeff() : 1;
  int exponent = 0;
  static_cast<void>(std::frexp(most, &exponent));
  return std::ldexp(1, -std::max(exponent, std::numeric_limits<double>::min_exponent));
}

FrontalFactor::FrontalFactor(const Matrix& stiffness, const SeparatorTree& tree, Ledger& ledger,
                             const std::function<std::string(Index)>& describe,
                             const std::vector<Index>& grounded) {
  {
    const Ledger::Phase phase(ledger, "symbolic");
    fronts_ = fronts_of(stiffness, tree);
    solve_operations_ = fronts_.solve_operations();
  }
  const auto name = [&](Index unknown) {
    return text(unknown, describe ? " (" + describe(unknown) + ")" : "");
  };
  for (const Index unknown : grounded)
    require_argument(unknown >= 0 && unknown < stiffness.cols(),
                     "FrontalFactor: grounded unknowns are 0 to ", stiffness.cols() - 1, ", got ",
                     unknown);
  const Eigen::Map<const VectorXd> values(stiffness.valuePtr(), stiffness.nonZeros());
  if (!values.allFinite())
    throw ProblemError(text("stiffness matrix has an entry that is no finite number at unknown ",
                            name(first_not_finite(stiffness)),
                            ": look at the material and the thickness of its body"));
  const Ledger::Phase phase(ledger, "numeric");
  entries_.resize(fronts_.entries);
  scale_ = stiffness_scale(stiffness);
  const Index place = eliminated(stiffness, grounded);
  if (place < size()) {
    const Index unknown = fronts_.order[static_cast<std::size_t>(place)];
    throw ProblemError(
        text("stiffness matrix is singular at unknown ", name(unknown), ": pivot ", pivot(place),
             " of a diagonal entry ", stiffness.coeff(unknown, unknown),
             ". Something can move there without resistance: add a support; or the cells are too "
             "slender for double precision: use more of them"));
  }
  ledger.count("nonzeros", nonzeros());
  ledger.count("operations", static_cast<long long>(operations()));
  ledger.count("stack bytes",
               fronts_.update_stack().most() * static_cast<long long>(sizeof(double)));
  ledger.bytes(entries_.size() * static_cast<long long>(sizeof(double)));
}

SeparatorTree FrontalFactor::tree() const {
  SeparatorTree tree{fronts_.order, {}};
  for (const Front& front : fronts_.all) tree.separators.push_back(front.separator);
  return tree;
}

/// Numbers the rows of a front, by place: its own unknowns, then its boundary.
void FrontalFactor::number_rows(const Front& front, std::vector<int>& row) const {
  const auto own = row.begin() + front.separator.first;
  std::iota(own, own + front.separator.own, 0);
  int next = front.separator.own;
  for (const int place : front.boundary) row[at(place)] = next++;
}

FrontalFactor::Columns FrontalFactor::columns(const Front& front) const {
  return {entries_.data() + front.begin, front.rows(), front.own()};
}

FrontalFactor::Part FrontalFactor::part(const std::vector<Index>& unknowns) const {
  Part part;
  std::vector<bool> taken(fronts_.all.size(), false);
  for (const Index unknown : unknowns) {
    require_argument(unknown >= 0 && unknown < size(), "FrontalFactor::part: unknowns are 0 to ",
                     size() - 1, ", got ", unknown);
    part.places.push_back(fronts_.place[at(unknown)]);
    int place = part.places.back();
    while (place >= 0) {  // from its front to those above, which it hands on to
      const int number = fronts_.front_at(place);
      const Front& front = fronts_.front(number);
      if (taken[at(number)]) break;
      taken[at(number)] = true;
      part.fronts.push_back(number);
      part.solve_operations += front.solve_operations();
      place = front.boundary.empty() ? -1 : front.boundary.front();
    }
  }
  std::sort(part.fronts.begin(), part.fronts.end());
  return part;
}

}  // namespace signorini
