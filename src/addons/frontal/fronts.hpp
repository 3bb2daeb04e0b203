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

/// A run of fronts that one thread works through: a subtree, or one front above subtrees.
struct TreePart {
  int first = 0;   ///< number of its first front
  int end = 0;     ///< and of the one behind its last, which is above all others of the part
  int above = -1;  ///< the part of the front above it, -1 for none
  std::vector<int> below;  ///< the parts of the fronts directly below it; of a subtree none
};

/// All that the pattern of K and a tree say of the factor of K. The factor works by it, and it can be asked
/// what the factor will cost before there is a number.
struct Fronts {
  std::vector<int> order;       ///< `n` unknown at each place
  std::vector<int> place;       ///< `n` place of each unknown
  std::vector<Front> all;       ///< what is below comes before
  std::vector<TreePart> parts;  ///< of them, each front once; what is below comes before
  Eigen::Index entries = 0;  ///< numbers that L takes, those above its diagonal blocks among them
  Eigen::Index tallest = 0;  ///< the most rows that a front has

  /// \return number of unknowns n
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(order.size()); }
  /// \param number  of a front \return the front
  [[nodiscard]] const Front& front(int number) const {
    return all[static_cast<std::size_t>(number)];
  }
  /// \param part   of the tree
  /// \param front  the last one of a part directly below it
  /// \return number of that part
  [[nodiscard]] int part_below(const TreePart& part, int front) const;
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
  /// A stack for the fronts of a part but its last, which is above them.
  /// \param part   of the tree
  /// \param sizes  how many numbers each front of the whole tree hands on
  /// \return where they go, the first front of the part counted as 0
  [[nodiscard]] StackPlan stack(const TreePart& part, const std::vector<Eigen::Index>& sizes) const;
  /// \return how many numbers a front hands on in a factorisation: the square of its boundary
  [[nodiscard]] std::vector<Eigen::Index> update_sizes() const;
  /// \return the stack of a factorisation on one thread
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
