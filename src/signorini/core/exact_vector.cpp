#include "signorini/core/exact_vector.hpp"

#include "signorini/core/exact_sum.hpp"

namespace signorini {

void ExactVector::add_product(const Eigen::Ref<const Eigen::VectorXd>& column, double factor) {
  const double splitter = 134217729.0;  // 2^27 + 1: two halves of at most 26 bits
  const double scaled = splitter * factor;
  const double f_high = scaled - (scaled - factor);
  const double f_low = factor - f_high;
  const double* a = column.data();
  double* high = high_.data();
  double* low = low_.data();
  const Eigen::Index n = high_.size();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double product = a[i] * factor;
    const double large = splitter * a[i];
    const double a_high = large - (large - a[i]);
    const double a_low = a[i] - a_high;
    const double error =
        a_low * f_low - (((product - a_high * f_high) - a_low * f_high) - a_high * f_low);
    const double sum = high[i] + product;
    const double part = sum - high[i];
    low[i] = (low[i] + ((high[i] - (sum - part)) + (product - part))) + error;
    high[i] = sum;
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
