// The back end `cholmod`: the supernodal factor of SuiteSparse, package libsuitesparse-dev.
#include <cholmod.h>

#include <Eigen/SparseCore>
#include <memory>
#include <new>

#include "addons/frontal/backend.hpp"
#include "addons/frontal/frontal_factor.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// A sparse matrix as CHOLMOD sees it, without a copy. \param symmetry  -1: of which it reads the lower triangle
cholmod_sparse view(const Matrix& matrix, int symmetry) {
  cholmod_sparse seen{};
  seen.nrow = static_cast<std::size_t>(matrix.rows());
  seen.ncol = static_cast<std::size_t>(matrix.cols());
  seen.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  seen.p = const_cast<int*>(matrix.outerIndexPtr());
  seen.i = const_cast<int*>(matrix.innerIndexPtr());
  seen.x = const_cast<double*>(matrix.valuePtr());
  seen.stype = symmetry;
  seen.itype = CHOLMOD_INT;
  seen.xtype = CHOLMOD_REAL;
  seen.dtype = CHOLMOD_DOUBLE;
  seen.sorted = 1;
  seen.packed = 1;
  return seen;
}

/// The factor L L^T = scale P K P^T, ordered by approximate minimum degree.
class CholmodFactor {
 public:
  explicit CholmodFactor(const Stiffness& K) : scale_(stiffness_scale(K.matrix)) {
    cholmod_start(&common_);
    common_.print = 0;
    common_.quick_return_if_not_posdef = 1;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;  // else it also tries the ordering of METIS
    common_.method[0].ordering = CHOLMOD_AMD;
    Matrix lower = scale_ * K.matrix.triangularView<Eigen::Lower>();
    for (const Index unknown : K.grounded) lower.coeffRef(unknown, unknown) *= 2;
    cholmod_sparse seen = view(lower, -1);
    L_ = cholmod_analyze(&seen, &common_);
    good_ = L_ != nullptr && cholmod_factorize(&seen, L_, &common_) != 0 &&
            common_.status == CHOLMOD_OK && L_->minor == L_->n;
  }
  ~CholmodFactor() {
    cholmod_free_factor(&L_, &common_);
    cholmod_finish(&common_);
  }
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;
  CholmodFactor(CholmodFactor&&) = delete;
  CholmodFactor& operator=(CholmodFactor&&) = delete;

  [[nodiscard]] bool good() const { return good_; }
  [[nodiscard]] double nonzeros() const { return common_.lnz; }
  [[nodiscard]] double operations() const { return common_.fl; }

  [[nodiscard]] VectorXd solve(const Eigen::Ref<const VectorXd>& load) {
    VectorXd scaled = scale_ * load;
    cholmod_dense p{};
    p.nrow = p.nzmax = p.d = static_cast<std::size_t>(scaled.size());
    p.ncol = 1;
    p.x = scaled.data();
    p.xtype = CHOLMOD_REAL;
    p.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* u = cholmod_solve(CHOLMOD_A, L_, &p, &common_);
    if (u == nullptr) throw std::bad_alloc();
    scaled = Eigen::Map<const VectorXd>(static_cast<const double*>(u->x), load.size());
    cholmod_free_dense(&u, &common_);
    return scaled;
  }

  /// H^T H with H = L^-1 P A^T, one solve with L per row: it has no walk along the paths of the rows.
  [[nodiscard]] MatrixXd compliance(const Factor::Rows& A) {
    if (A.rows() == 0) return {};  // CHOLMOD has no solution of nothing
    const Matrix columns = A.transpose();
    cholmod_sparse seen = view(columns, 0);
    cholmod_sparse* ordered = cholmod_spsolve(CHOLMOD_P, L_, &seen, &common_);
    cholmod_sparse* half =
        ordered == nullptr ? nullptr : cholmod_spsolve(CHOLMOD_L, L_, ordered, &common_);
    cholmod_free_sparse(&ordered, &common_);
    if (half == nullptr) throw std::bad_alloc();
    const Eigen::Map<const Matrix> H(static_cast<Index>(half->nrow), static_cast<Index>(half->ncol),
                                     static_cast<Index>(half->nzmax), static_cast<int*>(half->p),
                                     static_cast<int*>(half->i), static_cast<double*>(half->x));
    MatrixXd G = MatrixXd(H.transpose() * H);
    cholmod_free_sparse(&half, &common_);
    G.triangularView<Eigen::StrictlyUpper>() = G.transpose();
    return scale_ * G;
  }

 private:
  double scale_;
  cholmod_common common_{};
  cholmod_factor* L_ = nullptr;
  bool good_ = false;
};

Factor factored(const Stiffness& K, Ledger& ledger) {
  if (K.matrix.cols() == 0) return frontal().factor(K, ledger);  // CHOLMOD minds
  if (!K.matrix.coeffs().allFinite()) refuse(K, "cholmod");
  const Ledger::Phase phase(ledger, "numeric");
  const auto factor = std::make_shared<CholmodFactor>(K);
  if (!factor->good()) refuse(K, "cholmod");
  const auto solve = [factor](const Eigen::Ref<const VectorXd>& load) {
    return factor->solve(load);
  };
  check_held(K, solve);
  const double n = static_cast<double>(K.matrix.cols());
  const double nonzeros = factor->nonzeros();
  const double one_solve = 4 * nonzeros - 2 * n;
  ledger.count("nonzeros", static_cast<long long>(nonzeros));
  ledger.count("operations", static_cast<long long>(factor->operations()));
  ledger.bytes(static_cast<long long>(nonzeros * sizeof(double)));
  return {solve,
          [factor, nonzeros](const Factor::Rows& A, Ledger& counts) {
            counts.count("operations",
                         static_cast<long long>(2 * nonzeros) * static_cast<long long>(A.rows()));
            return factor->compliance(A);
          },
          {K.matrix.cols(), static_cast<Index>(nonzeros), factor->operations(), one_solve}};
}

}  // namespace

Backend cholmod() {
  return {"cholmod", "SuiteSparse's supernodal factor; one solve per row of A", factored};
}

}  // namespace signorini
