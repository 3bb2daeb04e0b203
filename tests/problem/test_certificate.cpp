#include <limits>
#include <sstream>

#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/problems.hpp"

using Eigen::Vector3d;
using namespace signorini;

namespace {

/// A quadratic programme in whole numbers, with minimiser (1, -1, 2), forces (2, 3, 0) and gaps (0, 0, 4).
QuadraticProgramme small_programme() {
  Eigen::Matrix3d K;
  K << 4, 1, 0, 1, 3, 1, 0, 1, 2;
  Eigen::Matrix3d A;
  A << 1, 1, 0, 0, 1, 1, 1, 0, -1;
  QuadraticProgramme programme;
  programme.stiffness = K.sparseView();
  programme.load = Vector3d(5, 5, 6);
  programme.A = A.sparseView();
  programme.initial_gap = Vector3d(0, 1, 3);
  return programme;
}

PrimalDual small_solution() { return {Vector3d(1, -1, 2), {}, Vector3d(2, 3, 0)}; }

Certificate certificate_of(const Vector3d& u, const Vector3d& force) {
  return certify(small_programme(), {u, {}, force});
}

/// The condensed problem of two pairs, the first one closed, the second one open by 2.
ContactProblem small_problem() {
  Eigen::Matrix2d G;
  G << 2, 1, 1, 2;
  return {G, Eigen::Vector2d(-2, 1)};
}

Certificate condensed_certificate_of(const Eigen::Vector2d& force, const Eigen::Vector2d& gap) {
  return certify(small_problem(), {force, gap, {}, {}});
}

const double slip = 1e-6;  // size of a forgery
const double seen =
    1e-8;  // what its figure must reach, after division by the scales of the problem

}  // namespace

TEST_CASE("the solution of a small programme has a perfect certificate",
          "[certificate][XuanLi2002-11]") {
  const Certificate certificate = certify(small_programme(), small_solution());
  CHECK(certificate.worst() == 0);
  CHECK(certificate.holds());
}

TEST_CASE("forged programme solution: an overlap raises the penetration", "[certificate]") {
  const Certificate forged = certificate_of({1 + slip, -1, 2}, {2, 3, 0});
  CHECK(forged.penetration > seen);
  CHECK(forged.tension == 0);
  CHECK_FALSE(forged.holds());
}

TEST_CASE("forged programme solution: a pulling force raises the tension", "[certificate]") {
  const Certificate forged = certificate_of({1, -1, 2}, {2, 3, -slip});
  CHECK(forged.tension > seen);
  CHECK(forged.penetration == 0);
  CHECK_FALSE(forged.holds());
}

TEST_CASE("forged programme solution: a force across an open gap raises the complementarity",
          "[certificate]") {
  const Certificate forged = certificate_of({1, -1, 2}, {2, 3, slip});
  CHECK(forged.complementarity > seen);
  CHECK(forged.tension == 0);
  CHECK(forged.penetration == 0);
  CHECK_FALSE(forged.holds());
}

TEST_CASE("forged programme solution: unbalanced forces raise the equilibrium", "[certificate]") {
  // (1, -1, 1) moves no gap, since A maps it to zero: only the balance of forces notices.
  const Certificate forged = certificate_of({1 + slip, -1 - slip, 2 + slip}, {2, 3, 0});
  CHECK(forged.equilibrium > seen);
  CHECK(forged.penetration < 1e-15);
  CHECK(forged.complementarity < 1e-15);
  CHECK_FALSE(forged.holds());
}

TEST_CASE("forged programme solution: primal and dual energy that differ raise the duality gap",
          "[certificate]") {
  // A force in an open gap does work that the energies disagree about.
  CHECK(certificate_of({1, -1, 2}, {2, 3, slip}).duality_gap > seen);
  // So does a displacement that the loads do not balance: u moves along the rows of A only.
  CHECK(certificate_of({1 + slip, -1 - slip, 2 + slip}, {2, 3, 0}).duality_gap > seen);
}

TEST_CASE("the figures of a programme are what their definitions say",
          "[certificate][XuanLi2002-6][XuanLi2002-21][LinEtAl-2][LinEtAl-3][LinEtAl-4]") {
  // u = (2, -1, 2), lambda = (2, 3, -1): gaps (-1, 0, 3), p - K u - A^T lambda = (-3, -1, -1).
  const Certificate forged = certificate_of({2, -1, 2}, {2, 3, -1});
  const double root = std::sqrt(2.0);  // norm of every row
  // The pair of the unknowns that move 2 each sets the length: more than 6 / 5, the force over the largest K_jj.
  const double length = 4 / root;
  const double force = 6;  // the largest load; the largest net contact force is 5
  CHECK(forged.penetration == Approx(1 / root / length).epsilon(1e-14));
  CHECK(forged.tension == Approx(root / force).epsilon(1e-14));
  CHECK(forged.complementarity == Approx(3 / (length * force)).epsilon(1e-14));
  CHECK(forged.equilibrium == Approx(3 / force).epsilon(1e-14));
  // lambda . gap - u . residual = -5 + 7; the terms |p u| and |lambda g| sum to 33, length x force is less.
  CHECK(forged.duality_gap == Approx(2 / 33.0).epsilon(1e-14));
}

