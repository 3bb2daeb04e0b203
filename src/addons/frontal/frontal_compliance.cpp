// A K^-1 A^T: the rows of A walk up the tree of separators.
#include <algorithm>
#include <utility>

#include "addons/frontal/frontal_factor.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Carries the rows of A up the tree, and collects what the fronts on their paths contribute.
class FrontalFactor::Walk {
 public:
  Walk(const FrontalFactor& factor, const Eigen::SparseMatrix<double, Eigen::RowMajor>& A)
      : factor_(factor),
        A_(A),
        paths_(row_paths(factor.fronts_, A_)),
        rows_(paths_.most_numbers),
        squares_(paths_.most_rows * paths_.most_rows),
        stack_(paths_.stack),
        row_(factor.fronts_.order.size()),
        column_(static_cast<std::size_t>(A.rows())),
        G_(MatrixXd::Zero(A.rows(), A.rows())) {}

  [[nodiscard]] MatrixXd run() {
    for (int number = 0; number < static_cast<int>(paths_.rows.size()); ++number)
      if (!paths_.rows[at(number)].empty()) visit(number);
    G_.triangularView<Eigen::StrictlyUpper>() = G_.transpose();
    G_ *= factor_.scale_;
    return std::move(G_);
  }

  /// Tells what run() did.
  void report(Ledger& ledger) const {
    const Index room = rows_.size() + squares_.size();
    ledger.count("operations", static_cast<long long>(operations_));
    ledger.count("stack bytes", stack_.bytes() + room * static_cast<long long>(sizeof(double)));
  }

 private:
  /// Forward elimination of the rows of A that a front knows: of its own unknowns H, of its boundary R.
  void visit(int number) {
    const Front& front = factor_.fronts_.front(number);
    const std::vector<int>& pairs = paths_.rows[at(number)];
    Eigen::Map<MatrixXd> rows(rows_.data(), front.rows(), static_cast<Index>(pairs.size()));
    rows.setZero();
    factor_.number_rows(front, row_);
    for (std::size_t k = 0; k < pairs.size(); ++k) column_[at(pairs[k])] = static_cast<int>(k);
    for (int k = 0; k < front.separator.own; ++k)
      for (ByUnknown::InnerIterator entry(A_, factor_.fronts_.order[at(front.separator.first + k)]);
           entry; ++entry)
        rows(k, column_[at(static_cast<int>(entry.row()))]) = entry.value();
    for (const int below : front.separator.below)
      if (below >= 0 && factor_.fronts_.front(below).rim() > 0) add(below, rows);
    const Columns L = factor_.columns(front);
    Eigen::Ref<MatrixXd> H = rows.topRows(front.own());
    Eigen::Ref<MatrixXd> R = rows.bottomRows(front.rim());
    if (front.own() > 0) {
      L.topRows(front.own()).triangularView<Eigen::Lower>().solveInPlace(H);
      R.noalias() -= L.bottomRows(front.rim()) * H;
      contribute(pairs, H);
      operations_ += carrying_operations(H.rows(), R.rows(), H.cols());
    }
    Eigen::Map<MatrixXd>(stack_.open(), front.rim(), rows.cols()) = R;
    stack_.keep(number);
  }

  /// Adds what the front below left of the rows of A.
  void add(int below, Eigen::Map<MatrixXd>& rows) {
    const std::vector<int>& boundary = factor_.fronts_.front(below).boundary;
    const double* from = stack_.kept(below);
    for (const int pair : paths_.rows[at(below)]) {
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
  RowPaths paths_;
  VectorXd rows_;     // room for the largest front
  VectorXd squares_;  // and for the most pairs
  FrontStack stack_;
  std::vector<int> row_;     // of the present front, by place
  std::vector<int> column_;  // of the present front, by pair
  MatrixXd G_;
  double operations_ = 0;
};

MatrixXd FrontalFactor::compliance(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) const {
  return Walk(*this, A).run();
}

MatrixXd FrontalFactor::compliance(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A,
                                   Ledger& ledger) const {
  Walk walk(*this, A);
  MatrixXd G = walk.run();
  walk.report(ledger);
  return G;
}

}  // namespace signorini
