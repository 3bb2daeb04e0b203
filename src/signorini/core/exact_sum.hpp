/// \file
/// Sums of products in about twice the working precision: what residuals are computed with.
#pragma once

namespace signorini {

/// A running sum of doubles and of products of doubles, kept as an unevaluated pair.
///
/// Every rounding error of a sum or a product of two doubles is itself a double; the pair keeps
/// those errors instead of dropping them (error-free transformations [\ref OgitaRumpOishi2005]).
/// The result is as if computed with about 32 digits and rounded once. It must not be compiled with
/// `-ffast-math`, which assumes that the errors are zero, nor with fused multiplications, which
/// make other errors; the library's CMake target passes `-ffp-contract=off` to its users.
/// \tparam Number  double, or a few of them side by side, such as Eigen::Array2d, whose sums have the same bits
template <typename Number>
class ExactSumOf {
 public:
  /// \param value  what the sum starts at
  /// \param low    what the value lacks
  explicit ExactSumOf(const Number& value = 0, const Number& low = 0) : high_(value), low_(low) {}

  /// Adds one number. \param value  the number
  void add(const Number& value) {
    const Number sum = high_ + value;
    const Number part = sum - high_;
    low_ += (high_ - (sum - part)) + (value - part);
    high_ = sum;
  }
  /// Adds the product `a * b` without rounding it, if no step overflows or underflows.
  /// \param a  first factor, of magnitude below 2^996
  /// \param b  second factor, of magnitude below 2^996
  void add_product(const Number& a, const Number& b) {
    const Number product = a * b;
    const Halves x = split(a);
    const Halves y = split(b);
    const Number error =
        x.low * y.low - (((product - x.high * y.high) - x.low * y.high) - x.high * y.low);
    add(product);
    low_ += error;
  }
  /// \return the sum, rounded once
  [[nodiscard]] Number value() const { return high_ + low_; }
  /// \return the larger part of the sum
  [[nodiscard]] Number high() const { return high_; }
  /// \return what the larger part lacks
  [[nodiscard]] Number low() const { return low_; }

 private:
  struct Halves {
    Number high;
    Number low;
  };
  /// Two numbers of at most 26 bits whose sum is `a`; valid for |a| < 2^996.
  static Halves split(const Number& a) {
    const Number scaled = 134217729.0 * a;  // 2^27 + 1
    const Number high = scaled - (scaled - a);
    return {high, a - high};
  }

  Number high_;
  Number low_;
};

/// The sum of plain numbers.
using ExactSum = ExactSumOf<double>;

/// high + low += change, with high the rounded sum.
/// \param[in,out] high, low  the two parts of a number
/// \param change             to be added
inline void add_to(double& high, double& low, double change) {
  const double sum = high + change;
  const double part = sum - high;
  const double rest = ((high - (sum - part)) + (change - part)) + low;
  high = sum + rest;
  low = rest - (high - sum);
}

}  // namespace signorini
