// # The plain factor
//
// A symmetric positive definite matrix is \f$P K P^T = L D L^T\f$ with a lower triangle \f$L\f$, a
// diagonal \f$D\f$ of pivots, and a permutation \f$P\f$. One step eliminates one unknown and
// changes the entries of all pairs of its neighbours, also those that were zero. These new entries,
// the *fill*, decide the cost, and the order decides the fill. Minimum degree takes the unknown
// with the fewest neighbours next.
//
// Eigen does the work. What stands here is what a user of contact needs besides: an error that
// names the place where a body is loose, counts that do not depend on the machine, and
// \f$A K^{-1} A^T\f$.

#include <Eigen/SparseCholesky>
#include <cmath>
#include <memory>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/factor.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using Cholesky = Eigen::SimplicialLDLT<Matrix>;

/// A message about unknown 4711 helps nobody. The caller may say which node and direction that is.
std::string name(const Stiffness& K, Index unknown) {
  return text(unknown, K.describe ? " (" + K.describe(unknown) + ")" : "");
}

/// One entry that is no number would spread over the whole factor, and nobody could tell where it
/// began.
void check_entries(const Stiffness& K) {
  for (Index k = 0; k < K.matrix.cols(); ++k)
    for (Matrix::InnerIterator entry(K.matrix, k); entry; ++entry)
      if (!std::isfinite(entry.value()))
        throw ProblemError(
            text("stiffness matrix has an entry that is no finite number at unknown ", name(K, k),
                 ": look at the material and the thickness of its body"));
}

/// K with the springs that hold it besides, each as stiff as a diagonal entry.
///
/// A factor may be asked to hold some unknowns by springs besides, so that a loose body can be
/// factored. With the balance of the body as one more equation the springs carry nothing, as
/// chapter 11 explains.
Matrix with_springs(const Stiffness& K) {
  Matrix held = K.matrix;
  for (const Index unknown : K.grounded) {
    require_argument(unknown >= 0 && unknown < held.cols(),
                     "sparse_cholesky: grounded unknowns are 0 to ", held.cols() - 1, ", got ",
                     unknown);
    held.coeffRef(unknown, unknown) *= 2;
  }
  return held;
}

/// A pivot is a diagonal entry minus an inner product of at most n terms: that bounds its error.
///
/// If a body can move freely, \f$K\f$ is singular, and in exact arithmetic the last pivot is 0.
/// Rounding makes it small, of either sign. Eigen may report success then, and a solution would be
/// nonsense. So pivots are compared with what rounding can make of them. The chain 1, -1; -1, 2,
/// -1; -1, 1, whose three nodes nothing holds, ends with the pivot 0, and the message names the
/// unknown.
void check_pivots(const Stiffness& K, const Matrix& held, const Cholesky& cholesky) {
  const VectorXd pivots = cholesky.vectorD();
  const VectorXd diagonal = cholesky.permutationP() * VectorXd(held.diagonal());
  const double least = epsilon * static_cast<double>(pivots.size());
  for (Index k = 0; k < pivots.size(); ++k) {
    if (pivots(k) > least * std::abs(diagonal(k))) continue;
    const Index unknown = cholesky.permutationPinv().indices()(k);
    throw ProblemError(
        text("stiffness matrix is singular at unknown ", name(K, unknown), ": pivot ", pivots(k),
             " of a diagonal entry ", K.matrix.coeff(unknown, unknown),
             ". Something can move there without resistance: add a support; or the cells are too "
             "slender for double precision: use more of them"));
  }
}

/// What it takes: a column of L with k entries below the diagonal is scaled, and its outer product subtracted.
///
/// One triangle of the outer product has \f$k(k+1)/2\f$ entries, each with a multiplication and a
/// subtraction: \f$k + k(k+1) = k(k+2)\f$ operations. The chain 2, -1; -1, 2, -1; -1, 2 has 5
/// entries in the factor, 6 operations, and 11 in each solve. Counts are the same on every machine,
/// times are not.
Factor::Size size_of(const Cholesky& cholesky) {
  const Matrix L = cholesky.matrixL();
  Factor::Size size;
  size.unknowns = L.cols();
  for (Index k = 0; k < L.cols(); ++k) {
    const double below = static_cast<double>(L.col(k).nonZeros() - 1);
    size.nonzeros += L.col(k).nonZeros();
    size.operations += below * (below + 2);
  }
  size.solve_operations = static_cast<double>(4 * size.nonzeros - 3 * size.unknowns);
  return size;
}

/// \f$H = D^{-1/2}L^{-1}PA^T\f$, so that \f$AK^{-1}A^T = H^TH\f$, column by column.
///
/// A row of A has a few entries, and \f$L^{-1}\f$ carries each of them only to unknowns that are
/// eliminated later and are reached through fill: the way up the elimination tree. On a mesh of
/// \f$n\f$ unknowns that is about \f$\sqrt n\f$ of them. All other entries of H are zero, and
/// neither stored nor multiplied.
Matrix half_of(const Cholesky& cholesky, const Factor::Rows& A, Ledger& ledger) {
  const Matrix L = cholesky.matrixL();
  const VectorXd root = cholesky.vectorD().cwiseSqrt();
  const auto& place = cholesky.permutationP().indices();
  Matrix half(L.cols(), A.rows());
  VectorXd column = VectorXd::Zero(L.cols());
  VectorXd met = VectorXd::Zero(L.cols());  // by so many columns
  double operations = 0;
  for (Index row = 0; row < A.rows(); ++row) {
    half.startVec(row);
    for (Factor::Rows::InnerIterator entry(A, row); entry; ++entry)
      column(place(entry.col())) = entry.value();
    for (Index j = 0; j < column.size(); ++j) {
      if (column(j) == 0) continue;
      for (Matrix::InnerIterator below(L, j); below; ++below)
        if (below.row() > j) column(below.row()) -= below.value() * column(j);
      half.insertBack(j, row) = column(j) / root(j);
      column(j) = 0;
      met(j) += 1;
      operations += 2 * static_cast<double>(L.col(j).nonZeros());
    }
  }
  half.finalize();
  ledger.count("operations", static_cast<long long>(operations + met.squaredNorm()));
  return half;
}

Factor factored(const Stiffness& K, Ledger& ledger) {
  const Ledger::Phase phase(ledger, "numeric");
  check_entries(K);
  const auto cholesky = std::make_shared<Cholesky>();
  Factor::Size size;
  if (const Matrix held = with_springs(K); held.cols() > 0) {
    cholesky->compute(held);
    check_pivots(K, held, *cholesky);
    size = size_of(*cholesky);
  }
  ledger.count("nonzeros", size.nonzeros);
  ledger.count("operations", static_cast<long long>(size.operations));
  ledger.bytes(size.nonzeros * static_cast<long long>(sizeof(double)));
  // The factor is shared by the two functions and lives as long as one of them.
  const auto solve = [cholesky](const Eigen::Ref<const VectorXd>& load) {
    return load.size() > 0 ? VectorXd(cholesky->solve(load)) : VectorXd();
  };
  const auto compliance = [cholesky](const Factor::Rows& A, Ledger& counts) -> MatrixXd {
    if (A.rows() == 0 || A.cols() == 0) return MatrixXd::Zero(A.rows(), A.rows());
    const Matrix half = half_of(*cholesky, A, counts);
    return MatrixXd(half.transpose() * half);
  };
  return {solve, compliance, size};
}

}  // namespace

Backend sparse_cholesky() {
  return {"sparse_cholesky", "Eigen's sparse Cholesky factor; plain, needs nothing", factored};
}

}  // namespace signorini
