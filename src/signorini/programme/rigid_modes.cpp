#include "signorini/programme/rigid_modes.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// A sum of products, 0 where the rounding of the factors can make as much.
class Entry {
 public:
  void add_product(double a, double b) {
    if (a == 0 || b == 0) return;
    sum_.add_product(a, b);
    size_ += std::abs(a * b);
    ++terms_;
  }
  [[nodiscard]] double value() const {
    const double rounding = static_cast<double>(64 + terms_) * epsilon;
    return std::abs(sum_.value()) <= rounding * size_ ? 0 : sum_.value();
  }

 private:
  ExactSum sum_;
  double size_ = 0;
  Index terms_ = 0;
};

}  // namespace

Eigen::MatrixXd rigid_gaps(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A,
                           const Eigen::MatrixXd& null_vectors) {
  require(A.cols() == null_vectors.rows() || null_vectors.cols() == 0, "rigid modes: A has ",
          A.cols(), " columns and N ", null_vectors.rows(), " rows");
  Eigen::MatrixXd R(A.rows(), null_vectors.cols());
  for (Index j = 0; j < R.cols(); ++j)
    for (Index pair = 0; pair < R.rows(); ++pair) {
      Entry opened;
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator at(A, pair); at; ++at)
        opened.add_product(-at.value(), null_vectors(at.col(), j));
      R(pair, j) = opened.value();
    }
  return R;
}

Eigen::VectorXd rigid_resultant(const Eigen::VectorXd& load, const Eigen::MatrixXd& null_vectors) {
  Eigen::VectorXd resultant(null_vectors.cols());
  for (Index j = 0; j < null_vectors.cols(); ++j) {
    Entry work;
    for (Index i = 0; i < load.size(); ++i) work.add_product(-load(i), null_vectors(i, j));
    resultant(j) = work.value();
  }
  return resultant;
}

void add_rigid_modes(const QuadraticProgramme& programme, const Eigen::MatrixXd& null_vectors,
                     ContactProblem& problem) {
  const Index n = programme.load.size();
  const Index rows = programme.A.rows();
  require(programme.A.cols() == n && null_vectors.rows() == n, "rigid modes: A must be ", rows,
          " x ", n, " and N have ", n, " rows, got ", rows, " x ", programme.A.cols(), " and ",
          null_vectors.rows());
  require(problem.compliance.rows() == rows, "rigid modes: expected a compliance of ", rows,
          " rows, got ", problem.compliance.rows());
  problem.rigid = rigid_gaps(programme.A, null_vectors);
  problem.resultant = rigid_resultant(programme.load, null_vectors);
}

}  // namespace signorini
