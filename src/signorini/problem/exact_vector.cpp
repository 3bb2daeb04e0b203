#include "signorini/problem/exact_vector.hpp"

#include "signorini/problem/exact_sum.hpp"

namespace signorini {

void ExactVector::add_product(const Eigen::Ref<const Eigen::VectorXd>& column, double factor) {
  for (Eigen::Index i = 0; i < high_.size(); ++i) {
    ExactSum sum(high_(i), low_(i));
    sum.add_product(column(i), factor);
    high_(i) = sum.high();
    low_(i) = sum.low();
  }
}

void ExactVector::add_product(const Eigen::SparseMatrix<double>& matrix, Eigen::Index column,
                              double factor) {
  for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
    ExactSum sum(high_(entry.row()), low_(entry.row()));
    sum.add_product(entry.value(), factor);
    high_(entry.row()) = sum.high();
    low_(entry.row()) = sum.low();
  }
}

void ExactVector::add_products(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& factors) {
  for (Eigen::Index i = 0; i < high_.size(); ++i) {
    ExactSum sum(high_(i));
    for (Eigen::Index k = 0; k < factors.size(); ++k) sum.add_product(matrix(k, i), factors(k));
    high_(i) = sum.high();
    low_(i) += sum.low();
  }
}

}  // namespace signorini
