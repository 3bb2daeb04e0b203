#include "signorini/core/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace signorini {

using Eigen::MatrixXd;
using Eigen::VectorXd;

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

double LuFactor::rcond() const {  // Eigen says 1 where a pivot is 0
  return (numbers_->lu.matrixLU().diagonal().array() == 0).any() ? 0 : numbers_->lu.rcond();
}

struct CholeskyFactor::Numbers {
  Eigen::LLT<MatrixXd> llt;
};

CholeskyFactor::CholeskyFactor(const MatrixXd& matrix)
    : numbers_(std::make_shared<Numbers>(Numbers{Eigen::LLT<MatrixXd>(matrix)})) {}

bool CholeskyFactor::positive() const { return numbers_->llt.info() == Eigen::Success; }

const MatrixXd& CholeskyFactor::lower() const { return numbers_->llt.matrixLLT(); }

VectorXd CholeskyFactor::solve(const VectorXd& b) const { return numbers_->llt.solve(b); }

MatrixXd CholeskyFactor::solve_columns(const MatrixXd& B) const { return numbers_->llt.solve(B); }

VectorXd CholeskyFactor::solve_transposed_half(const VectorXd& b) const {
  return numbers_->llt.matrixU().solve(b);
}

void solve_lower_columns(const Eigen::Ref<const MatrixXd>& L, Eigen::Ref<MatrixXd> X) {
  L.triangularView<Eigen::Lower>().solveInPlace(X);
}

}  // namespace signorini
