// # Factors of dense matrices
//
// A system \f$ Ax = b \f$ is solved in two steps. A factorisation writes A as a product of
// triangles,
// \f[ PA = LU \quad\text{or, for a symmetric positive definite A,}\quad A = LL^T, \f]
// with about \f$ \tfrac23 n^3 \f$ or \f$ \tfrac13 n^3 \f$ operations. Two triangular solves then
// cost \f$ 2n^2 \f$ per right-hand side. So the factor is an object, which is made once and asked
// often. For example
// \f[ \begin{pmatrix} 4 & 2 \\ 2 & 3 \end{pmatrix} = LL^T, \qquad L = \begin{pmatrix} 2 & 0 \\ 1 & \sqrt2 \end{pmatrix}. \f]
//
// Eigen does the work. Its templates are slow to compile, so each is compiled in this file alone:
// the header knows only that there are some `Numbers`. Copies of a factor share them, because
// nothing changes them once they are there.

#include "signorini/core/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace signorini {

using Eigen::MatrixXd, Eigen::VectorXd;

struct LuFactor::Numbers {
  Eigen::PartialPivLU<MatrixXd> lu;
};

LuFactor::LuFactor(const MatrixXd& matrix)
    : numbers_(std::make_shared<Numbers>(Numbers{Eigen::PartialPivLU<MatrixXd>(matrix)})) {}

VectorXd LuFactor::solve(const VectorXd& b) const { return numbers_->lu.solve(b); }

MatrixXd LuFactor::solve_columns(const MatrixXd& B) const { return numbers_->lu.solve(B); }

VectorXd LuFactor::pivots() const { return numbers_->lu.matrixLU().diagonal(); }

int LuFactor::permutation_sign() const {
  return static_cast<int>(numbers_->lu.permutationP().determinant());
}

// How much an error of b grows in x depends on \f$ \lVert A \rVert \lVert A^{-1} \rVert \f$. The
// factor gives a cheap estimate of its inverse: near 1 is harmless, near \f$ 10^{-16} \f$ nothing
// of x need be right.
double LuFactor::rcond() const {  // Eigen says 1 where a pivot is 0
  return (numbers_->lu.matrixLU().diagonal().array() == 0).any() ? 0 : numbers_->lu.rcond();
}

// A symmetric positive definite matrix needs no exchange of rows. The method stops at the first
// pivot that is not positive, so it is also the test whether A is positive definite.
struct CholeskyFactor::Numbers {
  Eigen::LLT<MatrixXd> llt;
};

CholeskyFactor::CholeskyFactor(const MatrixXd& matrix)
    : numbers_(std::make_shared<Numbers>(Numbers{Eigen::LLT<MatrixXd>(matrix)})) {}

bool CholeskyFactor::positive() const { return numbers_->llt.info() == Eigen::Success; }

const MatrixXd& CholeskyFactor::lower() const { return numbers_->llt.matrixLLT(); }

VectorXd CholeskyFactor::solve(const VectorXd& b) const { return numbers_->llt.solve(b); }

MatrixXd CholeskyFactor::solve_columns(const MatrixXd& B) const { return numbers_->llt.solve(B); }

void solve_lower_columns(const Eigen::Ref<const MatrixXd>& L, Eigen::Ref<MatrixXd> X) {
  L.triangularView<Eigen::Lower>().solveInPlace(X);
}

}  // namespace signorini
