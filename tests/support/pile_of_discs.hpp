// Piles of rigid discs, as one step of the dynamics of many bodies: more contact forces than unknowns.
#pragma once
#include <Eigen/SparseCore>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "signorini/problem/problem.hpp"
#include "support/random.hpp"

namespace signorini_test {

/// Discs of radius 1/2 in layers on a floor, each touching those beside and below it; u = W r + q are the
/// velocities at the contacts after the impulses r, with W = H M^-1 H^T.
inline signorini::ContactProblem pile(Eigen::Index columns, Eigen::Index layers, double mu) {
  using namespace signorini;
  using Eigen::Index;
  using Eigen::VectorXd;
  Random random(1);
  struct Contact {
    Index below, above;
    double nx, ny;
  };
  const Index discs = columns * layers;
  const auto x = [&](Index disc) {
    return static_cast<double>(disc % columns) + 0.5 * static_cast<double>(disc / columns % 2);
  };
  const auto y = [&](Index disc) { return 0.87 * static_cast<double>(disc / columns); };
  std::vector<Contact> contacts;
  for (Index a = 0; a < discs; ++a) {
    if (a < columns) contacts.push_back({-1, a, 0, 1});
    for (Index b = a + 1; b < discs; ++b) {
      const double distance = std::hypot(x(b) - x(a), y(b) - y(a));
      if (distance < 1.05)
        contacts.push_back({a, b, (x(b) - x(a)) / distance, (y(b) - y(a)) / distance});
    }
  }
  const Index n = static_cast<Index>(contacts.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < n; ++i) {
    const Contact& c = contacts[static_cast<std::size_t>(i)];
    for (const auto& [disc, sign] : {std::pair(c.above, 1.0), std::pair(c.below, -1.0)}) {
      if (disc < 0) continue;
      entries.emplace_back(i, 3 * disc, sign * c.nx);
      entries.emplace_back(i, 3 * disc + 1, sign * c.ny);
      entries.emplace_back(n + i, 3 * disc, -sign * c.ny);
      entries.emplace_back(n + i, 3 * disc + 1, sign * c.nx);
      entries.emplace_back(n + i, 3 * disc + 2, -0.5);
    }
  }
  Eigen::SparseMatrix<double> H(2 * n, 3 * discs);
  H.setFromTriplets(entries.begin(), entries.end());
  VectorXd mobility(3 * discs);
  VectorXd velocity(3 * discs);
  for (Index d = 0; d < discs; ++d) {
    const double mass = random.uniform(0.5, 1.5);
    mobility.segment(3 * d, 3) << 1 / mass, 1 / mass, 8 / mass;
    velocity.segment(3 * d, 3) << random.uniform(-0.3, 0.3), random.uniform(-1.3, -0.7),
        random.uniform(-0.3, 0.3);
  }
  ContactProblem problem;
  const Eigen::SparseMatrix<double> half = H * mobility.cwiseSqrt().asDiagonal();
  const Eigen::SparseMatrix<double> W = half * Eigen::SparseMatrix<double>(half.transpose());
  problem.compliance = 0.5 * (Eigen::MatrixXd(W) + Eigen::MatrixXd(W.transpose()));
  problem.free_gap = (H * velocity).head(n);
  problem.free_slip = (H * velocity).tail(n);
  problem.law = law_of_all(VectorXd::Constant(n, mu), VectorXd::Zero(n));
  return problem;
}


}  // namespace signorini_test
