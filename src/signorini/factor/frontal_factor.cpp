#include "signorini/factor/frontal_factor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/factor/front.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

/// Whether a tree has each of n unknowns once, and separators that follow each other.
bool is_of(const SeparatorTree& tree, Index n) {
  std::vector<bool> seen(static_cast<std::size_t>(n), false);
  for (const int unknown : tree.order) {
    if (unknown < 0 || unknown >= n || seen[at(unknown)]) return false;
    seen[at(unknown)] = true;
  }
  Index next = 0;
  for (std::size_t s = 0; s < tree.separators.size(); ++s) {
    const Separator& separator = tree.separators[s];
    if (separator.first != next || separator.own < 0) return false;
    for (const int below : separator.below)
      if (below < -1 || below >= static_cast<int>(s)) return false;
    next += separator.own;
  }
  return next == n && static_cast<Index>(tree.order.size()) == n;
}

Index first_not_finite(const Eigen::SparseMatrix<double>& K) {
  for (Index k = 0; k < K.cols(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, k); entry; ++entry)
      if (!std::isfinite(entry.value())) return k;
  return K.cols();
}

}  // namespace

/// Works through the fronts with a stack of what those below hand to those above.
class FrontalFactor::Elimination {
 public:
  Elimination(FrontalFactor& factor, const Matrix& stiffness, const std::vector<Index>& grounded)
      : factor_(factor),
        stiffness_(stiffness),
        grounded_(grounded),
        least_(least_pivots()),
        stack_(updates()),
        row_(factor.order_.size()) {}

  /// \return the place of the first pivot that is too small, n if there is none
  Index run() {
    for (int number = 0; number < static_cast<int>(factor_.fronts_.size()); ++number) {
      const Front& front = factor_.front(number);
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
      stack_.keep(number);
    }
    return factor_.size();
  }

  [[nodiscard]] double pivot(Index place) const {
    const auto front = std::upper_bound(
        factor_.fronts_.begin(), factor_.fronts_.end(), place,
        [](Index p, const Front& f) { return p < f.separator.first + f.separator.own; });
    const Index column = place - front->separator.first;
    return factor_.columns(*front)(column, column) / factor_.scale_;
  }

 private:
  /// A pivot is a diagonal entry minus an inner product of as many terms as its row of L is long: that
  /// bounds its error.
  [[nodiscard]] VectorXd least_pivots() const {
    VectorXd terms(factor_.size());
    for (const Front& front : factor_.fronts_)
      for (int k = 0; k < front.separator.own; ++k) terms(front.separator.first + k) = k + 1;
    for (const Front& front : factor_.fronts_)
      for (const int place : front.boundary) terms(place) += static_cast<double>(front.own());
    VectorXd diagonal = stiffness_.diagonal();
    for (const Index unknown : grounded_) diagonal(unknown) *= 2;
    for (Index k = 0; k < terms.size(); ++k)
      terms(k) *= epsilon * factor_.scale_ *
                  std::abs(diagonal(factor_.order_[static_cast<std::size_t>(k)]));
    return terms;
  }

  [[nodiscard]] FrontStack updates() const {
    std::vector<Index> sizes;
    for (const Front& front : factor_.fronts_) sizes.push_back(front.rim() * front.rim());
    return factor_.stack(std::move(sizes));
  }

  /// Entries of K in the columns of a front, from the diagonal down.
  void gather(const Front& front, Eigen::Map<MatrixXd>& columns) const {
    for (int k = 0; k < front.separator.own; ++k)
      for (Matrix::InnerIterator entry(stiffness_, factor_.order_[at(front.separator.first + k)]);
           entry; ++entry) {
        const int place = factor_.place_[at(static_cast<int>(entry.row()))];
        if (place >= front.separator.first + k)
          columns(row_[at(place)], k) += factor_.scale_ * entry.value();
      }
  }

  /// Doubles the diagonal entries of grounded unknowns.
  void ground(const Front& front, Eigen::Map<MatrixXd>& columns) const {
    for (const Index unknown : grounded_) {
      const Index k = factor_.place_[static_cast<std::size_t>(unknown)] - front.separator.first;
      if (k >= 0 && k < front.own()) columns(k, k) *= 2;
    }
  }

