// Systems that nothing connects: which unknowns and rows they have, and that each is measured by itself.
#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"
#include "addons/certified/separate.hpp"
#include "addons/programme/equation_imbalance.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Numbers = std::vector<Index>;

/// Five unknowns: 0 and 3 are joined by K, 1 and 4 by a row of A, 2 by nothing. Rows: a gap of 1 and 4, a gap of 0, a
/// gap without entries, and the slip of the second gap, which supports give.
QuadraticProgramme three_systems() {
  MatrixXd K = MatrixXd::Identity(5, 5) * 4;
  K(0, 3) = K(3, 0) = -1;
  MatrixXd A = MatrixXd::Zero(4, 5);
  A(0, 1) = 1;
  A(0, 4) = -1;
  A(1, 0) = 1;
  return {K.sparseView(), VectorXd::LinSpaced(5, 1, 5), A.sparseView(), VectorXd::Zero(4)};
}

}  // namespace

TEST_CASE("unknowns are one system where K, a row, a mode or a pair joins them", "[systems]") {
  const QuadraticProgramme programme = three_systems();
  FrictionLaw law{{1}, VectorXd::Constant(1, 0.5), VectorXd::Constant(1, 2)};
  const std::vector<SystemParts> systems = unconnected_systems(programme, law, {});
  REQUIRE(systems.size() == 3);
  CHECK(systems[0].unknowns == Numbers{0, 3});
  CHECK(systems[0].rows == Numbers{1, 2, 3});  // the row without entries is put here
  CHECK(systems[1].unknowns == Numbers{1, 4});
  CHECK(systems[1].rows == Numbers{0});
  CHECK(systems[2].unknowns == Numbers{2});
  CHECK(systems[2].rows.empty());
  const FrictionLaw first = part_of(law, 3, systems[0]);
  CHECK(first.pair == Numbers{0});
  CHECK(first.cohesion(0) == 2);
  CHECK(part_of(law, 3, systems[1]).pair.empty());
  const QuadraticProgramme part = part_of(programme, systems[0]);
  CHECK(part.stiffness.coeff(0, 1) == -1);
  CHECK(part.load == Eigen::Vector2d(1, 4));
  CHECK(part.A.coeff(0, 0) == 1);
  CHECK(part.A.nonZeros() == 1);

  MatrixXd mode = MatrixXd::Zero(5, 2);
  mode(4, 0) = 1;
  mode(1, 1) = mode(2, 1) = 1;
  const std::vector<SystemParts> joined = unconnected_systems(programme, law, mode.sparseView());
  REQUIRE(joined.size() == 2);
  CHECK(joined[1].unknowns == Numbers{1, 2, 4});
  CHECK(joined[1].modes == Numbers{0, 1});

  law.pair = {0};  // the pair of unknowns 1 and 4 has its slip in a row of unknown 0
  QuadraticProgramme frictional_pairs = programme;
  frictional_pairs.A.coeffRef(3, 0) = 1;
  CHECK(unconnected_systems(frictional_pairs, law, {}).size() == 2);
}

TEST_CASE("what is connected is no list of systems", "[systems]") {
  QuadraticProgramme programme = three_systems();
  MatrixXd K = MatrixXd::Identity(5, 5) * 4;
  // Unknowns 0 and 1 are joined by 4 only, which is not the first that it has an entry with.
  for (const auto& [i, j] : {std::pair(0, 2), std::pair(1, 3), std::pair(2, 4), std::pair(3, 4)})
    K(i, j) = K(j, i) = -1;
  programme.stiffness = K.sparseView();
  programme.A.setZero();
  CHECK(unconnected_systems(programme, {}, {}).empty());
}

TEST_CASE("what the matrices say: the diagonal of K, and whether all hangs together", "[systems]") {
  QuadraticProgramme programme = three_systems();
  const KnownMatrices apart = known_matrices(programme, {});
  CHECK(apart.diagonal == VectorXd::Constant(5, 4));
  CHECK(!apart.connected);
  for (const auto& [i, j] : {std::pair<Index, Index>{0, 1}, {1, 2}})
    programme.stiffness.coeffRef(i, j) = programme.stiffness.coeffRef(j, i) = -1;
  programme.stiffness.makeCompressed();
  CHECK(known_matrices(programme, {}).connected);
  programme.stiffness.coeffRef(1, 2) = programme.stiffness.coeffRef(2, 1) = -1e-17;  // rounding
  CHECK(unconnected_systems(programme, {}, {}).empty());
  CHECK(!known_matrices(programme, {}).connected);
}

TEST_CASE("an error of a small system is not measured by a large one", "[systems][certificate]") {
  QuadraticProgramme programme{MatrixXd(MatrixXd::Identity(2, 2)).sparseView(), VectorXd(2),
                               MatrixXd(MatrixXd::Identity(2, 2)).sparseView(), VectorXd::Zero(2)};
  programme.load << 1, 1e-13;  // each pressed flat on its own plane
  PrimalDual solution{VectorXd::Zero(2), {}, programme.load};
  CHECK(certify(programme, solution).worst() == 0);
  solution.force(1) *= 1 + 1e-3;
  const double off = 1e-3 / (1 + 1e-3);  // of the largest force, which is the wrong one
  CHECK(certify(programme, solution).equilibrium == Approx(off).epsilon(1e-12).margin(0));
  CHECK(certify(programme, solution, EquationRows{2, equation_imbalance}).equilibrium == Approx(off).epsilon(1e-12).margin(0));
}

TEST_CASE("an entry of K that is rounding connects nothing, and what it carries is a load",
          "[systems][certificate]") {
  MatrixXd K = MatrixXd::Identity(2, 2);
  K(0, 0) = 0x1p40;  // and all forces there are so many times larger
  K(0, 1) = K(1, 0) = 0x1p-80;
  QuadraticProgramme programme{K.sparseView(), VectorXd(2),
                               MatrixXd(MatrixXd::Identity(2, 2)).sparseView(), VectorXd::Ones(2)};
  programme.A.coeffRef(1, 1) = -1;
  programme.load << 0x1p40, 0;  // the second unknown moves by what the weak entry carries
  PrimalDual solution{Eigen::Vector2d(1, -0x1p-80), {}, VectorXd::Zero(2)};
  CHECK(unconnected_systems(programme, {}, {}).empty());
  CHECK(unconnected_systems(programme, {}, {}, 0x1p-100).size() == 2);
  CHECK(unconnected_systems(programme, {}, {}, 0x1p-101).empty());
  CHECK(certify(programme, solution).holds());
  solution.displacement(1) *= 1 + 1e-3;
  CHECK(certify(programme, solution).equilibrium == Approx(1e-3));
  solution.displacement(1) = 0;  // as if nothing connected them
  CHECK(certify(programme, solution).equilibrium == Approx(1));
}
