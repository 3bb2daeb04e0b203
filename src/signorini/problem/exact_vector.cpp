// # Vectors in twice the working precision
//
// A residual is a small difference of large numbers. In plain doubles \f$ (1 + 10^{-17}) - 1 \f$ is
// 0, because 1 + 1e-17 is rounded to 1. The error of an addition is a double itself, and ExactSum
// computes it. After 1 + 1e-17 it holds the pair (1, 1e-17). After -1 more it holds (0, 1e-17), and
// the value is 1e-17. This is the *two-sum* of Møller and Knuth. Products have a like one:
// \f$ (1 + 2^{-30})^2 \f$ is rounded to \f$ 1 + 2^{-29} \f$, and the lost \f$ 2^{-60} \f$ is kept.
//
// Here many such sums stand side by side, as two vectors.

#include "signorini/problem/exact_vector.hpp"

#include "signorini/core/exact_sum.hpp"

namespace signorini {

// A column times a number is added to all sums. The pair of each sum is loaded, grows by one
// product and is stored again.
void ExactVector::add_product(const Eigen::Ref<const Eigen::VectorXd>& column, double factor) {
  for (Eigen::Index i = 0; i < high_.size(); ++i) {
    ExactSum sum(high_(i), low_(i));
    sum.add_product(column(i), factor);
    high_(i) = sum.high();
    low_(i) = sum.low();
  }
}

// A sparse column reaches only the rows in which it has an entry.
void ExactVector::add_product(const Eigen::SparseMatrix<double>& matrix, Eigen::Index column,
                              double factor) {
  for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
    ExactSum sum(high_(entry.row()), low_(entry.row()));
    sum.add_product(entry.value(), factor);
    high_(entry.row()) = sum.high();
    low_(entry.row()) = sum.low();
  }
}

// \f$ A^T y \f$ has one sum for each column of A. The inner loop runs along a column, and the sum
// stays in registers until the column ends.
void ExactVector::add_products(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& factors) {
  for (Eigen::Index i = 0; i < high_.size(); ++i) {
    ExactSum sum(high_(i));
    for (Eigen::Index k = 0; k < factors.size(); ++k) sum.add_product(matrix(k, i), factors(k));
    high_(i) = sum.high();
    low_(i) += sum.low();
  }
}

}  // namespace signorini
