/// \file
/// Sparse Cholesky factor with the contact unknowns ordered last: the price of one linear solve.
#pragma once
#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "signorini/core/ledger.hpp"
#include "signorini/elasticity/ordering.hpp"

namespace signorini {

/// P K P^T = L D L^T for an order that ends with the contact unknowns.
///
/// With no unknowns last this is the plain factor of the whole matrix. Eigen's simplicial
/// factorisation does the work [\ref Davis2006].
class ContactLastFactor {
 public:
  /// Factors a stiffness matrix.
  /// \param stiffness  `n x n` symmetric, both triangles [force/length]
  /// \param order      `n`     nested_dissection() or minimum_degree() of it
  /// \param n_last     how many unknowns at the end of the order belong to the trailing block
  /// \param ledger     receives the phases `symbolic` and `numeric` and the counts of the factor
  /// \param describe   names an unknown in the message about a bad pivot
  /// \throws std::invalid_argument if sizes differ
  /// \throws ProblemError if a pivot is not larger than the rounding errors of its own computation:
  ///   the matrix is singular to working precision and some part can move without resistance
  ContactLastFactor(const Eigen::SparseMatrix<double>& stiffness, const EliminationOrder& order,
                    Eigen::Index n_last, Ledger& ledger,
                    const std::function<std::string(Eigen::Index)>& describe = {});
  ~ContactLastFactor();
  /// Takes over a factor; the other one may only be assigned to or destroyed afterwards.
  ContactLastFactor(ContactLastFactor&&) noexcept;
  /// Takes over a factor, as the constructor. \return this factor
  ContactLastFactor& operator=(ContactLastFactor&&) noexcept;

  /// Solves K u = p.
  /// \param load  `n` p [force]
  /// \return `n` u [length]
  /// \throws std::invalid_argument unless there is one entry per unknown
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& load) const;

  /// A K^-1 A^T from the trailing block of the factor.
  ///
  /// Only the trailing triangle is used: with B the columns of A that belong to the unknowns
  /// ordered last, \f$ A K^{-1} A^T = V^T D_2^{-1} V,\ L_{22} V = B^T \f$, because the rows of A
  /// are zero elsewhere.
  /// \param A  `n_c x n` [-]; nonzero only in columns of unknowns ordered last
  /// \return `n_c x n_c`, symmetric positive semidefinite [length/force]; the factor F of
  ///   \PaperEq{XuanLi2002, 23}
  /// \throws std::invalid_argument if A does not have one column per unknown, or an entry in the
  ///   column of an unknown that is not ordered last
  [[nodiscard]] Eigen::MatrixXd compliance(
      const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) const;

  /// \return number of unknowns n
  [[nodiscard]] Eigen::Index size() const;
  /// \return entries of L with the diagonal
  [[nodiscard]] Eigen::Index nonzeros() const;
  /// \return multiplications, additions and divisions of the factorisation
  [[nodiscard]] double operations() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The unknowns to order last: columns in which A has entries.
/// \param A  `n_c x n`
/// \return column numbers, in increasing order
[[nodiscard]] std::vector<Eigen::Index> contact_unknowns(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& A);

}  // namespace signorini
