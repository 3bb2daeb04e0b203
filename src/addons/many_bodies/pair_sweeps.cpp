#include "addons/many_bodies/pair_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// The forces of a pair that slides with a friction force at its bound, sign (mu lambda + c); negative lambda where none do.
Vector2d sliding(const LonePair& pair, double sign) {
  const double stiff = pair.nn + sign * pair.coefficient * pair.nt;
  const double normal =
      stiff > 0 ? -(pair.gap + sign * pair.cohesion * pair.nt) / stiff : -1;
  return {normal, sign * (pair.coefficient * normal + pair.cohesion)};
}

/// What the force of another pair's row adds to gap and slip of a pair, for 1 of it. Both are added at once.
struct Influence {
  Index row = 0;
  Vector2d moves = Vector2d::Zero();
};

/// \param i  row of the gap \param j  of the slip, or -1 \return what the rows of others add, by their numbers
std::vector<Influence> influences(const SparseMatrix& rows, Index i, Index j) {
  std::map<Index, Influence> of_row;
  for (SparseMatrix::InnerIterator it(rows, i); it; ++it) of_row[it.row()].moves.x() = it.value();
  if (j >= 0)
    for (SparseMatrix::InnerIterator it(rows, j); it; ++it) of_row[it.row()].moves.y() = it.value();
  std::vector<Influence> others;
  for (const auto& [row, influence] : of_row)
    if (row != i && row != j) others.push_back({row, influence.moves});
  return others;
}

/// One of the pairs that are swept over.
struct SweptPair {
  LonePair alone;
  Index slip = -1;         // its row, if the pair has friction
  std::ptrdiff_t end = 0;  // of what others add to it
};

/// All of them, and what others add to each, one pair after the other.
struct SweptPairs {
  std::vector<SweptPair> pairs;
  std::vector<Influence> others;
};

SweptPairs swept_pairs(const SparseMatrix& compliance, const FrictionLaw& law, Index pairs) {
  const SparseMatrix rows = compliance.transpose();  // by rows: F need not be symmetric
  SweptPairs all{std::vector<SweptPair>(at(pairs)), {}};
  for (Index i = 0; i < pairs; ++i) all.pairs[at(i)].alone.nn = compliance.coeff(i, i);
  for (std::size_t k = 0; k < law.pair.size(); ++k) {
    const Index i = law.pair[k];
    const Index j = all.pairs[at(i)].slip = pairs + static_cast<Index>(k);
    all.pairs[at(i)].alone = {
        0, 0, compliance.coeff(i, i), compliance.coeff(i, j), compliance.coeff(j, i),
        compliance.coeff(j, j), law.coefficient(j - pairs), law.cohesion(j - pairs)};
  }
  for (Index i = 0; i < pairs; ++i) {
    const std::vector<Influence> of_pair = influences(rows, i, all.pairs[at(i)].slip);
    all.others.insert(all.others.end(), of_pair.begin(), of_pair.end());
    all.pairs[at(i)].end = static_cast<std::ptrdiff_t>(all.others.size());
  }
  return all;
}

}  // namespace

Vector2d lone_pair_force(const LonePair& pair) {
  if (pair.gap >= 0) return {0, 0};
  const double determinant = pair.nn * pair.tt - pair.nt * pair.tn;
  const Vector2d stick = determinant > 0 ? Vector2d(Vector2d(pair.nt * pair.slip - pair.tt * pair.gap,
                                                             pair.tn * pair.gap - pair.nn * pair.slip) /
                                                    determinant)
                                         : Vector2d(-pair.gap / pair.nn, 0);
  const double bound = pair.coefficient * stick.x() + pair.cohesion;
  if (determinant > 0 && stick.x() >= 0 && std::abs(stick.y()) <= bound) return stick;
  for (const double sign : {-1.0, 1.0}) {
    const Vector2d slides = sliding(pair, sign);
    const double slip = pair.slip + pair.tn * slides.x() + pair.tt * slides.y();
    if (slides.x() >= 0 && sign * slip <= 0) return slides;
  }
  const double normal = std::max(stick.x(), 0.0);
  const double most = pair.coefficient * normal + pair.cohesion;
  return {normal, std::clamp(stick.y(), -most, most)};
}

void sweep_pairs(const SparseMatrix& compliance, const VectorXd& free, const FrictionLaw& law,
                 Index sweeps, VectorXd& force) {
  const Index pairs = free.size() - static_cast<Index>(law.pair.size());
  SweptPairs all = swept_pairs(compliance, law, pairs);
  for (Index sweep = 0; sweep < sweeps; ++sweep) {
    auto other = all.others.cbegin();
    for (Index i = 0; i < pairs; ++i) {
      auto& [pair, j, end] = all.pairs[at(i)];
      Vector2d moved(free(i), j < 0 ? 0 : free(j));
      for (; other != all.others.cbegin() + end; ++other)
        moved += other->moves * force(other->row);
      pair.gap = moved.x();
      pair.slip = moved.y();
      if (j < 0) {
        force(i) = std::max(0.0, -pair.gap / pair.nn);
        continue;
      }
      const Vector2d found = lone_pair_force(pair);
      force(i) = found.x();
      force(j) = found.y();
    }
  }
}

}  // namespace signorini
