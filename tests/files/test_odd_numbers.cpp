// Small problems with numbers of all magnitudes: every solver refuses them, or ends without a solution,
// or solves them.
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "catch_compat.hpp"
#include "fuzz/check_text.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/table.hpp"
#include "support/sample.hpp"

using namespace signorini;

namespace {

/// A number that is often small and whole, and sometimes at an end of what doubles hold.
double odd(Random& random, int wildness) {
  static const double ends[] = {0,       -0.0,   1e-8,   1e8,    1e16,   1e-16,
                                1e-40,   1e40,   1e-75,  1e100,  1e-100, 1e102,
                                1e-102,  1e74,   1e-76,  1e76,   1e-155, 1e154,
                                1e300,   1e-300, 5e-324, 1e-310, 1e19,   1.7976931348623157e308,
                                1.0 / 3, 0.1};
  const double sign = random.whole(0, 1) == 0 ? 1 : -1;
  if (random.whole(0, 9) >= wildness) return sign * random.whole(0, 3);
  return sign * ends[random.whole(0, static_cast<int>(std::size(ends)) - 1)];
}

std::string row(Random& random, int count, int wildness) {
  std::string line;
  for (int j = 0; j < count; ++j) line += shortest(odd(random, wildness)) + " ";
  return line + "\n";
}

/// A symmetric matrix: B B^T of small whole numbers with rows scaled by odd numbers, or odd entries.
std::string symmetric(Random& random, int n, int wildness) {
  Eigen::MatrixXd B(n, n);
  for (Eigen::Index k = 0; k < B.size(); ++k) B.data()[k] = random.whole(-2, 2);
  Eigen::MatrixXd M = B * B.transpose();
  for (int i = 0; i < n; ++i)
    if (random.whole(0, 9) < wildness) {
      const double scale = std::ldexp(1.0, random.whole(-200, 200));
      M.row(i) *= scale;
      M.col(i) *= scale;
    }
  if (random.whole(0, 9) < wildness)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j) M(i, j) = M(j, i) = odd(random, wildness);
  std::string text;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) text += shortest(M(i, j)) + " ";
    text += "\n";
  }
  return text;
}

std::string complementarity(Random& random, int wildness) {
  const int n = random.whole(1, 5);
  std::string text = "n " + std::to_string(n) + "\nM\n";
  if (random.whole(0, 3) > 0) {
    text += symmetric(random, n, wildness);
  } else {
    for (int i = 0; i < n; ++i) text += row(random, n, wildness);
  }
  return text + "q\n" + row(random, n, wildness);
}

std::string quadratic(Random& random, int wildness) {
  const int n = random.whole(1, 4);
  const int m = random.whole(0, 5);
  std::string text = "n " + std::to_string(n) + "\nm " + std::to_string(m) + "\nr 1\nP\n" +
                     symmetric(random, n, wildness) + "q\n" + row(random, n, wildness) + "A\n";
  for (int i = 0; i < m; ++i) text += row(random, n, wildness);
  std::string lower = "l\n";
  std::string upper = "u\n";
  for (int i = 0; i < m; ++i) {
    double low = random.whole(0, 2) == 0 ? -1e20 : odd(random, wildness / 2);
    double high = random.whole(0, 2) == 0   ? 1e20
                  : random.whole(0, 2) == 0 ? low
                                            : odd(random, wildness / 2);
    if (low > high) std::swap(low, high);
    lower += shortest(low) + " ";
    upper += shortest(high) + " ";
  }
  return text + lower + "\n" + upper + "\n";
}

}  // namespace

TEST_CASE("problems with odd numbers are refused, given up, or solved and certified",
          "[problem_file][hard]") {
  Random random(2026);
  for (int sample = 0; sample < 4000; sample += signorini_test::sample_step) {
    const int wildness = sample % 8;
    const std::string text =
        sample % 2 == 0 ? complementarity(random, wildness) : quadratic(random, wildness);
    const std::string wrong = signorini_test::check_text(text);
    if (!wrong.empty()) {
      CAPTURE(sample, text);
      CHECK(wrong == "");
    }
  }
}
