/// \file
/// Cholesky factor front by front: the price of one linear solve.
#pragma once
#include <Eigen/SparseCore>
#include <functional>
#include <string>
#include <vector>

#include "signorini/core/ledger.hpp"
#include "signorini/factor/front_stack.hpp"
#include "signorini/factor/separator_tree.hpp"

namespace signorini {

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

  /// \return number of unknowns n
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(order_.size()); }
  /// \return entries of L with the diagonal, also those that are zero in a front
  [[nodiscard]] Eigen::Index nonzeros() const;
  /// \return multiplications, additions and divisions of the factorisation
  [[nodiscard]] double operations() const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Columns = Eigen::Map<const Eigen::MatrixXd>;

  struct Front {
    Separator separator;
    std::vector<int> boundary;  // places, rising
    Eigen::Index begin = 0;     // of its columns of L among the entries
    [[nodiscard]] Eigen::Index own() const { return separator.own; }
    [[nodiscard]] Eigen::Index rim() const { return static_cast<Eigen::Index>(boundary.size()); }
    [[nodiscard]] Eigen::Index rows() const { return own() + rim(); }
  };
  class Elimination;
  class Walk;

  [[nodiscard]] const Front& front(int number) const {
    return fronts_[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] FrontStack stack(std::vector<Eigen::Index> sizes) const;
  void number_rows(const Front& front, std::vector<int>& row) const;
  void analyse(const Matrix& stiffness, const SeparatorTree& tree);
  [[nodiscard]] Columns columns(const Front& front) const;
  void forward(Eigen::VectorXd& x) const;
  void backward(Eigen::VectorXd& x) const;

  std::vector<int> order_;     // unknown at each place
  std::vector<int> place_;     // of each unknown
  std::vector<Front> fronts_;  // what is below comes before
  Eigen::VectorXd entries_;    // of L, front by front
  double scale_ = 1;         // L L^T = scale K, a power of two: no unit of force changes a bit of L
  Eigen::Index widest_ = 0;  // the most rows that a boundary has
};

}  // namespace signorini
