/// \file
/// Cholesky factor front by front: the price of one linear solve.
#pragma once
#include <Eigen/SparseCore>
#include <functional>
#include <string>
#include <vector>

#include "addons/frontal/fronts.hpp"
#include "signorini/core/ledger.hpp"

namespace signorini {

/// A power of two with which the largest entry of a matrix becomes about 1, so that no unit changes a bit of its factor; an
/// entry that has lost digits to underflow stays as it is.
/// \param K  any \return the factor
[[nodiscard]] double stiffness_scale(const Eigen::SparseMatrix<double>& K);

/// P K P^T = L L^T in the order of a tree of separators [\ref DuffReid1983] [\ref Davis2006].
///
/// Every separator has a *front*: the dense matrix of its own unknowns and of its boundary, the later
/// unknowns that its elimination joins. The front eliminates its own ones and hands what it does to
/// its boundary, a dense matrix again, to the front above. L is kept front by front, `own + boundary`
/// rows and `own` columns. Only fronts between a row of A and the root know of that row, which makes
/// A K^-1 A^T cheap.
class FrontalFactor {
 public:
  /// Factors a stiffness matrix.
  /// \param stiffness  `n x n` compressed, symmetric, both triangles [force/length]
  /// \param tree       separator_tree() of it
  /// \param ledger     receives the phases `symbolic` and `numeric` and the counts of the factor
  /// \param describe   names an unknown in the message about a bad pivot
  /// \param grounded   unknowns, each once, that a spring as stiff as their diagonal entry holds besides
  /// \throws std::invalid_argument if the matrix is not square and compressed, or the tree not one of its unknowns
  /// \throws ProblemError if an entry is not finite, or a pivot is not larger than the rounding errors of its own
  ///   computation: the matrix is singular to working precision and some part can move without resistance
  FrontalFactor(const Eigen::SparseMatrix<double>& stiffness, const SeparatorTree& tree,
                Ledger& ledger, const std::function<std::string(Eigen::Index)>& describe = {},
                const std::vector<Eigen::Index>& grounded = {});

  /// Solves K u = p.
  /// \param load  `n` p [force]
  /// \return `n` u [length]
  /// \throws std::invalid_argument unless there is one entry per unknown
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& load) const;

  /// Some unknowns, and what of the factor has to do with them.
  struct Part {
    std::vector<int> places;      ///< of the unknowns in the order of elimination
    std::vector<int> fronts;      ///< that eliminate one of them, and those above, rising
    double solve_operations = 0;  ///< of one solve() with these fronts
  };
  /// Finds the fronts from some unknowns up to the root. Those below have no load, and their displacements are not needed.
  /// \param unknowns  each once
  /// \return the part
  /// \throws std::invalid_argument if there is no such unknown
  [[nodiscard]] Part part(const std::vector<Eigen::Index>& unknowns) const;
  /// Solves K u = p for a part, whose fronts alone it walks through: the same bits as solve() with no other load.
  /// \param part  from part()
  /// \param load  p of its unknowns, the others have none [force]
  /// \return u of them [length]
  /// \throws std::invalid_argument unless there is one entry per unknown of the part
  [[nodiscard]] Eigen::VectorXd solve(const Part& part,
                                      const Eigen::Ref<const Eigen::VectorXd>& load) const;

  /// A K^-1 A^T, in one walk up the tree with the rows of A.
  ///
  /// With \f$ H = L^{-1} P A^T \f$ it is \f$ H^T H \f$, the sum of \f$ H_f^T H_f \f$ over the fronts;
  /// a front takes part in it for the rows of A that have an entry in it or below.
  /// \param A  `n_c x n` [-]
  /// \return `n_c x n_c`, symmetric positive semidefinite [length/force]; the factor F of
  ///   \PaperEq{XuanLi2002, 23}
  /// \throws std::invalid_argument if A does not have one column per unknown
  [[nodiscard]] Eigen::MatrixXd compliance(
      const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) const;
  /// The same, counted.
  /// \param A       `n_c x n` [-]
  /// \param ledger  receives the count `operations`, and as `stack bytes` the memory of the walk
  /// \return as above
  [[nodiscard]] Eigen::MatrixXd compliance(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A,
                                           Ledger& ledger) const;

  /// \return the order of elimination, which a matrix with much the same pattern may be factored in
  [[nodiscard]] SeparatorTree tree() const;
  /// \return number of unknowns n
  [[nodiscard]] Eigen::Index size() const { return fronts_.size(); }
  /// \return entries of L with the diagonal, also those that are zero in a front
  [[nodiscard]] Eigen::Index nonzeros() const { return fronts_.nonzeros(); }
  /// \return multiplications, additions, divisions and roots of the factorisation
  [[nodiscard]] double operations() const { return fronts_.operations(); }
  /// \return multiplications, additions and divisions of one solve()
  [[nodiscard]] double solve_operations() const { return solve_operations_; }

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Columns = Eigen::Map<const Eigen::MatrixXd>;

  class Elimination;
  class Walk;

  /// Fills L. \return the place of the first pivot that is too small, n if there is none
  [[nodiscard]] Eigen::Index eliminated(const Matrix& stiffness,
                                        const std::vector<Eigen::Index>& grounded);
  [[nodiscard]] double pivot(Eigen::Index place) const;  // that was too small
  void number_rows(const Front& front, std::vector<int>& row) const;
  [[nodiscard]] Columns columns(const Front& front) const;
  template <typename Add>
  void forward(const Front& front, Eigen::VectorXd& x, Eigen::VectorXd& numbers, Add&& add) const;
  void backward(const Front& front, Eigen::VectorXd& x, Eigen::VectorXd& numbers) const;
  void forward_in_parts(Eigen::VectorXd& x) const;
  void backward_in_parts(Eigen::VectorXd& x) const;

  Fronts fronts_;
  double solve_operations_ = 0;
  Eigen::VectorXd entries_;  // of L, front by front
  double scale_ = 1;         // L L^T = scale K, a power of two: no unit of force changes a bit of L
};

}  // namespace signorini