  /// Adds the update of a front below to the one above.
  void add(int below, Eigen::Map<MatrixXd>& columns, Eigen::Map<MatrixXd>& update) {
    const std::vector<int>& boundary = factor_.front(below).boundary;
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
};

FrontalFactor::FrontalFactor(const Matrix& stiffness, const SeparatorTree& tree, Ledger& ledger,
                             const std::function<std::string(Index)>& describe,
                             const std::vector<Index>& grounded) {
  require(stiffness.rows() == stiffness.cols() && stiffness.isCompressed(),
          "FrontalFactor: need a square matrix after makeCompressed(), got ", stiffness.rows(),
          " x ", stiffness.cols());
  require(is_of(tree, stiffness.cols()), "FrontalFactor: need a tree with each of the ",
          stiffness.cols(), " unknowns once, got one of ", tree.order.size());
  const auto name = [&](Index unknown) {
    return text(unknown, describe ? " (" + describe(unknown) + ")" : "");
  };
  for (const Index unknown : grounded)
    require(unknown >= 0 && unknown < stiffness.cols(),
            "FrontalFactor: grounded unknowns are 0 to ", stiffness.cols() - 1, ", got ", unknown);
  const Eigen::Map<const VectorXd> values(stiffness.valuePtr(), stiffness.nonZeros());
  if (!values.allFinite())
    throw ProblemError(text("stiffness matrix has an entry that is no finite number at unknown ",
                            name(first_not_finite(stiffness)),
                            ": look at the material and the thickness of its body"));
  {
    const Ledger::Phase phase(ledger, "symbolic");
    analyse(stiffness, tree);
  }
  const Ledger::Phase phase(ledger, "numeric");
  Elimination elimination(*this, stiffness, grounded);
  const Index place = elimination.run();
  if (place < size()) {
    const Index unknown = order_[static_cast<std::size_t>(place)];
    throw ProblemError(
        text("stiffness matrix is singular at unknown ", name(unknown), ": pivot ",
             elimination.pivot(place), " of a diagonal entry ", stiffness.coeff(unknown, unknown),
             ". Something can move there without resistance: add a support; or the cells are too "
             "slender for double precision: use more of them"));
  }
  ledger.count("nonzeros", nonzeros());
  ledger.count("operations", static_cast<long long>(operations()));
  ledger.bytes(entries_.size() * static_cast<long long>(sizeof(double)));
}

void FrontalFactor::analyse(const Matrix& stiffness, const SeparatorTree& tree) {
  order_ = tree.order;
  place_.resize(order_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) place_[at(order_[k])] = static_cast<int>(k);
  std::vector<int> seen(order_.size(), -1);  // the last front that a place is in
  Index n_entries = 0;
  for (const Separator& separator : tree.separators) {
    const int number = static_cast<int>(fronts_.size());
    Front front{separator, {}, n_entries};
    const int end = separator.first + separator.own;
    const auto take = [&](int place) {
      if (place < end || seen[at(place)] == number) return;
      seen[at(place)] = number;
      front.boundary.push_back(place);
    };
    for (int k = separator.first; k < end; ++k)
      for (Matrix::InnerIterator entry(stiffness, order_[at(k)]); entry; ++entry)
        take(place_[at(static_cast<int>(entry.row()))]);
    for (const int below : separator.below)
      if (below >= 0)
        for (const int place : fronts_[at(below)].boundary) take(place);
    std::sort(front.boundary.begin(), front.boundary.end());
    n_entries += front.rows() * front.own();
    widest_ = std::max(widest_, front.rim());
    fronts_.push_back(std::move(front));
  }
  entries_.resize(n_entries);
  const double most = stiffness.nonZeros() > 0 ? stiffness.coeffs().abs().maxCoeff() : 1;
  int exponent = 0;
  static_cast<void>(std::frexp(most, &exponent));
  // The largest entry becomes about 1; one that has lost digits to underflow stays as it is.
  scale_ = std::ldexp(1, -std::max(exponent, std::numeric_limits<double>::min_exponent));
}

FrontStack FrontalFactor::stack(std::vector<Index> sizes) const {
  std::vector<std::array<int, 2>> below;
  for (const Front& front : fronts_) below.push_back(front.separator.below);
  return {below, std::move(sizes)};
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

void FrontalFactor::forward(VectorXd& x) const {
  VectorXd rim(widest_);
  for (const Front& front : fronts_) {
    const Columns L = columns(front);
    Eigen::Ref<VectorXd> own = x.segment(front.separator.first, front.own());
    L.topRows(front.own()).triangularView<Eigen::Lower>().solveInPlace(own);
    rim.head(front.rim()).noalias() = L.bottomRows(front.rim()) * own;
    for (std::size_t k = 0; k < front.boundary.size(); ++k)
      x(front.boundary[k]) -= rim(static_cast<Index>(k));
  }
}

void FrontalFactor::backward(VectorXd& x) const {
  VectorXd rim(widest_);
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const Columns L = columns(*front);
    Eigen::Ref<VectorXd> own = x.segment(front->separator.first, front->own());
    for (std::size_t k = 0; k < front->boundary.size(); ++k)
      rim(static_cast<Index>(k)) = x(front->boundary[k]);
    own.noalias() -= L.bottomRows(front->rim()).transpose() * rim.head(front->rim());
    L.topRows(front->own()).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
}

VectorXd FrontalFactor::solve(const Eigen::Ref<const VectorXd>& load) const {
  require(load.size() == size(), "FrontalFactor::solve: load must have ", size(),
          " entries (one per unknown), got ", load.size());
  VectorXd x(size());
  for (Index k = 0; k < size(); ++k) x(k) = load(order_[static_cast<std::size_t>(k)]);
  forward(x);
  backward(x);
  VectorXd solution(size());
  for (Index k = 0; k < size(); ++k) solution(order_[static_cast<std::size_t>(k)]) = scale_ * x(k);
  return solution;
}

Index FrontalFactor::nonzeros() const {
  Index sum = 0;
  for (const Front& front : fronts_)
    sum += front.own() * (front.own() + 1) / 2 + front.own() * front.rim();
  return sum;
}

double FrontalFactor::operations() const {
  double sum = 0;
  for (const Front& front : fronts_)
    for (Index k = 1; k <= front.own(); ++k) {
      const double below = static_cast<double>(front.rows() - k);
      sum += below * (below + 2);
    }
  return sum;
}

}  // namespace signorini
