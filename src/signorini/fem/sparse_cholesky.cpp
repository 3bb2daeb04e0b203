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

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
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
  // One solve for each pair. The frontal factor of the add-on needs none: it finds
  // \f$H = L^{-1} P A^T\f$ and \f$H^T H\f$ in one walk. The mean with the transpose is exactly
  // symmetric.
  const auto compliance = [cholesky, size](const Factor::Rows& A, Ledger& counts) -> MatrixXd {
    if (A.rows() == 0 || A.cols() == 0) return MatrixXd::Zero(A.rows(), A.rows());
    counts.count("operations",
                 static_cast<long long>(static_cast<double>(A.rows()) * size.solve_operations));
    const MatrixXd response = cholesky->solve(MatrixXd(A.transpose()));
    const MatrixXd product = A * response;
    return 0.5 * (product + product.transpose());
  };
  return {solve, compliance, size};
}

}  // namespace

Backend sparse_cholesky() {
  return {"sparse_cholesky", "Eigen's sparse Cholesky factor; plain, needs nothing", factored};
}

}  // namespace signorini
