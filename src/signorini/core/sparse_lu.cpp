#include "signorini/core/sparse_lu.hpp"

#include <Eigen/SparseLU>

namespace signorini {

struct SparseLuFactor::Numbers {
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
  bool ordered = false;
};

SparseLuFactor::SparseLuFactor() : numbers_(std::make_unique<Numbers>()) {}

SparseLuFactor::~SparseLuFactor() = default;

bool SparseLuFactor::factorise(const Eigen::SparseMatrix<double>& matrix) {
  if (!numbers_->ordered) numbers_->lu.analyzePattern(matrix);
  numbers_->ordered = true;
  numbers_->lu.factorize(matrix);
  return numbers_->lu.info() == Eigen::Success;
}

Eigen::VectorXd SparseLuFactor::solve(const Eigen::VectorXd& b) const {
  return numbers_->lu.solve(b);
}

int SparseLuFactor::sign() const { return static_cast<int>(numbers_->lu.signDeterminant()); }

}  // namespace signorini
