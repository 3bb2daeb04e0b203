// Chapter 19 - Five methods for the gaps of one block, each in a screen.
#pragma once
#include <Eigen/SparseLU>

#include "pressed.hpp"

namespace ch19 {

using Sets = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// What a method ends with.
struct Answer {
  VectorXd u;        // of all unknowns [mm]
  VectorXd force;    // on each node of the base; of Nitsche's method on each Gauss point [N]
  Index passes = 0;  // a factor of the body's size each, of G_WW for the active set, a product with G for Uzawa
  bool ended = false;
};

const Index most_passes = 20000;

// [active set]
inline Answer active_set(const Pressed& block, const MatrixXd& G) {
  Answer now;
  Sets closed = block.free_gap.array() < 0;
  while (!now.ended && now.passes < 100) {
    std::vector<Index> W;
    for (Index i = 0; i < closed.size(); ++i)
      if (closed(i)) W.push_back(i);
    now.force = VectorXd::Zero(closed.size());
    now.force(W) = VectorXd(G(W, W).llt().solve(-block.free_gap(W)));
    const VectorXd gap = block.free_gap + G * now.force;
    Sets next = now.force.array() > 0;
    for (Index i = 0; i < closed.size(); ++i)
      if (!closed(i)) next(i) = gap(i) < 0;
    ++now.passes;
    now.ended = (next == closed).all();
    closed = next;
  }
  now.u = Eigen::SimplicialLDLT<SparseMatrix>(block.K).solve(on_base(block, now.force));
  return now;
}
// [active set]

// [penalty]
/// Springs of that stiffness per area under a base with forces on it: they only press.
inline Answer pressed_on_springs(const Pressed& block, double stiffness, const VectorXd& force) {
  Answer now;
  const VectorXd k = stiffness * block.weight;  // of each spring [N/mm]
  Sets pressing = (force - k.cwiseProduct(block.free_gap)).array() > 0;
  while (!now.ended && now.passes < 100) {
    SparseMatrix K = block.K;
    VectorXd load = VectorXd::Zero(K.rows());
    for (Index i = 0; i < k.size(); ++i)
      if (pressing(i)) {
        K.coeffRef(block.up[std::size_t(i)], block.up[std::size_t(i)]) += k(i);
        load(block.up[std::size_t(i)]) = force(i) - k(i) * block.free_gap(i);
      }
    now.u = Eigen::SimplicialLDLT<SparseMatrix>(K).solve(load);
    now.force = force - k.cwiseProduct(block.free_gap + opening(block, now.u));
    const Sets next = now.force.array() > 0;
    ++now.passes;
    now.ended = (next == pressing).all();
    pressing = next;
  }
  now.force = now.force.cwiseMax(0);
  return now;
}

inline Answer penalty(const Pressed& block, double stiffness) {
  return pressed_on_springs(block, stiffness, VectorXd::Zero(block.free_gap.size()));
}
// [penalty]

// [augmented]
inline Answer augmented_lagrangian(const Pressed& block, double stiffness,
                                   Index most = most_passes) {
  Answer now{{}, VectorXd::Zero(block.free_gap.size())};
  for (Index pass = 0; !now.ended && pass < most; ++pass) {
    Answer next = pressed_on_springs(block, stiffness, now.force);
    next.passes += now.passes;
    next.ended = (next.force - now.force).norm() <= 1e-10 * next.force.norm();
    now = next;
  }
  return now;
}
// [augmented]

// [uzawa]
inline Answer uzawa(const Pressed& block, const MatrixXd& G, double step,
                    Index most = most_passes) {
  Answer now{{}, VectorXd::Zero(block.free_gap.size())};
  const VectorXd k = step * block.weight;
  while (!now.ended && now.passes < most) {
    const VectorXd gap = block.free_gap + G * now.force;  // or one solve with the factor of K
    const VectorXd next = (now.force - k.cwiseProduct(gap)).cwiseMax(0);
    now.ended = (next - now.force).norm() <= 1e-10 * next.norm();
    now.force = next;
    ++now.passes;
  }
  now.u = Eigen::SimplicialLDLT<SparseMatrix>(block.K).solve(on_base(block, now.force));
  return now;
}
// [uzawa]

// [nitsche matrix]
/// The matrix of Nitsche's method while these points of the base press.
inline SparseMatrix nitsche_matrix(const Pressed& block, const std::vector<SidePoint>& points,
                                   double gamma, const Sets& pressing) {
  SparseMatrix K = block.K;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SidePoint& at = points[i];
    add_square(K, at, at.pressure, -at.weight / gamma);
    if (pressing(Index(i))) add_square(K, at, at.pressure - gamma * at.opening, at.weight / gamma);
  }
  return K;
}
// [nitsche matrix]

/// The forces of the points while they press by the free gaps alone.
inline VectorXd nitsche_load(const Pressed& block, const std::vector<SidePoint>& points,
                             double gamma, const Sets& pressing) {
  VectorXd load = VectorXd::Zero(block.K.rows());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SidePoint& at = points[i];
    const Vector8d row = at.weight * at.free_gap * (at.pressure - gamma * at.opening);
    for (std::size_t j = 0; j < 8; ++j)
      if (pressing(Index(i)) && at.unknown[j] >= 0) load(at.unknown[j]) += row(Index(j));
  }
  return load;
}

inline Answer nitsche(const Pressed& block, double gamma) {
  const std::vector<SidePoint> points = side_points(block);
  Answer now;
  Sets pressing(Index(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) pressing(Index(i)) = points[i].free_gap < 0;
  while (!now.ended && now.passes < 100) {
    const Eigen::SparseLU<SparseMatrix> factor(nitsche_matrix(block, points, gamma, pressing));
    now.u = factor.solve(nitsche_load(block, points, gamma, pressing));
    now.force.resize(Index(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SidePoint& at = points[i];
      const Vector8d u = of_cell(at, now.u);
      now.force(Index(i)) =
          at.weight * (at.pressure.dot(u) - gamma * (at.free_gap + at.opening.dot(u)));
    }
    const Sets next = now.force.array() > 0;
    ++now.passes;
    now.ended = (next == pressing).all();
    pressing = next;
  }
  now.force = now.force.cwiseMax(0);
  return now;
}

/// Largest over smallest eigenvalue; negative if the matrix is not positive definite.
inline double condition(const SparseMatrix& K) {
  const VectorXd values =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(MatrixXd(K), Eigen::EigenvaluesOnly).eigenvalues();
  return values(values.size() - 1) / values(0);
}

}  // namespace ch19
