#include "signorini/complementarity/rigid_modes.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"

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
    const double rounding = static_cast<double>(terms_) * std::numeric_limits<double>::epsilon();
    return std::abs(sum_.value()) <= rounding * size_ ? 0 : sum_.value();
  }

 private:
  ExactSum sum_;
  double size_ = 0;
  Index terms_ = 0;
};

}  // namespace

FloatingProblem floating_problem(const QuadraticProgramme& programme, ContactProblem grounded,
                                 const RigidModes& modes) {
  const Index n = programme.load.size();
  const Index pairs = programme.A.rows();
  require(programme.A.cols() == n && modes.shape.rows() == n, "rigid modes: A must be ", pairs,
          " x ", n, " and N have ", n, " rows, got ", pairs, " x ", programme.A.cols(), " and ",
          modes.shape.rows());
  require(grounded.free_gap.size() == pairs && grounded.compliance.rows() == pairs,
          "rigid modes: expected a compliance and gaps of ", pairs, " pairs, got ",
          grounded.compliance.rows(), " and ", grounded.free_gap.size());
  FloatingProblem problem{std::move(grounded), Eigen::MatrixXd(pairs, modes.shape.cols()),
                          Eigen::VectorXd(modes.shape.cols())};
  for (Index j = 0; j < modes.shape.cols(); ++j) {
    for (Index pair = 0; pair < pairs; ++pair) {
      Entry opened;
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator at(programme.A, pair); at;
           ++at)
        opened.add_product(-at.value(), modes.shape(at.col(), j));
      problem.rigid(pair, j) = opened.value();
    }
    Entry work;
    for (Index i = 0; i < n; ++i) work.add_product(-programme.load(i), modes.shape(i, j));
    problem.resultant(j) = work.value();
  }
  return problem;
}

}  // namespace signorini
