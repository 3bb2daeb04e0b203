// # Factor of a sparse matrix without symmetry
//
// Newton's method on a whole contact problem has one large sparse matrix per step. Its entries
// change, their places do not. The order Q of the columns decides how many new entries the factors
// of \f$ PAQ = LU \f$ have; it depends on the places alone, so it is chosen for the first matrix
// and kept. The order P of the rows depends on the numbers and is chosen each time.

#include "signorini/core/sparse_lu.hpp"

#include <Eigen/SparseLU>

namespace signorini {
namespace {

// Eigen divides by the number of columns, and takes for granted that each of them has an entry.
bool has_empty_columns(const Eigen::SparseMatrix<double>& matrix) {
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    if (!Eigen::SparseMatrix<double>::InnerIterator(matrix, j)) return true;
  return matrix.cols() == 0;
}

}  // namespace

struct SparseLuFactor::Numbers {
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
  bool ordered = false;
};

SparseLuFactor::SparseLuFactor() : numbers_(std::make_unique<Numbers>()) {}

// The header does not know what `Numbers` are. So the destructor stands here, where they are known.
SparseLuFactor::~SparseLuFactor() = default;

bool SparseLuFactor::factorise(const Eigen::SparseMatrix<double>& matrix) {
  if (has_empty_columns(matrix)) return false;
  if (!numbers_->ordered) numbers_->lu.analyzePattern(matrix);
  numbers_->ordered = true;
  numbers_->lu.factorize(matrix);
  return numbers_->lu.info() == Eigen::Success;
}

Eigen::VectorXd SparseLuFactor::solve(const Eigen::VectorXd& b) const {
  return numbers_->lu.solve(b);
}

// The sign of \f$ \det A \f$ costs nothing more: it is that of the pivots and of the two
// permutations. If it differs for two matrices, every path from one to the other meets a singular
// one.
int SparseLuFactor::sign() const { return static_cast<int>(numbers_->lu.signDeterminant()); }

}  // namespace signorini
