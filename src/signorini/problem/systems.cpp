// # What hangs together
//
// A scene may contain bodies that never meet: a pile of stones here, a beam there. Mathematically
// these are several problems in one matrix. They should be measured one by one. A figure that
// measures all of them by the largest number would hide errors in the small ones.
//
// Two unknowns hang together if K, a gap or slip, or a rigid motion has an entry for both. Systems
// are the connected components of this graph. Six unknowns show it. K joins 1 with 2, 3 with 4 and
// 5 with 6, so there are three bodies. A gap has entries for 2 and 3, so bodies one and two may
// touch. There are two systems, {1, 2, 3, 4} and {5, 6}.

#include "signorini/problem/systems.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "signorini/core/disjoint_sets.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using SparseMatrix = Eigen::SparseMatrix<double>;

// A system lists its unknowns in increasing order. Their number in the system is found by
// bisection. A table would be as long as the whole, and each of many small systems would need one.
// So a pile of stones would take time that grows with the square of their number.
Index place_among(const std::vector<Index>& rising, Index number) {
  const auto found = std::lower_bound(rising.begin(), rising.end(), number);
  const bool there = found != rising.end() && *found == number;
  return there ? static_cast<Index>(found - rising.begin()) : -1;
}

// All unknowns of a row are in one system, so that one of them stands for the row. An entry that is
// stored as 0 says nothing.
Index first_unknown(const RowMatrix& A, Index row) {
  for (RowMatrix::InnerIterator entry(A, row); entry; ++entry)
    if (entry.value() != 0) return entry.col();
  return -1;
}

// The first unknown that a rigid motion moves stands for the motion.
Index first_moved(const SparseMatrix& null_vectors, Index mode) {
  for (SparseMatrix::InnerIterator it(null_vectors, mode); it; ++it)
    if (it.value() != 0) return it.row();
  return 0;
}

// Entries of K above the diagonal join. Looking at all of them takes time on a large mesh. On most
// meshes the cells of a body reach each other even if only the first entry of each column is looked
// at, and the search ends as soon as everything is one set. So it is done twice: first with one
// entry per column, and at the end, if several sets are left, with all.
//
// Entries that are at most the share `weak` of what the diagonal holds are taken as rounding. With
// the diagonal entries 4 and 9 and \f$ \varepsilon \f$ as the share that is \f$ 6\,\varepsilon \f$.
// What such an entry adds to the energy of two unknowns is no more than the rounding of what they
// have themselves.
void join_columns(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& root, double weak,
                  bool all, DisjointSets& sets) {
  for (Index j = 0; j < K.cols() && sets.count() > 1; ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, j); it && it.row() < j; ++it) {
      if (std::abs(it.value()) <= weak * root(it.row()) * root(j)) continue;
      sets.join(it.row(), j);
      if (!all) break;
    }
}

// The cheap questions come first. Most problems are one system, and then the first one or two loops
// settle it. Of the six unknowns of the example, each of the three bodies needs one step of the
// first loop. The gap then joins {1, 2} with {3, 4}, and 6 sets have become 2.
DisjointSets joined(const QuadraticProgramme& programme, const FrictionLaw& law,
                    const SparseMatrix& null_vectors, double weak) {
  const Index n = programme.load.size();
  Eigen::VectorXd root = Eigen::VectorXd::Zero(n);  // counts where something is weak
  if (weak > 0) root = Eigen::VectorXd(programme.stiffness.diagonal()).cwiseMax(0).cwiseSqrt();
  const RowMatrix& A = programme.A;
  const Index pairs = A.rows() - static_cast<Index>(law.pair.size());
  DisjointSets sets(n);
  join_columns(programme.stiffness, root, weak, false, sets);  // on most meshes that is enough
  for (Index row = 0; row < A.rows() && sets.count() > 1; ++row) {
    const Index first = first_unknown(A, row);
    for (RowMatrix::InnerIterator entry(A, row); entry; ++entry)
      if (entry.value() != 0) sets.join(first, entry.col());
  }
  // A friction force depends on the force of its pair. So gap and slip belong together even if they
  // share no unknown.
  for (Index k = 0; pairs + k < A.rows() && sets.count() > 1; ++k) {
    const Index gap = first_unknown(A, law.pair[at(k)]);
    const Index slip = first_unknown(A, pairs + k);
    if (gap >= 0 && slip >= 0) sets.join(gap, slip);
  }
  // A rigid motion has one amplitude, which all that move with it share.
  for (Index j = 0; j < null_vectors.cols() && sets.count() > 1; ++j) {
    const Index first = first_moved(null_vectors, j);
    for (SparseMatrix::InnerIterator it(null_vectors, j); it; ++it)
      if (it.value() != 0) sets.join(first, it.row());
  }
  join_columns(programme.stiffness, root, weak, true, sets);
  return sets;
}

}  // namespace

// The sets become lists. Unknowns are visited in increasing order, and the smallest one names its
// set. So a system begins when its name is met, and every list is sorted by itself. Rows follow
// their first unknown. A row without entries follows the other row of its pair, and if that is
// empty too, it belongs to the first system, where the certificate looks at it.
std::vector<SystemParts> unconnected_systems(const QuadraticProgramme& programme, const FrictionLaw& law,
                                             const SparseMatrix& null_vectors, double weak) {
  DisjointSets sets = joined(programme, law, null_vectors, weak);
  if (sets.count() < 2) return {};
  const Index n = programme.load.size();
  const Index pairs = programme.A.rows() - static_cast<Index>(law.pair.size());
  std::vector<SystemParts> systems;
  // The reference that system_of() returns holds only until the next system begins.
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
    // The row of a slip that supports give is empty, and goes with its gap; so does a gap with its
    // slip.
    if (unknown < 0 && row >= pairs)
      unknown = first_unknown(programme.A, law.pair[at(row - pairs)]);
    for (std::size_t k = 0; unknown < 0 && row < pairs && k < law.pair.size(); ++k)
      if (law.pair[k] == row) unknown = first_unknown(programme.A, pairs + static_cast<Index>(k));
    system_of(unknown).rows.push_back(row);
  }
  // A motion goes to the system of the first unknown that it moves.
  for (Index j = 0; j < null_vectors.cols(); ++j)
    system_of(first_moved(null_vectors, j)).modes.push_back(j);
  return systems;
}

// If everything hangs together, unconnected_systems() returns no list: the caller then takes the
// programme as it is and copies nothing. Who wants to treat both cases alike takes the whole as the
// only system.
SystemParts whole_system(const QuadraticProgramme& programme, Index modes) {
  const auto numbers = [](Index count) {
    std::vector<Index> all(at(count));
    std::iota(all.begin(), all.end(), Index{0});
    return all;
  };
  return {numbers(programme.load.size()), numbers(programme.A.rows()), numbers(modes)};
}

// The programme of one system: rows and columns of K, columns of A. A weak entry leads out of the
// system and is left out. The certificate adds what it transmits to the load, see
// [programme_certificate.cpp](programme_certificate.cpp).
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
  if (programme.reached.displacement.size() > 0)
    part.reached = {programme.reached.displacement(parts.unknowns),
                    programme.reached.terms(parts.unknowns)};
  return part;
}

// Pairs get the numbers that they have in the system. Rows list gaps first, so the slip k of the
// whole is the row \f$ n_c + k \f$. A slip is always in the system of its gap, because joined() has
// put them together. So its pair is found among the rows of the system.
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
