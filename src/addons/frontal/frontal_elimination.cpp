// L L^T = P K P^T: the fronts are eliminated up the tree of separators.
#include <algorithm>
#include <cmath>

#include "addons/frontal/front.hpp"
#include "addons/frontal/frontal_factor.hpp"
#include "addons/frontal/threads.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/parts.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Works through the fronts, part by part. Within a part a stack holds what those below hand to those above; what the last
/// front of a part hands on is kept until the part above has taken it.
class FrontalFactor::Elimination {
 public:
  Elimination(FrontalFactor& factor, const Matrix& stiffness, const std::vector<Index>& grounded)
      : factor_(factor),
        stiffness_(stiffness),
        grounded_(grounded),
        least_(least_pivots()),
        sizes_(factor.fronts_.update_sizes()),
        handed_(factor.fronts_.parts.size()),
        rooms_(at(threads())) {}

  /// \return the place of the first pivot that is too small, n if there is none
  Index run() {
    try {
      up_the_tree(factor_.fronts_.parts,
                  [this](int part, int worker) { work(at(part), rooms_[at(worker)]); });
    } catch (const SmallPivot& pivot) {
      return pivot.place;
    }
    return factor_.size();
  }

 private:
  /// Ends a part. What is above is then left out, and of several parts the first counts.
  struct SmallPivot {
    Index place;
  };
  /// Of one thread.
  struct Room {
    std::vector<int> row;  // of the present front, by place
    std::vector<int> to;   // rows of the front above
  };

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

  /// Eliminates the fronts of a part.
  void work(std::size_t number, Room& room) {
    const TreePart& part = factor_.fronts_.parts[number];
    room.row.resize(factor_.fronts_.order.size());
    FrontStack stack(factor_.fronts_.stack(part, sizes_));
    const int last = part.end - 1;
    for (int k = part.first; k < last; ++k) {
      visit(factor_.fronts_.front(k), stack.open(), room,
            [&](int below) { return stack.kept(below - part.first); });
      stack.keep(k - part.first);
    }
    handed_[number].resize(sizes_[at(last)]);
    visit(factor_.fronts_.front(last), handed_[number].data(), room, [&](int below) {
      return below >= part.first ? stack.kept(below - part.first)
                                 : handed_[at(factor_.fronts_.part_below(part, below))].data();
    });
    for (const int below : part.below) handed_[at(below)].resize(0);
  }

  /// Eliminates the unknowns of a front. \param update  gets what it hands on \param kept  where one below handed that on
  template <typename Kept>
  void visit(const Front& front, double* to, Room& room, Kept&& kept) {
    Eigen::Map<MatrixXd> columns(factor_.entries_.data() + front.begin, front.rows(), front.own());
    Eigen::Map<MatrixXd> update(to, front.rim(), front.rim());
    columns.setZero();
    update.setZero();
    factor_.number_rows(front, room.row);
    gather(front, room.row, columns);
    ground(front, columns);
    for (const int below : front.separator.below)
      if (below >= 0)
        add(factor_.fronts_.front(below).boundary, kept(below), room, columns, update);
    const Index first = front.separator.first;
    const Index done = eliminate(columns, update, least_.segment(first, front.own()));
    if (done < front.own()) throw SmallPivot{first + done};
  }

  /// Entries of K in the columns of a front, from the diagonal down.
  void gather(const Front& front, const std::vector<int>& row,
              Eigen::Map<MatrixXd>& columns) const {
    for (int k = 0; k < front.separator.own; ++k)
      for (Matrix::InnerIterator entry(stiffness_,
                                       factor_.fronts_.order[at(front.separator.first + k)]);
           entry; ++entry) {
        const int place = factor_.fronts_.place[at(static_cast<int>(entry.row()))];
        if (place >= front.separator.first + k)
          columns(row[at(place)], k) += factor_.scale_ * entry.value();
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

  /// Adds the update of a front below to the one above. \param boundary  of the one below \param from  its update
  static void add(const std::vector<int>& boundary, const double* from, Room& room,
                  Eigen::Map<MatrixXd>& columns, Eigen::Map<MatrixXd>& update) {
    const Index own = columns.cols();
    std::vector<int>& to = room.to;
    to.resize(boundary.size());
    std::transform(boundary.begin(), boundary.end(), to.begin(),
                   [&](int place) { return room.row[at(place)]; });
    for (std::size_t j = 0; j < to.size(); ++j, from += to.size()) {
      const bool eliminated = to[j] < own;
      const Index shift = eliminated ? 0 : own;
      double* column = eliminated ? &columns(0, to[j]) : &update(0, to[j] - own);
      for (std::size_t i = j; i < to.size(); ++i) column[to[i] - shift] += from[i];
    }
  }

  FrontalFactor& factor_;
  const Matrix& stiffness_;
  const std::vector<Index>& grounded_;
  VectorXd least_;
  std::vector<Index> sizes_;      // of what the fronts hand on
  std::vector<VectorXd> handed_;  // by the last front of each part
  std::vector<Room> rooms_;       // of the threads
};

Index FrontalFactor::eliminated(const Matrix& stiffness, const std::vector<Index>& grounded) {
  return Elimination(*this, stiffness, grounded).run();
}

double FrontalFactor::pivot(Index place) const {
  const Front& front = fronts_.front(fronts_.front_at(static_cast<int>(place)));
  const Index column = place - front.separator.first;
  return columns(front)(column, column) / scale_;
}

}  // namespace signorini
