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
#include <set>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using SparseMatrix = Eigen::SparseMatrix<double>;

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
  Mode(const SparseMatrix& null_vectors, Index number, double directions) {
    SparseMatrix::InnerIterator first(null_vectors, number);
    begin_ = first ? first.row() : 0;
    for (SparseMatrix::InnerIterator it(null_vectors, number); it; ++it) {
      moves_.resize(static_cast<std::size_t>(it.row() - begin_ + 1), 0);
      moves_.back() = it.value();
      rounding_ = std::max(rounding_, roundings * directions * std::abs(it.value()));
    }
  }
  /// \return the first unknown that it moves, and the one after the last
  [[nodiscard]] Index begin() const { return begin_; }
  [[nodiscard]] Index end() const { return begin_ + static_cast<Index>(moves_.size()); }
  [[nodiscard]] bool reaches(Index unknown) const { return unknown >= begin_ && unknown < end(); }
  /// \param unknown  that it reaches
  [[nodiscard]] double at(Index unknown) const {
    return moves_[static_cast<std::size_t>(unknown - begin_)];
  }
  /// \return what one rounding of an entry is at least, of an unknown that it reaches
  [[nodiscard]] double rounding() const { return rounding_; }

 private:
  Index begin_;
  std::vector<double> moves_;
  double rounding_ = 0;
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
    if (!mode_.reaches(unknown)) return;
    const double moves = mode_.at(unknown);
    directions_ += std::abs(force) * mode_.rounding();
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

// The gap is \f$ g - Au \f$. So a displacement along a mode changes it by \f$ -AN \f$. A mode
// reaches the unknowns of one body, and of many bodies few rows have entries there. The columns
// of A name these rows, so that the others are not even looked at.
SparseMatrix rigid_gaps(const RowMatrix& A, const SparseMatrix& null_vectors, double directions) {
  require_argument(A.cols() == null_vectors.rows() || null_vectors.cols() == 0,
                   "rigid modes: A has ", A.cols(), " columns and N ", null_vectors.rows(),
                   " rows");
  const SparseMatrix columns = A;
  SparseMatrix R(A.rows(), null_vectors.cols());
  for (Index j = 0; j < R.cols(); ++j) {
    const Mode mode(null_vectors, j, directions);
    std::set<Index> felt;
    for (Index unknown = mode.begin(); unknown < mode.end(); ++unknown)
      for (SparseMatrix::InnerIterator at(columns, unknown); at; ++at) felt.insert(at.row());
    R.startVec(j);
    for (const Index pair : felt) {
      WorkAlong opened(mode);
      for (RowMatrix::InnerIterator at(A, pair); at; ++at) opened.add(-at.value(), at.col());
      if (const double value = opened.value(); value != 0) R.insertBack(pair, j) = value;
    }
  }
  R.finalize();
  return R;
}

// The same doubt about zero, for the load: a load whose parts cancel must not leave a
// resultant that nothing can balance.
Eigen::VectorXd rigid_resultant(const Eigen::VectorXd& load, const Eigen::MatrixXd& null_vectors,
                                double directions) {
  const SparseMatrix N = null_vectors.sparseView();
  Eigen::VectorXd resultant(N.cols());
  for (Index j = 0; j < N.cols(); ++j) {
    const Mode mode(N, j, directions);
    WorkAlong work(mode);
    for (Index i = mode.begin(); i < mode.end(); ++i) work.add(-load(i), i);
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
  problem.rigid = rigid_gaps(programme.A, null_vectors.sparseView(), directions);
  problem.resultant = rigid_resultant(programme.load, null_vectors, directions);
}

}  // namespace signorini
