/// \file
/// Gaps and slips of the unknown displacements: candidate pairs with the supports taken out.
///
/// Pairs are written for all nodes, held or not. Solvers need only what can still move. The step
/// from the one to the other stands here.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/contact/pairs.hpp"
#include "signorini/fem/unknowns.hpp"

namespace signorini {

/// Linear gaps gap = initial_gap - A u and slips slip = initial_slip + T u of `n` unknowns, of pairs that
/// can still move. \PaperEq{XuanLi2002, 13}
///
/// In `pairs`, `initial_gap` includes what given displacements open; `opening` and `sliding` keep the columns
/// of held components, for the forces that supports feel; `node` and `unpaired` count the nodes of all bodies.
struct Gaps {
  Pairs pairs;                                     ///< `n_c` that can still move
  Eigen::SparseMatrix<double, Eigen::RowMajor> A;  ///< `n_c x n` [-]: minus N, free components
  Eigen::SparseMatrix<double, Eigen::RowMajor> T;  ///< `n_c x n` [-]; no entries without friction
  Eigen::VectorXd initial_slip;                    ///< `n_c` [length]
  /// `n_c` numbers of the pairs of one contact among its candidates; none of several contacts
  std::vector<Eigen::Index> kept = {};
  /// Numbers of the other candidates, which supports hold on both sides
  std::vector<Eigen::Index> dropped = {};
};

/// \param pairs  any
/// \return by how much sides that touch may seem to overlap for the rounding of positions alone [length]
[[nodiscard]] double gap_rounding(const Pairs& pairs);

/// Takes the supports out of candidate pairs.
///
/// A pair whose points cannot move along the normal is dropped: no contact force can act between two
/// supports. Whether it overlaps is for the caller to ask: supports may move it.
/// \param pairs     `n_c` candidates
/// \param source    the boundary they are on
/// \param unknowns  `n` of all bodies
/// \param directions  one rounding of the directions of the sides [-]: what it may do to a node's share of a normal or
///   tangent moves nothing; 0 if they are as exact as numbers can be
/// \return the pairs that can open or close
/// \throws ProblemError if both ends of a side of the source are dropped: the boundary was meant for a support or for contact
[[nodiscard]] Gaps reduce(const Pairs& pairs, const Surface& source, const Unknowns& unknowns,
                          double directions = 0);

/// Some rows of a matrix.
/// \param rows  `m x n`
/// \param kept  `k` numbers of rows
/// \return `k x n`, in the order of `kept`
[[nodiscard]] NodalRows selected_rows(const NodalRows& rows, const std::vector<Eigen::Index>& kept);

/// A matrix of a few rows, whatever its length.
/// \param entries  in any order; those in one place add up
/// \param rows     number of rows
/// \param columns  number of columns
/// \return `rows x columns`
[[nodiscard]] NodalRows rows_of(std::vector<Eigen::Triplet<double>> entries, Eigen::Index rows,
                                Eigen::Index columns);

/// Puts the rows of two matrices below each other.
/// \param upper  `m_1 x n`
/// \param lower  `m_2 x n`
/// \return `m_1 + m_2` rows; a matrix without rows may also have fewer columns
[[nodiscard]] NodalRows below(const NodalRows& upper, const NodalRows& lower);

/// Puts the pairs of several contacts below each other.
/// \param upper  `n_1` pairs of `n` unknowns; also none
/// \param lower  `n_2` pairs of as many unknowns; also none
/// \return `n_1 + n_2` pairs, and the unpaired nodes of both
[[nodiscard]] Gaps stacked(const Gaps& upper, const Gaps& lower);

/// The same of any number, in this order. \param contacts  at least one \return all their pairs
[[nodiscard]] Gaps stacked(std::vector<Gaps> contacts);

}  // namespace signorini
