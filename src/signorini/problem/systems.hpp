// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The systems of a programme that nothing connects: each is a problem of its own, with its own units of size.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// One of them, by its numbers in the whole, each in increasing order.
struct SystemParts {
  std::vector<Eigen::Index> unknowns;  ///< of u
  std::vector<Eigen::Index> rows;      ///< of A: gaps, then slips
  std::vector<Eigen::Index> modes;     ///< columns of N
};

/// Unknowns are connected by an entry of K, a row of A or a column of N that has both, and rows by a pair.
///
/// What happens in one system is felt in no other, however large it is: a figure that measures all by the largest
/// of all would hide an error, and a method that stops at its rounding would make one.
/// \param programme     K, p, A, g, slips in the last rows of A
/// \param law           of the frictional pairs
/// \param null_vectors  N `n x n_r`, or nothing
/// \param weak          entries with |K_ij| <= weak sqrt(K_ii K_jj) connect nothing [-]
/// \return the systems by their first unknowns, rows without an entry in the first one; empty if all is connected
[[nodiscard]] std::vector<SystemParts> unconnected_systems(const QuadraticProgramme& programme,
                                                           const FrictionLaw& law,
                                                           const Eigen::SparseMatrix<double>& null_vectors,
                                                           double weak = 0);

/// \param programme  K, p, A, g
/// \param modes      n_r
/// \return all of it as one system
[[nodiscard]] SystemParts whole_system(const QuadraticProgramme& programme, Eigen::Index modes);

/// \param programme  K, p, A, g
/// \param parts      one of its systems
/// \return the programme of that system alone, without what connects it weakly with others
[[nodiscard]] QuadraticProgramme part_of(const QuadraticProgramme& programme,
                                         const SystemParts& parts);

/// \param law    of the frictional pairs
/// \param pairs  n_c of the whole
/// \param parts  a system of it
/// \return the law of its pairs, with their numbers in it
[[nodiscard]] FrictionLaw part_of(const FrictionLaw& law, Eigen::Index pairs,
                                  const SystemParts& parts);

}  // namespace signorini
