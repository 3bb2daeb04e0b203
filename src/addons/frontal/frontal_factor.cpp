#include "addons/frontal/frontal_factor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "addons/frontal/front.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/triangular.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Index first_not_finite(const Eigen::SparseMatrix<double>& K) {
  for (Index k = 0; k < K.cols(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, k); entry; ++entry)
      if (!std::isfinite(entry.value())) return k;
  return K.cols();
}

/// Has the processor fetch numbers that will be read next: it foresees walks up the memory, not those down.
void fetch(const Eigen::Map<const MatrixXd>& numbers) {
  constexpr Index line = 64 / sizeof(double);  // what one fetch brings
  for (Index k = 0; k < numbers.size(); k += line) __builtin_prefetch(numbers.data() + k);
}

}  // namespace

double stiffness_scale(const Eigen::SparseMatrix<double>& K) {
  const double most = K.nonZeros() > 0 ? K.coeffs().abs().maxCoeff() : 1;
  int exponent = 0;
  static_cast<void>(std::frexp(most, &exponent));
  return std::ldexp(1, -std::max(exponent, std::numeric_limits<double>::min_exponent));
}

/// Works through the fronts with a stack of what those below hand to those above.
class FrontalFactor::Elimination {
 public:
  Elimination(FrontalFactor& factor, const Matrix& stiffness, const std::vector<Index>& grounded)
      : factor_(factor),
        stiffness_(stiffness),
        grounded_(grounded),
        least_(least_pivots()),
        stack_(factor.fronts_.update_stack()),
        row_(factor.fronts_.order.size()) {}

  /// \return the place of the first pivot that is too small, n if there is none
  Index run() {
    for (int number = 0; number < static_cast<int>(factor_.fronts_.all.size()); ++number) {
      const Front& front = factor_.fronts_.front(number);
      Eigen::Map<MatrixXd> columns(factor_.entries_.data() + front.begin, front.rows(),
                                   front.own());
      Eigen::Map<MatrixXd> update(stack_.open(), front.rim(), front.rim());
      columns.setZero();
      update.setZero();
      factor_.number_rows(front, row_);
      gather(front, columns);
      ground(front, columns);
      for (const int below : front.separator.below)
        if (below >= 0) add(below, columns, update);
      const Index first = front.separator.first;
      const Index done = eliminate(columns, update, least_.segment(first, front.own()));
      if (done < front.own()) return first + done;
      operations_ += elimination_operations(columns.cols(), update.rows());
      stack_.keep(number);
    }
    return factor_.size();
  }

  /// Tells what run() did.
  void report(Ledger& ledger) const {
    ledger.count("operations", static_cast<long long>(operations_));
    ledger.count("stack bytes", stack_.bytes());
  }

  [[nodiscard]] double pivot(Index place) const {
    const Front& front = factor_.fronts_.front(factor_.fronts_.front_at(static_cast<int>(place)));
    const Index column = place - front.separator.first;
    return factor_.columns(front)(column, column) / factor_.scale_;
  }

 private:
  /// A pivot is a diagonal entry minus an inner product of as many terms as its row of L is long: that
  /// bounds its error.
  [[nodiscard]] VectorXd least_pivots() const {
    VectorXd terms(factor_.size());
    for (const Front& front : factor_.fronts_.all)
      for (int k = 0; k < front.separator.own; ++k) terms(front.separator.first + k) = k + 1;
    for (const Front& front : factor_.fronts_.all)
      for (const int place : front.boundary) terms(place) += static_cast<double>(front.own());
    VectorXd diagonal = stiffness_.diagonal();
    for (const Index unknown : grounded_) diagonal(unknown) *= 2;
    for (Index k = 0; k < terms.size(); ++k)
      terms(k) *= epsilon * factor_.scale_ *
                  std::abs(diagonal(factor_.fronts_.order[static_cast<std::size_t>(k)]));
    return terms;
  }

  /// Entries of K in the columns of a front, from the diagonal down.
  void gather(const Front& front, Eigen::Map<MatrixXd>& columns) const {
    for (int k = 0; k < front.separator.own; ++k)
      for (Matrix::InnerIterator entry(stiffness_,
                                       factor_.fronts_.order[at(front.separator.first + k)]);
           entry; ++entry) {
        const int place = factor_.fronts_.place[at(static_cast<int>(entry.row()))];
        if (place >= front.separator.first + k)
          columns(row_[at(place)], k) += factor_.scale_ * entry.value();
      }
  }

  /// Doubles the diagonal entries of grounded unknowns.
  void ground(const Front& front, Eigen::Map<MatrixXd>& columns) const {
    for (const Index unknown : grounded_) {
      const Index k =
          factor_.fronts_.place[static_cast<std::size_t>(unknown)] - front.separator.first;
      if (k >= 0 && k < front.own()) columns(k, k) *= 2;
    }
  }

  /// Adds the update of a front below to the one above.
  void add(int below, Eigen::Map<MatrixXd>& columns, Eigen::Map<MatrixXd>& update) {
    const std::vector<int>& boundary = factor_.fronts_.front(below).boundary;
    const Index own = columns.cols();
    to_.resize(boundary.size());
    std::transform(boundary.begin(), boundary.end(), to_.begin(),
                   [&](int place) { return row_[at(place)]; });
    const double* from = stack_.kept(below);
    for (std::size_t j = 0; j < to_.size(); ++j, from += to_.size()) {
      const bool eliminated = to_[j] < own;
      const Index shift = eliminated ? 0 : own;
      double* column = eliminated ? &columns(0, to_[j]) : &update(0, to_[j] - own);
      for (std::size_t i = j; i < to_.size(); ++i) column[to_[i] - shift] += from[i];
    }
  }

