// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The triangular factor of the closed pairs' compliance, grown and shrunk pair by pair.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// L with \f$ L L^T = G_{WW} \f$ for a set W of closed pairs, and \f$ y = -L^{-1} d_W \f$.
///
/// All rows are normalised, G_ii = 1. The forces that close W are \f$ \lambda_W = L^{-T} y \f$, and
/// \f$ \tfrac12 |y|^2 \f$ is the dual energy, which therefore grows with every pair that joins. If the
/// rows are known as columns h_i of H, G = H^T H, an orthonormal Q with \f$ H_W = Q L^T \f$ is kept as
/// well: L then comes from the columns themselves and not from their products, which squares neither
/// their condition nor the angle between two rows that are nearly parallel.
class ActiveSetFactor {
 public:
  /// Reserves all memory that the basis will need.
  /// \param space     length of the columns h_i; 0 if only products of them, G, are known
  /// \param capacity  most pairs that it can hold
  ActiveSetFactor(Eigen::Index space, Eigen::Index capacity);

  /// \return number of pairs
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }
  /// \return most pairs that it can hold
  [[nodiscard]] Eigen::Index capacity() const { return y_.size(); }
  /// \return the pairs, in the order of the factor
  [[nodiscard]] const std::vector<Eigen::Index>& rows() const { return rows_; }
  /// \return y `size` [sqrt(energy)]
  [[nodiscard]] auto coordinates() const { return y_.head(size()); }
  /// \return Q `space x size`
  [[nodiscard]] auto directions() const { return Q_.leftCols(size()); }
  /// \return L `size x size`; only its lower triangle means anything
  [[nodiscard]] auto factor() const { return L_.topLeftCorner(size(), size()); }
  /// \return \f$ \tfrac12|y|^2 \f$ [energy]
  [[nodiscard]] double dual_energy() const { return 0.5 * y_.head(size()).squaredNorm(); }

  /// A row whose distance from the span of the others is at most this depends on them. With columns it
  /// is their rounding. Products know the square of the distance only, which carries their rounding and
  /// that of how they were made: four fifths of the digits are trusted.
  /// \return the distance, for rows of length 1
  [[nodiscard]] double smallest_distance() const;

  /// Candidates that may join the basis, in normalised rows. The arrays may be larger than needed, so
  /// that they can be used again.
  struct Candidates {
    std::vector<Eigen::Index> rows;  ///< `c` pairs
    Eigen::VectorXd gap;             ///< `c` their present gaps [sqrt(energy)], overlap < 0
    Eigen::VectorXd rounding;        ///< `c` gaps above minus this count as closed
    Eigen::MatrixXd columns;         ///< `space x c` h_i; without columns:
    Eigen::MatrixXd cross;           ///< `size x c` G_Wi
    Eigen::MatrixXd block;           ///< `c x c` G among the candidates
  };

  /// Which candidates join.
  enum class Choice {
    Violated,  ///< those that overlap, best gain of dual energy gap^2 / pivot first
    All        ///< all, in their order
  };

  /// Appends candidates, each after projection off all that joined before; those whose pivot is of
  /// rounding size are left out.
  /// \param candidates  overwritten: `gap` becomes the gaps after the others have joined
  /// \param choice      which ones
  /// \param limit       most that join
  /// \return how many joined
  Eigen::Index append(Candidates& candidates, Choice choice, Eigen::Index limit);

  /// The forces that close the pairs.
  /// \param force  the first `size` entries are set to \f$ L^{-T} y \f$ [sqrt(energy)], tension < 0
  void solve(Eigen::VectorXd& force) const;

  /// How the basis answers when one more pair p is pressed while its own pairs stay closed.
  struct Response {
    Eigen::VectorXd
        yield;  ///< \f$ r = G_{WW}^{-1} G_{Wp} \f$ `size` [-]: forces change by -r per unit force
    double opening = 0;  ///< of the gap of p per unit force [-]; 0 if p depends on W to rounding
  };
  /// \param candidates  one pair, as for append()
  /// \return the answer
  [[nodiscard]] Response response(const Candidates& candidates) const;

  /// How independent a pair of the basis is.
  /// \param position  in rows()
  /// \return distance of its row from the span of all others, for rows of length 1
  [[nodiscard]] double distance_from_others(Eigen::Index position) const;

  /// Removes pairs; the coordinates become those of the remaining set.
  /// \param positions  in rows(), increasing
  void remove(const std::vector<Eigen::Index>& positions);

  /// Replaces the coordinates by those of given forces, \f$ y = L^T \lambda \f$.
  /// \param force  its first `size` entries [sqrt(energy)]
  void set_force(const Eigen::VectorXd& force);

 private:
  void project(Candidates& candidates);
  void push(Candidates& candidates, Eigen::Index which, Eigen::Index first);
  [[nodiscard]] double pivot_rounding(const Eigen::VectorXd& yield) const;
  void remove_one(Eigen::Index position);

  std::vector<Eigen::Index> rows_;
  Eigen::MatrixXd L_;
  Eigen::MatrixXd Q_;
  Eigen::VectorXd y_;
  // Work space of append(): cross terms with the basis, those that joined just now, pivots. It only grows.
  Eigen::MatrixXd cross_;
  Eigen::MatrixXd again_;
  Eigen::VectorXd shared_;
  Eigen::VectorXd pivot_;
};

}  // namespace signorini
