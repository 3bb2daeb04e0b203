// # Factor of a sparse matrix without symmetry
//
// Newton's method on a whole contact problem has one large sparse matrix per step. Its entries
// change, their places do not. The order Q of the columns decides how many new entries the factors
// of \f$ PAQ = LU \f$ have; it depends on the places alone, so it is chosen for the first matrix
// and kept. The order P of the rows depends on the numbers and is chosen each time.
//
// If nothing is known, any row may come first, and Q must suit all P (COLAMD). If the entries lie almost
// symmetrically and the diagonal is large, P may follow Q: both are the order of minimum degree, and
// other rows come first only where the diagonal entry is less than a tenth of its column.

#include "signorini/core/sparse_lu.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseLU>
#include <utility>
#include <variant>

namespace signorini {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Eigen divides by the number of columns, and takes for granted that each of them has an entry.
bool has_empty_columns(const Eigen::SparseMatrix<double>& matrix) {
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    if (!Eigen::SparseMatrix<double>::InnerIterator(matrix, j)) return true;
  return matrix.cols() == 0;
}

}  // namespace

// The two kinds of factor differ in the order Q, which Eigen makes part of the type. SparseLU takes
// the inverse of the permutation that AMDOrdering returns: taken as it is, it is as bad an order as
// any.
struct SparseLuFactor::Numbers {
  struct MinimumDegree {
    using PermutationType = Eigen::AMDOrdering<int>::PermutationType;
    void operator()(const Matrix& matrix, PermutationType& order) const {
      PermutationType inverse;
      Eigen::AMDOrdering<int>()(matrix, inverse);
      order = inverse.inverse();
    }
  };
  using ByColumns = Eigen::SparseLU<Matrix>;
  using ByDegree = Eigen::SparseLU<Matrix, MinimumDegree>;

  std::variant<ByColumns, ByDegree> lu;
  bool ordered = false;
};

SparseLuFactor::SparseLuFactor(Pivots pivots) : numbers_(std::make_unique<Numbers>()) {
  if (pivots == Pivots::Diagonal) numbers_->lu.emplace<Numbers::ByDegree>().setPivotThreshold(0.1);
}

// The header does not know what `Numbers` are. So the destructor stands here, where they are known.
SparseLuFactor::~SparseLuFactor() = default;

// The first matrix decides on the order. Later ones with entries in other places would get a wrong
// one.
bool SparseLuFactor::factorise(const Eigen::SparseMatrix<double>& matrix) {
  if (has_empty_columns(matrix)) return false;
  const bool ordered = std::exchange(numbers_->ordered, true);
  return std::visit(
      [&](auto& lu) {
        if (!ordered) lu.analyzePattern(matrix);
        lu.factorize(matrix);
        return lu.info() == Eigen::Success;
      },
      numbers_->lu);
}

// Two triangular solves, between the two permutations.
Eigen::VectorXd SparseLuFactor::solve(const Eigen::VectorXd& b) const {
  return std::visit([&](const auto& lu) { return Eigen::VectorXd(lu.solve(b)); }, numbers_->lu);
}

// The sign of \f$ \det A \f$ costs nothing more: it is that of the pivots and of the two
// permutations. If it differs for two matrices, every path from one to the other meets a singular
// one.
int SparseLuFactor::sign() const {
  const auto of = [](auto& lu) { return static_cast<int>(lu.signDeterminant()); };
  return std::visit(of, numbers_->lu);
}

// What a factor takes grows with these, as does what a solve takes.
Eigen::Index SparseLuFactor::entries() const {
  return std::visit([](const auto& lu) { return Eigen::Index{lu.nnzL() + lu.nnzU()}; }, numbers_->lu);
}

}  // namespace signorini
