#include "signorini/problem/systems.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Sets that are joined pair by pair; each is called by its smallest member.
class Joined {
 public:
  explicit Joined(Index count) : above_(at(count)), left_(count) {
    std::iota(above_.begin(), above_.end(), Index{0});
  }
  [[nodiscard]] Index name(Index i) {
    while (above_[at(i)] != i) i = above_[at(i)] = above_[at(above_[at(i)])];
    return i;
  }
  void join(Index i, Index j) {
    i = name(i);
    j = name(j);
    if (i == j) return;
    above_[at(std::max(i, j))] = std::min(i, j);
    --left_;
  }
  /// \return the number of sets
  [[nodiscard]] Index count() const { return left_; }

 private:
  std::vector<Index> above_;
  Index left_;
};

/// Where a number is among rising ones, which may be few of many; -1 if it is not.
Index place_among(const std::vector<Index>& rising, Index number) {
  const auto found = std::lower_bound(rising.begin(), rising.end(), number);
  return found == rising.end() || *found != number ? -1
                                                   : static_cast<Index>(found - rising.begin());
}

/// The unknown that stands for a row of A; -1 if the row is empty.
Index first_unknown(const RowMatrix& A, Index row) {
  for (RowMatrix::InnerIterator entry(A, row); entry; ++entry)
    if (entry.value() != 0) return entry.col();
  return -1;
}

/// Joins each unknown with those before it that it has an entry of K with: the first of them, or all. Entries that
/// are no more than the share `weak` of what the diagonal holds join nothing.
void join_columns(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& root, double weak,
                  bool all, Joined& sets) {
  for (Index j = 0; j < K.cols() && sets.count() > 1; ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, j); it && it.row() < j; ++it) {
      if (std::abs(it.value()) <= weak * root(it.row()) * root(j)) continue;
      sets.join(it.row(), j);
      if (!all) break;
    }
}

Joined joined(const QuadraticProgramme& programme, const FrictionLaw& law,
              const Eigen::MatrixXd& null_vectors, double weak) {
  const Index n = programme.load.size();
  const Eigen::VectorXd root =
      Eigen::VectorXd(programme.stiffness.diagonal()).cwiseMax(0).cwiseSqrt();
  const RowMatrix& A = programme.A;
  const Index pairs = A.rows() - static_cast<Index>(law.pair.size());
  Joined sets(n);
  join_columns(programme.stiffness, root, weak, false, sets);  // on most meshes that is enough
  for (Index row = 0; row < A.rows() && sets.count() > 1; ++row) {
    const Index first = first_unknown(A, row);
    for (RowMatrix::InnerIterator entry(A, row); entry; ++entry)
      if (entry.value() != 0) sets.join(first, entry.col());
  }
  for (Index k = 0; pairs + k < A.rows() && sets.count() > 1; ++k) {
    const Index gap = first_unknown(A, law.pair[at(k)]);
    const Index slip = first_unknown(A, pairs + k);
    if (gap >= 0 && slip >= 0) sets.join(gap, slip);
  }
  for (Index j = 0; j < null_vectors.cols() && sets.count() > 1; ++j) {
    Index first = -1;
    for (Index i = 0; i < n; ++i) {
      if (null_vectors(i, j) == 0) continue;
      if (first < 0) first = i;
      sets.join(first, i);
    }
  }
  join_columns(programme.stiffness, root, weak, true, sets);
  return sets;
}

}  // namespace

std::vector<SystemParts> unconnected_systems(const QuadraticProgramme& programme,
                                             const FrictionLaw& law,
                                             const Eigen::MatrixXd& null_vectors, double weak) {
  Joined sets = joined(programme, law, null_vectors, weak);
  if (sets.count() < 2) return {};
  const Index n = programme.load.size();
  const Index pairs = programme.A.rows() - static_cast<Index>(law.pair.size());
  std::vector<SystemParts> systems;
  std::vector<Index> place(at(n));  // of the system that a set is called by
  const auto system_of = [&](Index unknown) -> SystemParts& {
    return systems[at(unknown < 0 ? 0 : place[at(sets.name(unknown))])];
  };
  for (Index i = 0; i < n; ++i) {
    if (sets.name(i) == i) {
      place[at(i)] = static_cast<Index>(systems.size());
      systems.emplace_back();
    }
    system_of(i).unknowns.push_back(i);
  }
  for (Index row = 0; row < programme.A.rows(); ++row) {
    Index unknown = first_unknown(programme.A, row);
    // The row of a slip that supports give is empty, and goes with its gap; so does a gap with its slip.
    if (unknown < 0 && row >= pairs)
      unknown = first_unknown(programme.A, law.pair[at(row - pairs)]);
    for (std::size_t k = 0; unknown < 0 && row < pairs && k < law.pair.size(); ++k)
      if (law.pair[k] == row) unknown = first_unknown(programme.A, pairs + static_cast<Index>(k));
    system_of(unknown).rows.push_back(row);
  }
  for (Index j = 0; j < null_vectors.cols(); ++j) {
    Index first = 0;
    while (first + 1 < n && null_vectors(first, j) == 0) ++first;
    system_of(first).modes.push_back(j);
  }
  return systems;
}

SystemParts whole_system(const QuadraticProgramme& programme, Index modes) {
  const auto numbers = [](Index count) {
    std::vector<Index> all(at(count));
    std::iota(all.begin(), all.end(), Index{0});
    return all;
  };
  return {numbers(programme.load.size()), numbers(programme.A.rows()), numbers(modes)};
}

QuadraticProgramme part_of(const QuadraticProgramme& programme, const SystemParts& parts) {
  const Index n = static_cast<Index>(parts.unknowns.size());
  std::vector<Eigen::Triplet<double>> entries;
  QuadraticProgramme part;
  for (Index j = 0; j < n; ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(programme.stiffness, parts.unknowns[at(j)]);
         it; ++it)
      if (const Index i = place_among(parts.unknowns, it.row()); it.value() != 0 && i >= 0)
        entries.emplace_back(i, j, it.value());
  part.stiffness.resize(n, n);
  part.stiffness.setFromTriplets(entries.begin(), entries.end());
  entries.clear();
  const Index rows = static_cast<Index>(parts.rows.size());
  for (Index i = 0; i < rows; ++i)
    for (RowMatrix::InnerIterator it(programme.A, parts.rows[at(i)]); it; ++it)
      if (it.value() != 0)
        entries.emplace_back(i, place_among(parts.unknowns, it.col()), it.value());
  part.A.resize(rows, n);
  part.A.setFromTriplets(entries.begin(), entries.end());
  part.load = programme.load(parts.unknowns);
  part.initial_gap = programme.initial_gap(parts.rows);
  return part;
}

FrictionLaw part_of(const FrictionLaw& law, Index pairs, const SystemParts& parts) {
  std::vector<Index> slips;
  FrictionLaw part;
  for (const Index row : parts.rows) {
    if (row < pairs) continue;
    slips.push_back(row - pairs);
    part.pair.push_back(place_among(parts.rows, law.pair[at(row - pairs)]));
  }
  part.coefficient = law.coefficient(slips);
  part.cohesion = law.cohesion(slips);
  return part;
}

}  // namespace signorini