TEST_CASE("in the duality gap friction forces are loads", "[certificate][friction]") {
  // The first two unknowns are the gap and the slip of a pair, the others hang on the first and carry K u = p.
  Eigen::MatrixXd K = Eigen::MatrixXd::Identity(5, 5);
  K.row(0).tail(3).setConstant(-0.125);
  K.col(0).tail(3).setConstant(-0.125);
  QuadraticProgramme programme;
  programme.stiffness = K.sparseView();
  programme.load = (Eigen::VectorXd(5) << 4, 8, 15.75, 15.75, 15.75).finished();
  programme.A = Eigen::MatrixXd(Eigen::MatrixXd::Identity(2, 5)).sparseView();
  programme.initial_gap = Eigen::Vector2d(1, 0);
  const PrimalDual claim{
      (Eigen::VectorXd(5) << 2, 4, 16, 16, 16).finished(), {}, Eigen::Vector2d(2, 3)};
  const FrictionLaw law = {{0}, Eigen::VectorXd::Ones(1), Eigen::VectorXd::Zero(1)};
  // lambda gap - u . residual = 2 (1 - 2) - 2 (4 + 4 - 2) - 4 (8 - 4 - 3); the energies are lambda g
  // and (p - tau) u.
  CHECK(certify(programme, claim, law).duality_gap ==
        Approx(18.0 / (2 + 4 * 2 + (8 - 3) * 4 + 3 * 15.75 * 16)).epsilon(1e-14));
}

TEST_CASE("the low part of the displacement counts", "[certificate]") {
  const Certificate forged =
      certify(small_programme(), {Vector3d(1, -1, 2), Vector3d(slip, 0, 0), Vector3d(2, 3, 0)});
  CHECK(forged.penetration > seen);
  CHECK(forged.equilibrium > seen);
  // u in two parts that add up to the solution is as good as the solution.
  const double part = 0x1p-30;
  const Certificate split = certify(
      small_programme(), {Vector3d(1 + part, -1, 2), Vector3d(-part, 0, 0), Vector3d(2, 3, 0)});
  CHECK(split.worst() == 0);
}

TEST_CASE("gaps and residuals are those of the signs in use", "[certificate]") {
  const PrimalDual other{Vector3d(1, 0, 0), {}, Vector3d(0, 0, 1)};
  CHECK(gaps(small_programme(), other) == Vector3d(-1, 1, 2));  // g - A u
  CHECK(equilibrium_residual(small_programme(), other) ==
        Vector3d(0, 4, 7));  // p - K u - A^T lambda
}

TEST_CASE("units and the scale of a row change no figure", "[certificate][units]") {
  // Powers of two scale without rounding, so the figures must be equal to the last bit.
  const Vector3d u(1 + slip, -1, 2 - slip);
  const Vector3d force(2, 3 - slip, -slip);
  const Certificate plain = certificate_of(u, force);
  const double length = 0x1p20;
  const double newton = 0x1p-12;
  const Vector3d row(0x1p-26, 0x1p26, 8);
  QuadraticProgramme scaled = small_programme();
  scaled.stiffness *= newton / length;
  scaled.load *= newton;
  scaled.A = row.asDiagonal() * scaled.A;
  scaled.initial_gap = length * row.cwiseProduct(scaled.initial_gap);
  const Certificate other = certify(scaled, {length * u, {}, newton * force.cwiseQuotient(row)});
  CHECK(other.penetration == Approx(plain.penetration).epsilon(1e-14).margin(0));
  CHECK(other.tension == Approx(plain.tension).epsilon(1e-14).margin(0));
  CHECK(other.complementarity == Approx(plain.complementarity).epsilon(1e-14).margin(0));
  CHECK(other.equilibrium == Approx(plain.equilibrium).epsilon(1e-14).margin(0));
  CHECK(other.duality_gap == Approx(plain.duality_gap).epsilon(1e-14).margin(0));
  CHECK(plain.worst() > seen);
}

TEST_CASE("what is not a number is rejected, wherever it stands", "[certificate]") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK_FALSE(certificate_of({1, bad, 2}, {2, 3, 0}).holds(1e300));
    CHECK_FALSE(certificate_of({1, -1, 2}, {2, bad, 0}).holds(1e300));
    CHECK_FALSE(condensed_certificate_of({1, bad}, {0, 2}).holds(1e300));
    CHECK_FALSE(condensed_certificate_of({1, 0}, {bad, 2}).holds(1e300));
  }
}