  FrontalFactor& factor_;
  const Matrix& stiffness_;
  const std::vector<Index>& grounded_;
  VectorXd least_;
  FrontStack stack_;
  std::vector<int> row_;  // of the present front, by place
  std::vector<int> to_;   // rows of the front above
  double operations_ = 0;
};

FrontalFactor::FrontalFactor(const Matrix& stiffness, const SeparatorTree& tree, Ledger& ledger,
                             const std::function<std::string(Index)>& describe,
                             const std::vector<Index>& grounded) {
  {
    const Ledger::Phase phase(ledger, "symbolic");
    fronts_ = fronts_of(stiffness, tree);
    whole_ = {fronts_.place, std::vector<int>(fronts_.all.size()), fronts_.solve_operations()};
    std::iota(whole_.fronts.begin(), whole_.fronts.end(), 0);
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
  Elimination elimination(*this, stiffness, grounded);
  const Index place = elimination.run();
  if (place < size()) {
    const Index unknown = fronts_.order[static_cast<std::size_t>(place)];
    throw ProblemError(
        text("stiffness matrix is singular at unknown ", name(unknown), ": pivot ",
             elimination.pivot(place), " of a diagonal entry ", stiffness.coeff(unknown, unknown),
             ". Something can move there without resistance: add a support; or the cells are too "
             "slender for double precision: use more of them"));
  }
  ledger.count("nonzeros", nonzeros());
  elimination.report(ledger);
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
  for (const Index unknown : unknowns) {
    require_argument(unknown >= 0 && unknown < size(), "FrontalFactor::part: unknowns are 0 to ",
                     size() - 1, ", got ", unknown);
    part.places.push_back(fronts_.place[static_cast<std::size_t>(unknown)]);
    part.fronts.push_back(fronts_.front_at(part.places.back()));
  }
  std::sort(part.fronts.begin(), part.fronts.end());
  part.fronts.erase(std::unique(part.fronts.begin(), part.fronts.end()), part.fronts.end());
  for (const int number : part.fronts)
    part.solve_operations += fronts_.front(number).solve_operations();
  return part;
}

void FrontalFactor::forward(VectorXd& x, const std::vector<int>& fronts) const {
  VectorXd numbers(fronts_.tallest);
  for (const int number : fronts) {
    const Front& front = fronts_.front(number);
    Eigen::Ref<VectorXd> own = x.segment(front.separator.first, front.own());
    if ((own.array() == 0).all()) continue;  // nothing to hand on
    Eigen::Ref<VectorXd> rows = numbers.head(front.rows());
    rows << own, VectorXd::Zero(front.rim());
    solve_lower(columns(front), rows);
    own = rows.head(front.own());
    for (std::size_t k = 0; k < front.boundary.size(); ++k)
      x(front.boundary[k]) += rows(front.own() + static_cast<Index>(k));
  }
}

void FrontalFactor::backward(VectorXd& x, const std::vector<int>& fronts) const {
  VectorXd numbers(fronts_.tallest);
  for (auto number = fronts.rbegin(); number != fronts.rend(); ++number) {
    const Front& front = fronts_.front(*number);
    Eigen::Ref<VectorXd> own = x.segment(front.separator.first, front.own());
    Eigen::Ref<VectorXd> rows = numbers.head(front.rows());
    rows.head(front.own()) = own;
    for (std::size_t k = 0; k < front.boundary.size(); ++k)
      rows(front.own() + static_cast<Index>(k)) = x(front.boundary[k]);
    if (number + 1 != fronts.rend()) fetch(columns(fronts_.front(number[1])));
    solve_lower_transposed(columns(front), rows);
    own = rows.head(front.own());
  }
}

VectorXd FrontalFactor::solve(const Eigen::Ref<const VectorXd>& load) const {
  require_argument(load.size() == size(), "FrontalFactor::solve: load must have ", size(),
                   " entries (one per unknown), got ", load.size());
  return solve(whole_, load);
}

VectorXd FrontalFactor::solve(const Part& part, const Eigen::Ref<const VectorXd>& load) const {
  const Index count = static_cast<Index>(part.places.size());
  require_argument(load.size() == count, "FrontalFactor::solve: load must have ", count,
                   " entries (one per unknown of the part), got ", load.size());
  VectorXd x(size());  // of which only what the fronts know is ever looked at
  for (const int number : part.fronts) {
    const Front& front = fronts_.front(number);
    x.segment(front.separator.first, front.own()).setZero();
    for (const int place : front.boundary) x(place) = 0;
  }
  for (Index k = 0; k < count; ++k) x(part.places[static_cast<std::size_t>(k)]) = load(k);
  forward(x, part.fronts);
  backward(x, part.fronts);
  VectorXd solution(count);
  for (Index k = 0; k < count; ++k)
    solution(k) = scale_ * x(part.places[static_cast<std::size_t>(k)]);
  return solution;
}

}  // namespace signorini
