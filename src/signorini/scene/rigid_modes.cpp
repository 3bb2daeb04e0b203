// # Bodies that only contact holds
//
// A body without enough supports can move as a rigid body. Its stiffness is then singular,
// \f$ KN = 0 \f$, with one column of N per rigid mode. The amplitudes a of the modes become
// unknowns of the contact problem,
// \f[ \text{gap} = d + G\lambda + Ra, \qquad R^T\lambda = r, \qquad R = -AN, \quad r = -N^T p. \f]
// R tells by how much a mode opens each gap. The second equation says that contact forces
// balance the load.
//
// An example: a body above a floor touches it at x = -1 and x = 1, and a force of 6 presses
// it down at x = 1/3. Two of its modes are a lift and a turn about x = 0:
// \f[ R = \begin{pmatrix} 1 & -1 \\ 1 & 1 \end{pmatrix}, \quad r = \binom{6}{2}. \f]
// Balance alone gives the forces 2 and 4.
//
// The difficulty of this file is zero. A block on a floor can slide, because its slide opens
// no gap. Then the entry of R must be 0. A remainder of \f$ 10^{-17} \f$ would make the
// solver believe that the floor stops the slide, with a force of \f$ 10^{17} \f$ times the
// load.

#include "signorini/scene/rigid_modes.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// Roundings that a factor may have gone through: normals and modes come out of a few steps
// each.
constexpr double roundings = 64;

// One rigid mode, and what rounding of directions makes of its work. Far from the origin,
// coordinates are rounded to a coarse grid, and so are the directions that are computed from
// them. Then even an entry that should be zero may be wrong by some roundings of the largest
// movement. This counts only between the first and the last unknown that the mode moves: the
// other bodies stand still.
class Mode {
 public:
  Mode(const Eigen::MatrixXd& null_vectors, Index number, double directions)
      : moves_(null_vectors.col(number)), rounding_(roundings * directions * largest(moves_)) {
    while (end_ > 0 && moves_(end_ - 1) == 0) --end_;
    while (begin_ < end_ && moves_(begin_) == 0) ++begin_;
  }
  [[nodiscard]] double at(Index unknown) const { return moves_(unknown); }
  /// What one rounding of an entry is at least. \param unknown  that the entry belongs to
  [[nodiscard]] double rounding(Index unknown) const {
    return unknown >= begin_ && unknown < end_ ? rounding_ : 0;
  }

 private:
  Eigen::MatrixXd::ConstColXpr moves_;
  double rounding_;
  Index begin_ = 0;
  Index end_ = moves_.size();
};

// What forces do along a mode, 0 where the rounding of the factors can make as much. The sum
// itself is exact, so that only the factors are in doubt. An example: 0.1, 0.2 and -0.3
// along a shift by 1 should do no work. As doubles they do \f$ 2.8\cdot 10^{-17} \f$. The
// bound is \f$ (64 + 3)\,\varepsilon\cdot 0.6 = 8.9\cdot 10^{-15} \f$, and the work counts
// as zero.
class WorkAlong {
 public:
  explicit WorkAlong(const Mode& mode) : mode_(mode) {}
  void add(double force, Index unknown) {
    const double moves = mode_.at(unknown);
    directions_ += std::abs(force) * mode_.rounding(unknown);
    if (force == 0 || moves == 0) return;
    sum_.add_product(force, moves);
    size_ += std::abs(force * moves);
    ++terms_;
  }
  [[nodiscard]] double value() const {
    const double rounding = (roundings + static_cast<double>(terms_)) * epsilon * size_;
    return std::abs(sum_.value()) <= std::max(rounding, directions_) ? 0 : sum_.value();
  }

 private:
  const Mode& mode_;
  ExactSum sum_;
  double size_ = 0;
  double directions_ = 0;
  Index terms_ = 0;
};

}  // namespace

// The gap is \f$ g - Au \f$. So a displacement along a mode changes it by \f$ -AN \f$.
Eigen::MatrixXd rigid_gaps(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A,
                           const Eigen::MatrixXd& null_vectors, double directions) {
  require_argument(A.cols() == null_vectors.rows() || null_vectors.cols() == 0,
                   "rigid modes: A has ", A.cols(), " columns and N ", null_vectors.rows(),
                   " rows");
  Eigen::MatrixXd R(A.rows(), null_vectors.cols());
  for (Index j = 0; j < R.cols(); ++j) {
    const Mode mode(null_vectors, j, directions);
    for (Index pair = 0; pair < R.rows(); ++pair) {
      WorkAlong opened(mode);
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator at(A, pair); at; ++at)
        opened.add(-at.value(), at.col());
      R(pair, j) = opened.value();
    }
  }
  return R;
}

// The same doubt about zero, for the load: a load whose parts cancel must not leave a
// resultant that nothing can balance.
Eigen::VectorXd rigid_resultant(const Eigen::VectorXd& load, const Eigen::MatrixXd& null_vectors,
                                double directions) {
  Eigen::VectorXd resultant(null_vectors.cols());
  for (Index j = 0; j < null_vectors.cols(); ++j) {
    const Mode mode(null_vectors, j, directions);
    WorkAlong work(mode);
    for (Index i = 0; i < load.size(); ++i) work.add(-load(i), i);
    resultant(j) = work.value();
  }
  return resultant;
}

// condense() has formed G and d with a grounded K. What is missing are R and r.
void add_rigid_modes(const QuadraticProgramme& programme, const Eigen::MatrixXd& null_vectors,
                     ContactProblem& problem, double directions) {
  const Index n = programme.load.size();
  const Index rows = programme.A.rows();
  require_argument(programme.A.cols() == n && null_vectors.rows() == n, "rigid modes: A must be ",
                   rows, " x ", n, " and N have ", n, " rows, got ", rows, " x ",
                   programme.A.cols(), " and ", null_vectors.rows());
  require_argument(problem.compliance.rows() == rows, "rigid modes: expected a compliance of ",
                   rows, " rows, got ", problem.compliance.rows());
  problem.rigid = rigid_gaps(programme.A, null_vectors, directions);
  problem.resultant = rigid_resultant(programme.load, null_vectors, directions);
}

}  // namespace signorini