TEST_CASE("a programme that holds something that is not a number certifies nothing",
          "[certificate]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto holds = [](const QuadraticProgramme& programme) {
    return certify(programme, small_solution()).holds(1e300);
  };
  QuadraticProgramme programme = small_programme();
  REQUIRE(holds(programme));
  programme.stiffness.coeffRef(1, 1) = nan;
  CHECK_FALSE(holds(programme));
  programme = small_programme();
  programme.load(0) = nan;
  CHECK_FALSE(holds(programme));
  programme = small_programme();
  programme.initial_gap(2) = nan;
  CHECK_FALSE(holds(programme));
  CHECK_FALSE(
      certify(small_programme(), {Vector3d(1, -1, 2), Vector3d(nan, 0, 0), Vector3d(2, 3, 0)})
          .holds(1e300));
  for (const Certificate& certificate :
       {Certificate{0, 0, 0, 0, nan}, Certificate{nan, 0, 0, 0, 0}})
    CHECK_FALSE(certificate.holds());
}

TEST_CASE("the condensed solution has a perfect certificate", "[certificate]") {
  CHECK(condensed_certificate_of({1, 0}, {0, 2}).worst() == 0);
}

TEST_CASE("forged condensed solution: an overlap raises the penetration", "[certificate]") {
  const Certificate forged = condensed_certificate_of({1 - slip, 0}, {-2 * slip, 2 - slip});
  CHECK(forged.penetration > seen);
  CHECK(forged.tension == 0);
}

TEST_CASE("forged condensed solution: a pulling force raises the tension", "[certificate]") {
  const Certificate forged = condensed_certificate_of({1 + slip, -slip}, {slip, 2 - slip});
  CHECK(forged.tension > seen);
  CHECK(forged.penetration == 0);
}

TEST_CASE("forged condensed solution: a force across a gap raises the complementarity",
          "[certificate]") {
  const Certificate forged = condensed_certificate_of({1 + slip, 0}, {2 * slip, 2 + slip});
  CHECK(forged.complementarity > seen);
  CHECK(forged.penetration == 0);
  CHECK(forged.tension == 0);
}

TEST_CASE("forged condensed solution: a gap that is not d + G lambda raises the equilibrium",
          "[certificate]") {
  const Certificate forged = condensed_certificate_of({1, 0}, {0, 2 + slip});
  CHECK(forged.equilibrium > seen);
  CHECK(forged.penetration == 0);
  CHECK(forged.complementarity == 0);
}

TEST_CASE("forged condensed solution: work of forces in gaps raises the duality gap",
          "[certificate]") {
  const Certificate forged = condensed_certificate_of({1 + slip, 0}, {2 * slip, 2 + slip});
  CHECK(forged.duality_gap > seen);
}

TEST_CASE("units and the scale of a row change no figure of the condensed problem",
          "[certificate][units]") {
  const ContactProblem problem = small_problem();
  ContactState plain;
  plain.force = Eigen::Vector2d(1 + slip, -slip);
  plain.gap = Eigen::Vector2d(slip, 2);
  const Eigen::Vector2d row(0x1p-26, 0x1p26);
  ContactState other;
  other.force = 0x1p-12 * plain.force.cwiseQuotient(row);
  other.gap = 0x1p20 * plain.gap.cwiseProduct(row);
  const Certificate first = certify(problem, plain);
  const Certificate second = certify(
      signorini_test::in_units(signorini_test::with_rows(problem, row), 0x1p20, 0x1p-12), other);
  CHECK(second.penetration == Approx(first.penetration).epsilon(1e-14).margin(0));
  CHECK(second.tension == Approx(first.tension).epsilon(1e-14).margin(0));
  CHECK(second.complementarity == Approx(first.complementarity).epsilon(1e-14).margin(0));
  CHECK(second.equilibrium == Approx(first.equilibrium).epsilon(1e-14).margin(0));
  CHECK(second.duality_gap == Approx(first.duality_gap).epsilon(1e-14).margin(0));
  CHECK(first.worst() > seen);
}

TEST_CASE("the worst figure decides", "[certificate]") {
  CHECK(Certificate{1, 0, 0, 0, 0}.worst() == 1);
  CHECK(Certificate{0, 2, 0, 0, 0}.worst() == 2);
  CHECK(Certificate{0, 0, 3, 0, 0}.worst() == 3);
  CHECK(Certificate{0, 0, 0, 4, 0}.worst() == 4);
  CHECK(Certificate{0, 0, 0, 0, 5}.worst() == 5);
  CHECK(Certificate{0, 0, 0, 1e-12, 0}.holds());
  CHECK_FALSE(Certificate{0, 0, 0, 2e-12, 0}.holds());
  std::ostringstream out;
  out << Certificate{1, 2, 3, 4, 5};
  CHECK(out.str() ==
        "penetration 1.0e+00, tension 2.0e+00, complementarity 3.0e+00, equilibrium 4.0e+00, "
        "duality gap 5.0e+00");
}

