#include "addons/many_bodies/pair_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// The forces of a pair that slides with a friction force at its bound, sign (mu lambda + c); negative lambda where none do.
Vector2d sliding(const LonePair& pair, double sign) {
  const double stiff = pair.nn + sign * pair.coefficient * pair.nt;
  const double normal =
      stiff > 0 ? -(pair.gap + sign * pair.cohesion * pair.nt) / stiff : -1;
  return {normal, sign * (pair.coefficient * normal + pair.cohesion)};
}

/// The movement of a row: its free movement and what all forces add.
double moved(const SparseMatrix& rows, const VectorXd& free, const VectorXd& force, Index row) {
  double sum = free(row);
  for (SparseMatrix::InnerIterator it(rows, row); it; ++it) sum += it.value() * force(it.row());
  return sum;
}

}  // namespace

Vector2d lone_pair_force(const LonePair& pair) {
  if (pair.gap >= 0) return {0, 0};
  const double determinant = pair.nn * pair.tt - pair.nt * pair.tn;
  Vector2d stick(-pair.gap / pair.nn, 0);
  if (determinant > 0)
    stick = Vector2d(pair.nt * pair.slip - pair.tt * pair.gap,
                     pair.tn * pair.gap - pair.nn * pair.slip) /
            determinant;
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
  const SparseMatrix rows = compliance.transpose();  // by rows: F need not be symmetric
  const Index pairs = free.size() - static_cast<Index>(law.pair.size());
  std::vector<Index> slip_of(at(pairs), -1);
  std::vector<LonePair> alone(at(pairs));
  for (Index i = 0; i < pairs; ++i) alone[at(i)].nn = compliance.coeff(i, i);
  for (std::size_t k = 0; k < law.pair.size(); ++k) {
    const Index i = law.pair[k];
    const Index j = slip_of[at(i)] = pairs + static_cast<Index>(k);
    alone[at(i)] = {0, 0, compliance.coeff(i, i), compliance.coeff(i, j), compliance.coeff(j, i),
                    compliance.coeff(j, j), law.coefficient(j - pairs), law.cohesion(j - pairs)};
  }
  for (Index sweep = 0; sweep < sweeps; ++sweep)
    for (Index i = 0; i < pairs; ++i) {
      LonePair& pair = alone[at(i)];
      const Index j = slip_of[at(i)];
      const double tau = j < 0 ? 0 : force(j);
      pair.gap = moved(rows, free, force, i) - pair.nn * force(i) - pair.nt * tau;
      if (j < 0) {
        force(i) = std::max(0.0, -pair.gap / pair.nn);
        continue;
      }
      pair.slip = moved(rows, free, force, j) - pair.tn * force(i) - pair.tt * tau;
      const Vector2d found = lone_pair_force(pair);
      force(i) = found.x();
      force(j) = found.y();
    }
}

}  // namespace signorini
