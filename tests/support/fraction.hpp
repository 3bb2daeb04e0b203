/// \file
/// Fractions of whole numbers, for iterations small enough to be followed exactly.
#pragma once
#include <numeric>
#include <stdexcept>
#include <string>

namespace exact {

/// A fraction of whole numbers in lowest terms, with a positive denominator.
class Fraction {
 public:
  Fraction(long long numerator = 0, long long denominator = 1)  // NOLINT: whole numbers convert
      : num_(numerator), den_(denominator) {
    if (den_ == 0) throw std::domain_error("fraction: division by zero");
    const long long common = std::gcd(num_, den_) * (den_ < 0 ? -1 : 1);
    num_ /= common;
    den_ /= common;
  }
  friend Fraction operator+(Fraction a, Fraction b) {
    return {sum(times(a.num_, b.den_), times(b.num_, a.den_)), times(a.den_, b.den_)};
  }
  friend Fraction operator-(Fraction a, Fraction b) { return a + Fraction(-b.num_, b.den_); }
  friend Fraction operator*(Fraction a, Fraction b) {
    const Fraction p(a.num_, b.den_);  // cancels first, so that products stay small
    const Fraction q(b.num_, a.den_);
    return {times(p.num_, q.num_), times(p.den_, q.den_)};
  }
  friend Fraction operator/(Fraction a, Fraction b) { return a * Fraction(b.den_, b.num_); }
  friend bool operator==(Fraction a, Fraction b) { return a.num_ == b.num_ && a.den_ == b.den_; }
  friend bool operator<(Fraction a, Fraction b) { return (a - b).num_ < 0; }
  /// \return the nearest double
  [[nodiscard]] double value() const {
    return static_cast<double>(num_) / static_cast<double>(den_);
  }
  /// \return such as -7/6, or 2
  [[nodiscard]] std::string text() const {
    return std::to_string(num_) + (den_ == 1 ? "" : '/' + std::to_string(den_));
  }

 private:
  static long long times(long long a, long long b) {
    long long product = 0;
    if (__builtin_mul_overflow(a, b, &product)) throw std::overflow_error("fraction: too long");
    return product;
  }
  static long long sum(long long a, long long b) {
    long long total = 0;
    if (__builtin_add_overflow(a, b, &total)) throw std::overflow_error("fraction: too long");
    return total;
  }
  long long num_;
  long long den_;
};

}  // namespace exact