TEST_CASE("sizes that do not fit are refused", "[certificate]") {
  const Eigen::Vector2d two(1, 2);
  CHECK_THROWS_AS(certify(small_programme(), {two, {}, Vector3d(2, 3, 0)}), std::invalid_argument);
  CHECK_THROWS_AS(certify(small_programme(), {Vector3d(1, -1, 2), {}, two}), std::invalid_argument);
  CHECK_THROWS_AS(certify(small_programme(), {Vector3d(1, -1, 2), two, Vector3d(2, 3, 0)}),
                  std::invalid_argument);
  CHECK_THROWS_AS(certify(small_problem(), {Vector3d(1, 0, 0), two, {}, {}}),
                  std::invalid_argument);
}

TEST_CASE("what moves far, in a body of its own or in two parts that cancel, hides nothing",
          "[certificate][floating]") {
  // Two bodies of two nodes each, joined by springs; the first is free, a load of 1 pulls at the second.
  Eigen::Matrix4d K;
  K << 1, -1, 0, 0, -1, 1, 0, 0, 0, 0, 2, -1, 0, 0, -1, 1;
  QuadraticProgramme programme;
  programme.stiffness = K.sparseView();
  programme.load = Eigen::Vector4d(0, 0, 0, 1);
  programme.A = Eigen::MatrixXd(Eigen::RowVector4d(1, 0, 0, 0)).sparseView();
  programme.initial_gap = Eigen::VectorXd::Constant(1, 1e40);
  const auto certified = [&](const Eigen::Vector4d& u, const Eigen::VectorXd& low, double far) {
    PrimalDual claim{u, low, Eigen::VectorXd::Zero(1)};
    claim.rigid = Eigen::Vector4d(far, far, 0, 0);
    return certify(programme, claim);
  };
  CHECK(certified({0, 0, 1, 2}, {}, 0).holds());
  CHECK_FALSE(certified({0, 0, 1, 1}, {}, 0).holds());
  CHECK_FALSE(certified({-1e33, -1e33, 1, 1}, {}, -1e33).holds());
  PrimalDual second{Eigen::Vector4d(1e13, 1e13, -7, -7), {}, Eigen::VectorXd::Zero(1)};
  second.rigid = second.displacement;  // K times it is 0 for the first body, not for the second
  CHECK_FALSE(certify(programme, second).holds());
  PrimalDual stretched{Eigen::Vector4d(1e9, 1e9 + 1, 1, 2), {}, Eigen::VectorXd::Zero(1)};
  stretched.rigid = Eigen::Vector4d(1e9, 1e9 + 1, 0, 0);  // a strain of 1e-9 is a force of 1
  CHECK_FALSE(certify(programme, stretched).holds());
  QuadraticProgramme touching = programme;
  touching.initial_gap(0) = 0.5;  // an overlap of 0.5 beside parts that cancel
  const double part = 0x1p45;
  CHECK_FALSE(certify(touching, {Eigen::Vector4d(1 + part, 1 + part, 1, 2),
                                 Eigen::Vector4d(-part, -part, 0, 0), Eigen::VectorXd::Zero(1)})
                  .holds());
}

TEST_CASE("a law that is none is refused", "[certificate][friction]") {
  QuadraticProgramme programme;
  programme.stiffness = Eigen::MatrixXd(Eigen::Matrix2d::Identity()).sparseView();
  programme.load = Eigen::Vector2d::Zero();
  programme.A = Eigen::MatrixXd(Eigen::Matrix2d::Identity()).sparseView();
  programme.initial_gap = Eigen::Vector2d(1, 0);
  const PrimalDual still{Eigen::Vector2d::Zero(), {}, Eigen::Vector2d::Zero()};
  const auto law = [](Eigen::Index pair, double mu, double c) {
    return FrictionLaw{{pair}, Eigen::VectorXd::Constant(1, mu), Eigen::VectorXd::Constant(1, c)};
  };
  CHECK(certify(programme, still, law(0, 0.3, 0)).holds());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const FrictionLaw& wrong : {law(1, 0.3, 0), law(-1, 0.3, 0), law(0, nan, 0), law(0, -1, 0),
                                   law(0, 0.3, nan), law(0, 0.3, -1)})
    CHECK_THROWS_AS(certify(programme, still, wrong), std::invalid_argument);
}
