// A K^-1 A^T: the rows of A walk up the tree of separators.
#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "addons/frontal/frontal_factor.hpp"
#include "addons/frontal/threads.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/parts.hpp"

namespace signorini {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Carries the rows of A up the tree, and collects what the fronts on their paths contribute.
class FrontalFactor::Walk {
 public:
  Walk(const FrontalFactor& factor, const Eigen::SparseMatrix<double, Eigen::RowMajor>& A)
      : factor_(factor),
        A_(A),
        paths_(row_paths(factor.fronts_, A_)),
        handed_(factor.fronts_.parts.size()),
        rooms_(at(threads())),
        sum_(A.rows()) {
    for (std::size_t k = 0; k < paths_.rows.size(); ++k)
      sizes_.push_back(factor.fronts_.all[k].rim() * static_cast<Index>(paths_.rows[k].size()));
  }

  [[nodiscard]] MatrixXd run() {
    up_the_tree(factor_.fronts_.parts,
                [this](int part, int worker) { work(at(part), rooms_[at(worker)]); });
    MatrixXd G = sum_.sum();
    G.triangularView<Eigen::StrictlyUpper>() = G.transpose();
    G *= factor_.scale_;
    return G;
  }

  /// Tells what run() did.
  void report(Ledger& ledger) const {
    ledger.count("operations", static_cast<long long>(paths_.operations));
    ledger.count("stack bytes", paths_.bytes());
  }

 private:
  using ByUnknown = Eigen::SparseMatrix<double>;
  /// H, R and H^T H are computed so many columns at a time, whatever the number of threads.
  static constexpr Index panel = 128;

  /// What a part of the tree adds to A K^-1 A^T.
  struct Share {
    std::vector<int> rows;  ///< of A that it is about, rising
    MatrixXd square;        ///< of them; the upper triangle is not looked at
  };

  /// Adds shares up in the order of the parts, whichever is ready first: one that comes early waits.
  class OrderedSum {
   public:
    explicit OrderedSum(Index rows) : rows_(rows) {}

    void take(std::size_t part, Share share) {
      const std::lock_guard<std::mutex> lock(mutex_);
      early_.emplace(part, std::move(share));
      for (auto next = early_.find(next_); next != early_.end(); next = early_.find(++next_)) {
        add(next->second);
        early_.erase(next);
      }
    }
    /// \return the sum, whose upper triangle is not filled
    [[nodiscard]] MatrixXd sum() {
      if (sum_.rows() < rows_) sum_ = MatrixXd::Zero(rows_, rows_);
      return std::move(sum_);
    }

   private:
    void add(Share& share) {
      const bool all = static_cast<Index>(share.rows.size()) == rows_;
      if (sum_.rows() < rows_ && all) return sum_.swap(share.square);
      if (sum_.rows() < rows_) sum_ = MatrixXd::Zero(rows_, rows_);
      for (Index j = 0; j < share.square.cols(); ++j) {
        double* const column = &sum_(0, share.rows[at(j)]);
        for (Index i = j; i < share.square.rows(); ++i)
          column[share.rows[at(i)]] += share.square(i, j);
      }
    }

    Index rows_;
    MatrixXd sum_;
    std::mutex mutex_;
    std::size_t next_ = 0;  // part that is to be added
    std::map<std::size_t, Share> early_;
  };

  /// Of one thread.
  struct Room {
    VectorXd rows;            // of the present front
    std::vector<int> row;     // of the present front, by place
    std::vector<int> column;  // of the present front, by pair
    std::vector<int> place;   // in the share, by pair
  };

  /// Walks through the fronts of a part.
  void work(std::size_t number, Room& room) {
    const TreePart& part = factor_.fronts_.parts[number];
    const int last = part.end - 1;
    Share share{rows_of(part), {}};
    if (!share.rows.empty()) {
      const Index count = static_cast<Index>(share.rows.size());
      // The last part comes when all others are done, and adds to their sum.
      const bool above = number + 1 == factor_.fronts_.parts.size() && count == A_.rows();
      share.square = above ? sum_.sum() : MatrixXd(MatrixXd::Zero(count, count));
      room.row.resize(factor_.fronts_.order.size());
      room.column.resize(at(A_.rows()));
      room.place.resize(at(A_.rows()));
      for (std::size_t k = 0; k < share.rows.size(); ++k)
        room.place[at(share.rows[k])] = static_cast<int>(k);
      FrontStack stack(factor_.fronts_.stack(part, sizes_));
      for (int k = part.first; k < last; ++k) {
        visit(k, stack.open(), room, share,
              [&](int below) { return stack.kept(below - part.first); });
        stack.keep(k - part.first);
      }
      handed_[number].resize(sizes_[at(last)]);
      visit(last, handed_[number].data(), room, share, [&](int below) {
        return below >= part.first ? stack.kept(below - part.first)
                                   : handed_[at(factor_.fronts_.part_below(part, below))].data();
      });
      for (const int below : part.below) handed_[at(below)].resize(0);
    }
    sum_.take(number, std::move(share));
  }

