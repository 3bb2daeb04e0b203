/// \file
/// Factors of the closed pairs' compliance that are kept up to date while single pairs join and leave.
#pragma once
#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <vector>

#include "signorini/closing/closed_pairs.hpp"
#include "signorini/closing/scaled_half.hpp"

namespace signorini {

/// The upper triangle R with \f$ R^T R = G_{WW} \f$ for closed pairs W, and how these answer to one
/// more pair. All memory is reserved at the start.
class ClosedTriangle {
 public:
  /// \return number of closed pairs
  [[nodiscard]] Eigen::Index size() const { return size_; }
  /// \return \f$ r = G_{WW}^{-1} G_{Wp} \f$ `size` of the pair p pressed last: forces change by -r per
  ///   unit force to keep W closed
  [[nodiscard]] auto response() const { return response_.head(size_); }

 protected:
  /// \param capacity  most pairs
  explicit ClosedTriangle(Eigen::Index capacity);
  /// \return \f$ R^{-T} G_{Wp} \f$ `size`, to be written before respond() or append()
  auto column() { return column_.head(size_); }
  /// Solves R^T x = column() in place.
  void forward();
  /// Solves R r = column() for response().
  void respond();
  /// Appends column() and a diagonal entry to R. \param diagonal  not 0
  void append(double diagonal);
  /// Takes a column out and makes the rest triangular again by rotations of neighbouring rows.
  /// \param position  of the column
  /// \return the rotations; the first one is of rows `position` and `position` + 1
  const std::vector<Eigen::JacobiRotation<double>>& remove(Eigen::Index position);

 private:
  Eigen::Index size_ = 0;
  Eigen::MatrixXd R_;
  Eigen::VectorXd column_;
  Eigen::VectorXd response_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
};

/// Closed pairs of a problem whose G is given: R is the Cholesky factor of G_WW.
class ComplianceFactor : public ClosedTriangle {
 public:
  /// \param problem  scaled by equilibrate(); must outlive the factor
  explicit ComplianceFactor(const ScaledProblem& problem);

  /// Presses a pair.
  /// \param active  W, in the order in which its pairs joined
  /// \param pair    p
  /// \return how fast its gap opens per unit force [-]; 0 if it depends on W to rounding
  double press(const std::vector<Eigen::Index>& active, Eigen::Index pair);
  /// The pair pressed last, whose gap opens, joins W.
  void join();
  /// A pair leaves W. \param position  in W
  void leave(Eigen::Index position) { remove(position); }
  /// Finds all gaps.
  /// \param active    W, in the order in which its pairs joined
  /// \param force     forces, those of W in this order first
  /// \param gap       is set to the gaps `n_c`
  /// \param rounding  is set to what rounding may have done to each `n_c`
  void gaps(const std::vector<Eigen::Index>& active, const Eigen::VectorXd& force,
            Eigen::VectorXd& gap, Eigen::VectorXd& rounding) const;

 private:
  const ScaledProblem& problem_;
  double opening_ = 0;
};

/// Closed pairs of a problem G = H^T H: an orthogonal J with \f$ J^T H_W = (R, 0)^T \f$ as well, so that
/// neither R nor the opening of a gap suffers from the squares in G.
class HalfFactor : public ClosedTriangle {
 public:
  /// \param problem  scaled by equilibrate(); must outlive the factor
  explicit HalfFactor(const ScaledHalf& problem);

  /// As ComplianceFactor::press().
  /// \param active  W, in the order in which its pairs joined
  /// \param pair    p
  /// \return how fast its gap opens per unit force [-]; 0 if it depends on W to rounding
  double press(const std::vector<Eigen::Index>& active, Eigen::Index pair);
  /// The pair pressed last, whose gap opens, joins W.
  void join();
  /// A pair leaves W. \param position  in W
  void leave(Eigen::Index position);
  /// As ComplianceFactor::gaps().
  /// \param active    W, in the order in which its pairs joined
  /// \param force     forces, those of W in this order first
  /// \param gap       is set to the gaps `n_c`
  /// \param rounding  is set to what rounding may have done to each `n_c`
  void gaps(const std::vector<Eigen::Index>& active, const Eigen::VectorXd& force,
            Eigen::VectorXd& gap, Eigen::VectorXd& rounding);

 private:
  const ScaledHalf& problem_;
  Eigen::MatrixXd J_;
  Eigen::VectorXd turned_;
  Eigen::VectorXd work_;
  Eigen::Index updates_ = 0;
};

}  // namespace signorini
