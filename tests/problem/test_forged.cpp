// Wrong solutions whose errors hide behind something large: each must be found out.
#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"

namespace {

using namespace signorini;
using Eigen::MatrixXd;
using Eigen::VectorXd;

QuadraticProgramme programme(const MatrixXd& K, const VectorXd& p, const MatrixXd& A,
                             const VectorXd& g) {
  return {K.sparseView(), p, Eigen::SparseMatrix<double, Eigen::RowMajor>(A.sparseView()), g};
}
VectorXd vec(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}
const MatrixXd identity = MatrixXd::Identity(2, 2);

}  // namespace

TEST_CASE("forged: an overlap does not hide behind an obstacle far away", "[certificate]") {
  const QuadraticProgramme far = programme(identity, vec({1, 0}), identity, vec({0, 1e13}));
  CHECK_FALSE(certify(far, {vec({1, 0}), {}, vec({0, 0})}).holds());
  CHECK(certify(far, {vec({0, 0}), {}, vec({1, 0})}).holds());
  const ContactProblem condensed{identity, vec({-1, 1e13})};
  CHECK_FALSE(certify(condensed, {vec({0, 0}), condensed.free_gap, {}, {}}).holds());
  CHECK(certify(condensed, {vec({1, 0}), vec({0, 1e13}), {}, {}}).holds());
}

TEST_CASE("forged: contact forces that cancel do not dwarf the equilibrium", "[certificate]") {
  MatrixXd slot(2, 2);
  slot << 1, 0, -1, 0;
  const QuadraticProgramme squeezed = programme(identity, vec({0, 1}), slot, vec({0, 0}));
  CHECK_FALSE(certify(squeezed, {vec({0, 0}), {}, vec({1e30, 1e30})}).holds());
  CHECK(certify(squeezed, {vec({0, 1}), {}, vec({3, 3})}).holds());
  MatrixXd G(2, 2);
  G << 1, -1, -1, 1;
  const ContactProblem condensed{G, vec({-1, 2})};
  CHECK_FALSE(certify(condensed, {vec({1e30, 1e30}), vec({0, 2}), {}, {}}).holds());
}

TEST_CASE("forged: an empty row of A carries no force", "[certificate]") {
  MatrixXd A = MatrixXd::Zero(1, 2);
  const QuadraticProgramme nothing = programme(identity, vec({0, 1}), A, vec({0}));
  CHECK_FALSE(certify(nothing, {vec({0, 0}), {}, vec({1e30})}).holds());
  CHECK(certify(nothing, {vec({0, 1}), {}, vec({0})}).holds());
}

TEST_CASE("forged: an overlap does not hide behind how far a weak body could go", "[certificate]") {
  const MatrixXd one = MatrixXd::Ones(1, 1);
  const QuadraticProgramme weak = programme(1e-20 * one, vec({1}), one, vec({-1}));
  CHECK_FALSE(certify(weak, {vec({0}), {}, vec({1})}).holds());
  CHECK(certify(weak, {vec({-1}), {}, vec({1})}).holds());
}

TEST_CASE("a pair that bears without moving is certified", "[certificate]") {
  const QuadraticProgramme pressed =
      programme(MatrixXd::Ones(1, 1), vec({1}), MatrixXd::Ones(1, 1), vec({0}));
  CHECK(certify(pressed, {vec({1e-16}), {}, vec({1})}).holds());
  CHECK_FALSE(certify(pressed, {vec({1e-6}), {}, vec({1})}).holds());
}
