/// \file
/// The fronts of a Cholesky factor before they have numbers: sizes, places, memory and operations.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "addons/frontal/front_stack.hpp"
#include "addons/frontal/separator_tree.hpp"

namespace signorini {

/// A separator and what its elimination joins.
struct Front {
  Separator separator;        ///< its own unknowns
  std::vector<int> boundary;  ///< places of the later unknowns that it joins, rising
  Eigen::Index begin = 0;     ///< of its columns of L among the entries
  /// \return how many unknowns it eliminates
  [[nodiscard]] Eigen::Index own() const { return separator.own; }
  /// \return how many unknowns its boundary has
  [[nodiscard]] Eigen::Index rim() const { return static_cast<Eigen::Index>(boundary.size()); }
  /// \return rows of its columns of L
  [[nodiscard]] Eigen::Index rows() const { return own() + rim(); }
  /// \return operations of its share of one solve: two walks through its columns of L
  [[nodiscard]] double solve_operations() const {
    return 2 * static_cast<double>(own() * (own() + 2 * rim()));
  }
};

/// All that the pattern of K and a tree say of the factor of K. The factor works by it, and it can be asked
/// what the factor will cost before there is a number.
struct Fronts {
  std::vector<int> order;    ///< `n` unknown at each place
  std::vector<int> place;    ///< `n` place of each unknown
  std::vector<Front> all;    ///< what is below comes before
  Eigen::Index entries = 0;  ///< numbers that L takes, those above its diagonal blocks among them
  Eigen::Index tallest = 0;  ///< the most rows that a front has

  /// \return number of unknowns n
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(order.size()); }
  /// \param number  of a front \return the front
  [[nodiscard]] const Front& front(int number) const {
    return all[static_cast<std::size_t>(number)];
  }
  /// \param position  in the order \return number of the front that eliminates the unknown there
  [[nodiscard]] int front_at(int position) const;
  /// \return entries of L with the diagonal, also those that are zero in a front
  [[nodiscard]] Eigen::Index nonzeros() const;
  /// \return operations of the factorisation, see elimination_operations()
  [[nodiscard]] double operations() const;
  /// \return operations of one solve K u = p: two walks through L
  [[nodiscard]] double solve_operations() const;
  /// A stack for what the fronts hand on.
  /// \param sizes  how many numbers each of them hands on
  /// \return where they go
  [[nodiscard]] StackPlan stack(std::vector<Eigen::Index> sizes) const;
  /// \return the stack of a factorisation: of every front the square of its boundary
  [[nodiscard]] StackPlan update_stack() const;
};

/// Finds the fronts.
/// \param matrix  `n x n` compressed, symmetric pattern, both triangles; its numbers do not count
/// \param tree    separator_tree() of it
/// \return one front per separator
/// \throws std::invalid_argument if the matrix is not square and compressed, or the tree not one of its unknowns
[[nodiscard]] Fronts fronts_of(const Eigen::SparseMatrix<double>& matrix,
                               const SeparatorTree& tree);

/// Whether a tree that was made for another matrix is an order for this one: no entry joins what a separator parts.
/// \param tree    separator_tree() of a matrix
/// \param matrix  `n x n`, symmetric pattern, both triangles
/// \return false also if the matrix has another number of unknowns
[[nodiscard]] bool keeps_apart(const SeparatorTree& tree,
                               const Eigen::SparseMatrix<double>& matrix);

/// How rows of A go up the fronts.
struct RowPaths {
  std::vector<std::vector<int>>
      rows;                       ///< of each front: rows with an entry in it or below it, rising
  StackPlan stack;                ///< what the fronts hand on: boundary times rows
  Eigen::Index most_numbers = 0;  ///< `rows() * rows` of the largest front
  Eigen::Index most_rows = 0;     ///< the most rows that a front knows
  double operations = 0;          ///< of A K^-1 A^T, see carrying_operations()

  /// \return the most memory that the walk takes besides A K^-1 A^T [byte]
  [[nodiscard]] long long bytes() const;
};

/// Finds the paths.
/// \param fronts  of K
/// \param A       `n_c x n` by column
/// \return rows of each front
/// \throws std::invalid_argument if A does not have one column per unknown
[[nodiscard]] RowPaths row_paths(const Fronts& fronts, const Eigen::SparseMatrix<double>& A);

/// \param own  unknowns that a front eliminates \param rim  of its boundary
/// \return multiplications, additions, divisions and roots of that
[[nodiscard]] double elimination_operations(Eigen::Index own, Eigen::Index rim);

/// \param own  unknowns that a front eliminates \param rim  of its boundary \param rows  of A that it knows
/// \return multiplications, additions and divisions of H, of what it hands on, and of H^T H
[[nodiscard]] double carrying_operations(Eigen::Index own, Eigen::Index rim, Eigen::Index rows);

}  // namespace signorini
