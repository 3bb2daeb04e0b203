// What springs add to K.
#include <Eigen/Eigenvalues>
#include <limits>

#include "addons/effects/springs.hpp"
#include "catch_compat.hpp"
#include "signorini/fem/elements.hpp"
#include "support/meshes.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

VectorXd field(const Mesh& mesh, const VectorField& u) {
  VectorXd values(2 * mesh.n_nodes());
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    values.segment<2>(2 * node) = u(mesh.nodes.row(node));
  return values;
}

}  // namespace

// A displacement y along a side of length 2 with 5 N/m^3 in x, 7 in y, 0.5 m thick: k t * 8/3 / 2 of energy each.
TEST_CASE("springs along a boundary store the energy of linear displacements exactly",
          "[springs]") {
  for (const Element& element : elements()) {
    const Mesh mesh = block_for(element, {3, 2}, 3, 4);
    const Eigen::SparseMatrix<double> K = spring_stiffness(mesh, {0.5}, {{"right", {5, 7}}});
    const VectorXd sideways = field(mesh, [](const Vector2d& x) { return Vector2d(x.y(), 0); });
    const VectorXd along = field(mesh, [](const Vector2d& x) { return Vector2d(0, x.y()); });
    CHECK(sideways.dot(K * sideways) == Approx(5 * 0.5 * 8 / 3).epsilon(1e-14));
    CHECK(along.dot(K * along) == Approx(7 * 0.5 * 8 / 3).epsilon(1e-14));
    CHECK(sideways.dot(K * along) == 0);
    const MatrixXd dense(K);
    CHECK(dense == dense.transpose());
    CHECK(Eigen::SelfAdjointEigenSolver<MatrixXd>(dense).eigenvalues()(0) >= -1e-14);
    for (Index node = 0; node < mesh.n_nodes(); ++node)
      CHECK((K.coeff(2 * node, 2 * node) > 0) == (mesh.nodes(node, 0) == 3));
  }
}

TEST_CASE("a spring at a point is that of one node, and springs add up", "[springs]") {
  const Mesh mesh = block_for(q4(), {3, 2}, 3, 2);
  const MatrixXd one(spring_stiffness(mesh, {0.5}, {{"right", {5, 0}, Vector2d(3, 2)}}));
  CHECK(one(22, 22) == 5);
  CHECK(one.cwiseAbs().sum() == 5);
  const MatrixXd along(spring_stiffness(mesh, {0.5}, {{"right", {1, 2}}}));
  const MatrixXd both(
      spring_stiffness(mesh, {0.5}, {{"right", {5, 0}, Vector2d(3, 2)}, {"right", {1, 2}}}));
  CHECK((both - one - along).cwiseAbs().maxCoeff() <= 1e-15);
}

TEST_CASE("springs that cannot be are errors", "[springs]") {
  const Mesh mesh = block_for(q4(), {3, 2}, 3, 2);
  const auto message = [&](const Spring& spring) {
    return problem_message([&] { static_cast<void>(spring_stiffness(mesh, {}, {spring})); });
  };
  CHECK_THAT(message({"right", {-1, 0}}),
             ContainsSubstring("springs at 'right' of 'block': a stiffness must be a number >= 0"));
  CHECK_THAT(message({"right", {0, std::numeric_limits<double>::quiet_NaN()}}),
             ContainsSubstring("must be a number >= 0"));
  CHECK_THAT(message({"right", {0, std::numeric_limits<double>::infinity()}}),
             ContainsSubstring("must be a number >= 0"));
  CHECK_THAT(message({"rihgt", {1, 0}}), ContainsSubstring("rihgt"));
  CHECK_THAT(message({"right", {1, 0}, Vector2d(3, 1.5)}),
             ContainsSubstring("spring on 'right': no node lies at (3, 1.5); the nearest, node"));
}
