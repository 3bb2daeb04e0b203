// A K^-1 A^T: the rows of A walk up the tree of separators.
#include <algorithm>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/factor/frontal_factor.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

}  // namespace

/// Carries the rows of A up the tree, and collects what the fronts on their paths contribute.
class FrontalFactor::Walk {
 public:
  Walk(const FrontalFactor& factor, const Eigen::SparseMatrix<double, Eigen::RowMajor>& A)
      : factor_(factor),
        A_(A),
        pairs_(pairs_of_fronts()),
        stack_(handed_on()),
        row_(factor.order_.size()),
        column_(static_cast<std::size_t>(A.rows())),
        G_(MatrixXd::Zero(A.rows(), A.rows())) {}

  [[nodiscard]] MatrixXd run() {
    for (int number = 0; number < static_cast<int>(factor_.fronts_.size()); ++number)
      if (!pairs_[at(number)].empty()) visit(number);
    G_.triangularView<Eigen::StrictlyUpper>() = G_.transpose();
    G_ *= factor_.scale_;
    return std::move(G_);
  }

 private:
  /// Whether there is a front, and anything that it is joined to.
  [[nodiscard]] bool hands_on(int below) const {
    return below >= 0 && factor_.front(below).rim() > 0;
  }

  /// The rows of A that have an entry in a front, or below it in what it is joined to; rising.
  [[nodiscard]] std::vector<std::vector<int>> pairs_of_fronts() const {
    std::vector<std::vector<int>> pairs(factor_.fronts_.size());
    std::vector<int> seen(static_cast<std::size_t>(A_.rows()), -1);
    for (int number = 0; number < static_cast<int>(pairs.size()); ++number) {
      const Separator& separator = factor_.front(number).separator;
      const auto take = [&](int pair) {
        if (std::exchange(seen[at(pair)], number) != number) pairs[at(number)].push_back(pair);
      };
      for (int k = 0; k < separator.own; ++k)
        for (ByUnknown::InnerIterator entry(A_, factor_.order_[at(separator.first + k)]); entry;
             ++entry)
          take(static_cast<int>(entry.row()));
      for (const int below : separator.below)
        if (hands_on(below)) std::for_each(pairs[at(below)].begin(), pairs[at(below)].end(), take);
      std::sort(pairs[at(number)].begin(), pairs[at(number)].end());
    }
    return pairs;
  }

  [[nodiscard]] FrontStack handed_on() {
    std::vector<Index> sizes;
    Index most = 0;
    Index most_pairs = 0;
    for (int number = 0; number < static_cast<int>(pairs_.size()); ++number) {
      const Index pairs = static_cast<Index>(pairs_[at(number)].size());
      sizes.push_back(factor_.front(number).rim() * pairs);
      most = std::max(most, factor_.front(number).rows() * pairs);
      most_pairs = std::max(most_pairs, pairs);
    }
    rows_.resize(most);
    squares_.resize(most_pairs * most_pairs);
    return factor_.stack(std::move(sizes));
  }

  /// Forward elimination of the rows of A that a front knows: of its own unknowns H, of its boundary R.
  void visit(int number) {
    const Front& front = factor_.front(number);
    const std::vector<int>& pairs = pairs_[at(number)];
    Eigen::Map<MatrixXd> rows(rows_.data(), front.rows(), static_cast<Index>(pairs.size()));
    rows.setZero();
    factor_.number_rows(front, row_);
    for (std::size_t k = 0; k < pairs.size(); ++k) column_[at(pairs[k])] = static_cast<int>(k);
    for (int k = 0; k < front.separator.own; ++k)
      for (ByUnknown::InnerIterator entry(A_, factor_.order_[at(front.separator.first + k)]); entry;
           ++entry)
        rows(k, column_[at(static_cast<int>(entry.row()))]) = entry.value();
    for (const int below : front.separator.below)
      if (hands_on(below)) add(below, rows);
    const Columns L = factor_.columns(front);
    Eigen::Ref<MatrixXd> H = rows.topRows(front.own());
    Eigen::Ref<MatrixXd> R = rows.bottomRows(front.rim());
    if (front.own() > 0) {
      L.topRows(front.own()).triangularView<Eigen::Lower>().solveInPlace(H);
      R.noalias() -= L.bottomRows(front.rim()) * H;
      contribute(pairs, H);
    }
    Eigen::Map<MatrixXd>(stack_.open(), front.rim(), rows.cols()) = R;
    stack_.keep(number);
  }

  /// Adds what the front below left of the rows of A.
  void add(int below, Eigen::Map<MatrixXd>& rows) {
    const std::vector<int>& boundary = factor_.front(below).boundary;
    const double* from = stack_.kept(below);
    for (const int pair : pairs_[at(below)]) {
      double* column = &rows(0, column_[at(pair)]);
      for (const int place : boundary) column[row_[at(place)]] += *from++;
    }
  }

  /// Adds H^T H to the rows and columns of its pairs.
  void contribute(const std::vector<int>& pairs, const Eigen::Ref<const MatrixXd>& H) {
    if (H.cols() == G_.cols()) {
      G_.selfadjointView<Eigen::Lower>().rankUpdate(H.transpose());
      return;
    }
    Eigen::Map<MatrixXd> square(squares_.data(), H.cols(), H.cols());
    square.setZero();
    square.selfadjointView<Eigen::Lower>().rankUpdate(H.transpose());
    for (Index j = 0; j < H.cols(); ++j)
      for (Index i = j; i < H.cols(); ++i)
        G_(pairs[static_cast<std::size_t>(i)], pairs[static_cast<std::size_t>(j)]) += square(i, j);
  }

  using ByUnknown = Eigen::SparseMatrix<double>;

  const FrontalFactor& factor_;
  ByUnknown A_;  // of A, by unknown
  std::vector<std::vector<int>> pairs_;
  VectorXd rows_;     // room for the largest front
  VectorXd squares_;  // and for the most pairs
  FrontStack stack_;
  std::vector<int> row_;     // of the present front, by place
  std::vector<int> column_;  // of the present front, by pair
  MatrixXd G_;
};

MatrixXd FrontalFactor::compliance(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) const {
  require(A.cols() == size(), "FrontalFactor::compliance: A must have ", size(),
          " columns (one per unknown), got ", A.cols());
  return Walk(*this, A).run();
}

}  // namespace signorini
