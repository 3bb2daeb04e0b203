// Whether two vectors or matrices agree, for checks that show both when they do not.
#pragma once
#include <Eigen/Core>
#include <ostream>

namespace signorini_test {

/// What CHECK(equal_within(...)) asks and prints.
struct Agreement {
  bool holds;
  Eigen::MatrixXd is, expected;
  explicit operator bool() const { return holds; }
};

inline std::ostream& operator<<(std::ostream& out, const Agreement& agreement) {
  const Eigen::IOFormat rows(7, Eigen::DontAlignCols, ", ", "; ", "", "", "(", ")");
  const auto shown = [](const Eigen::MatrixXd& x) {
    return x.cols() == 1 ? Eigen::MatrixXd(x.transpose()) : x;
  };
  return out << shown(agreement.is).format(rows) << ", expected "
             << shown(agreement.expected).format(rows);
}

/// \param is        any numbers
/// \param expected  what they should be
/// \param most      largest norm of the difference
/// \return whether sizes and numbers agree
template <typename Is, typename Expected>
Agreement equal_within(const Eigen::DenseBase<Is>& is, const Eigen::DenseBase<Expected>& expected,
                       double most) {
  const Eigen::MatrixXd one = is.derived().matrix(), two = expected.derived().matrix();
  return {one.rows() == two.rows() && one.cols() == two.cols() && (one - two).norm() <= most, one,
          two};
}

}  // namespace signorini_test

using signorini_test::equal_within;