  /// \return rows of A that the fronts of a part know: those of the last one, and of others that are joined to none above
  [[nodiscard]] std::vector<int> rows_of(const TreePart& part) const {
    std::vector<int> rows = paths_.rows[at(part.end - 1)];
    const std::size_t known = rows.size();
    for (int k = part.first; k + 1 < part.end; ++k)
      if (factor_.fronts_.front(k).rim() == 0)
        rows.insert(rows.end(), paths_.rows[at(k)].begin(), paths_.rows[at(k)].end());
    if (rows.size() == known) return rows;
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
  }

  /// Forward elimination of the rows of A that a front knows: of its own unknowns H, of its boundary R.
  template <typename Kept>
  void visit(int number, double* to, Room& room, Share& share, Kept&& kept) {
    const std::vector<int>& pairs = paths_.rows[at(number)];
    if (pairs.empty()) return;
    const Front& front = factor_.fronts_.front(number);
    const Index count = static_cast<Index>(pairs.size());
    if (room.rows.size() < front.rows() * count) room.rows.resize(front.rows() * count);
    Eigen::Map<MatrixXd> rows(room.rows.data(), front.rows(), count);
    rows.setZero();
    factor_.number_rows(front, room.row);
    for (std::size_t k = 0; k < pairs.size(); ++k) room.column[at(pairs[k])] = static_cast<int>(k);
    for (int k = 0; k < front.separator.own; ++k)
      for (ByUnknown::InnerIterator entry(A_, factor_.fronts_.order[at(front.separator.first + k)]);
           entry; ++entry)
        rows(k, room.column[at(static_cast<int>(entry.row()))]) = entry.value();
    for (const int below : front.separator.below)
      if (below >= 0 && factor_.fronts_.front(below).rim() > 0 && !paths_.rows[at(below)].empty())
        add(below, kept(below), room, rows);
    if (front.own() > 0) eliminate_rows(front, rows);
    if (front.own() > 0) contribute(pairs, rows.topRows(front.own()), room, share);
    Eigen::Map<MatrixXd>(to, front.rim(), count) = rows.bottomRows(front.rim());
  }

  /// H and R, panel by panel.
  void eliminate_rows(const Front& front, Eigen::Map<MatrixXd>& rows) const {
    const Columns L = factor_.columns(front);
    for_ranges(rows.cols(), panel, [&](Index begin, Index end) {
      Eigen::Ref<MatrixXd> H = rows.block(0, begin, front.own(), end - begin);
      L.topRows(front.own()).triangularView<Eigen::Lower>().solveInPlace(H);
      rows.block(front.own(), begin, front.rim(), end - begin).noalias() -=
          L.bottomRows(front.rim()) * H;
    });
  }

  /// Adds what the front below left of the rows of A.
  void add(int below, const double* from, const Room& room, Eigen::Map<MatrixXd>& rows) const {
    const std::vector<int>& boundary = factor_.fronts_.front(below).boundary;
    for (const int pair : paths_.rows[at(below)]) {
      double* column = &rows(0, room.column[at(pair)]);
      for (const int place : boundary) column[room.row[at(place)]] += *from++;
    }
  }

  /// Adds H^T H to the rows and columns of its pairs, panel by panel.
  static void contribute(const std::vector<int>& pairs, const Eigen::Ref<const MatrixXd>& H,
                         const Room& room, Share& share) {
    for_ranges(H.cols(), panel, [&](Index begin, Index end) {
      const Index count = H.cols() - begin;
      if (H.cols() == share.square.cols()) {
        share.square.block(begin, begin, count, end - begin).noalias() +=
            H.rightCols(count).transpose() * H.middleCols(begin, end - begin);
        return;
      }
      const MatrixXd square = H.rightCols(count).transpose() * H.middleCols(begin, end - begin);
      for (Index j = 0; j < square.cols(); ++j) {
        double* const column = &share.square(0, room.place[at(pairs[at(begin + j)])]);
        for (Index i = j; i < count; ++i)
          column[room.place[at(pairs[at(begin + i)])]] += square(i, j);
      }
    });
  }

  const FrontalFactor& factor_;
  ByUnknown A_;  // of A, by unknown
  RowPaths paths_;
  std::vector<Index> sizes_;      // of what the fronts hand on
  std::vector<VectorXd> handed_;  // by the last front of each part
  std::vector<Room> rooms_;       // of the threads
  OrderedSum sum_;
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
