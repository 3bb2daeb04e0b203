// Triangles, alone and beside quadrilaterals.
#include <cmath>

#include "catch_compat.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/free_motions.hpp"
#include "signorini/fem/stress.hpp"
#include "support/linear_solve.hpp"
#include "support/meshes.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::block_for;
using signorini_test::given_around;
using signorini_test::problem_message;
using signorini_test::solve_body;

namespace {

/// The right half of a block of 4 x 2 cells cut into triangles, and the whole bent if it is to be.
Mesh half_cut(const Element& element, double bend = 0) {
  const Mesh mesh = split(block_for(element, {4, 2}, 4, 2), std::vector<Index>{2, 3, 6, 7});
  return mapped(mesh, [bend](const Vector2d& x) {
    return Vector2d(x.x() + bend * x.y() * x.y(), x.y() + bend * x.x() * (4 - x.x()));
  });
}

}  // namespace

// Closed form: the integral of x^a y^b over the triangle is a! b! / (a + b + 2)!.
TEST_CASE("rules on the triangle are exact up to their degree, and not beyond", "[element]") {
  const auto exact = [](int a, int b) {
    return std::tgamma(a + 1) * std::tgamma(b + 1) / std::tgamma(a + b + 3);
  };
  for (const int n : {3, 6}) {
    const int degree = n == 3 ? 2 : 4;
    const std::vector<GaussPoint>& rule = gauss_triangle(n);
    CHECK(rule.size() == static_cast<std::size_t>(n));
    for (const GaussPoint& point : rule)
      CHECK((point.weight > 0 && point.xi > 0 && point.eta > 0 && point.xi + point.eta < 1));
    for (int a = 0; a <= degree + 1; ++a)
      for (int b = 0; a + b <= degree + 1; ++b) {
        CAPTURE(n, a, b);
        double sum = 0;
        for (const GaussPoint& point : rule)
          sum += point.weight * std::pow(point.xi, a) * std::pow(point.eta, b);
        if (a + b <= degree)
          CHECK(sum == Approx(exact(a, b)).epsilon(1e-14).margin(0));
        else if (a == 0 || b == 0)
          CHECK(std::abs(sum / exact(a, b) - 1) > 1e-3);
      }
  }
  CHECK_THROWS_AS(gauss_triangle(4), std::invalid_argument);
}

TEST_CASE("without a name a mesh gets the usual element, a name that does not fit is refused",
          "[element]") {
  for (const Element& element : {q4_incompatible(), q8(), t3(), t6()}) {
    const Mesh mesh = block_for(element, {2, 1}, 2, 1);
    CHECK(element_for(mesh, "").name == std::string(element.name));
    CHECK(element_for(mesh, element.name).shape == element.shape);
  }
  const Mesh mixed = half_cut(q4());
  CHECK(element_for(mixed, "").name == std::string("q4_incompatible"));
  CHECK(element_for(mixed, "q4_bbar").name == std::string("q4_bbar"));
  const auto complaint = [](const Mesh& mesh, const char* name) {
    return problem_message([&] { static_cast<void>(element_for(mesh, name)); });
  };
  CHECK(complaint(mixed, "t3") ==
        "mesh 'block' has cells of 4 nodes, but the element t3 needs 3; take "
        "q4_incompatible or another mesh");
  CHECK(complaint(split(mixed), "q4") ==
        "mesh 'block' has cells of 3 nodes, but the element q4 needs 4; take t3 or another mesh");
  CHECK(complaint(half_cut(q8()), "q4") ==
        "mesh 'block' has cells of 8 nodes, but the element q4 needs 4; take q8 or another mesh");
  CHECK_THAT(complaint(mixed, "q5"), ContainsSubstring("unknown element 'q5'"));
}

TEST_CASE("linear displacements are linear in mixed meshes, curved ones among them",
          "[element][patch]") {
  const VectorField exact = [](const Vector2d& x) {
    return Vector2d(1e-3 + 2e-3 * x.x() - 1e-3 * x.y(), -2e-3 + 3e-3 * x.x() + 1.5e-3 * x.y());
  };
  const Material material{1000, 0.3, PlaneState::Strain, 0.5};
  const Eigen::Vector3d stress = elasticity_matrix(material) * Eigen::Vector3d(2e-3, 1.5e-3, 2e-3);
  for (const Element& element : {q4(), q4_bbar(), q4_incompatible(), q8()})
    for (const double bend : {0.0, 0.05}) {
      CAPTURE(element.name, bend);
      const Mesh mesh = half_cut(element, bend);
      const NodeArray u = solve_body(mesh, element, material, given_around(exact));
      const double size = u.rowwise().norm().maxCoeff();
      for (Index node = 0; node < mesh.n_nodes(); ++node) {
        const Vector2d x = mesh.nodes.row(node).transpose();
        CHECK((u.row(node).transpose() - exact(x)).norm() < 1e-12 * size);
      }
      const StressArray at_nodes = nodal_stress(mesh, element, material, u);
      const StressArray of_cells = cell_stress(mesh, element, material, u);
      CHECK((at_nodes.leftCols(3).rowwise() - stress.transpose()).norm() < 1e-10 * stress.norm());
      CHECK((of_cells.leftCols(3).rowwise() - stress.transpose()).norm() < 1e-10 * stress.norm());
      // Nodes inside are in equilibrium, and all together.
      const NodeArray forces = internal_forces(mesh, element, material, u);
      CHECK(forces.colwise().sum().norm() < 1e-12 * forces.norm());
    }
}

// What its rule of degree 4 is for: with three points nodes inside would be off by 5e-6.
TEST_CASE("curved triangles of 6 nodes keep a uniform stress in axial symmetry",
          "[element][patch]") {
  const VectorField exact = [](const Vector2d& x) {
    return Vector2d(2e-3 * x.x(), 1e-3 - 3e-3 * x.y());
  };
  const Material material{1000, 0.3, PlaneState::Axial, 1};
  const Mesh mesh = moved(split(half_cut(q8(), 0.05)), {1, 0});
  const NodeArray u = solve_body(mesh, t6(), material, given_around(exact));
  const double size = u.rowwise().norm().maxCoeff();
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const Vector2d x = mesh.nodes.row(node).transpose();
    CHECK((u.row(node).transpose() - exact(x)).norm() < 1e-12 * size);
  }
}

TEST_CASE("a body force on a mixed mesh is its density times area", "[element]") {
  const Material material{1000, 0.3, PlaneState::Strain, 0.5};
  Loads loads;
  loads.body_force = [](const Vector2d& x) { return Vector2d(2 + x.y(), x.x()); };
  for (const Element& element : {q4(), q8()}) {
    const NodeArray force = nodal_loads(half_cut(element), element, material, loads);
    CHECK((force.colwise().sum() - Eigen::RowVector2d(12, 8)).norm() < 1e-13);
  }
}

TEST_CASE("a mixed mesh is one body with three rigid motions", "[free_motions]") {
  for (const Element& element : {q4(), q8(), t3(), t6()}) {
    const Mesh mesh = element.corners() == 3 ? block_for(element, {4, 2}, 4, 2) : half_cut(element);
    CHECK(free_motions(mesh, number_unknowns(mesh, {})).size() == 3);
    CHECK(free_motions(mesh, number_unknowns(mesh, {fixed("left")})).empty());
  }
}

// The middle of a side may move across it without leaving the middle half along it.
TEST_CASE("a triangle that folds over itself is refused", "[assembly]") {
  Mesh mesh = block_for(t6(), {1, 1}, 1, 1);
  const Index middle = mesh.cells(0, 3);
  REQUIRE(mesh.nodes.row(middle) == Eigen::RowVector2d(0.5, 0));
  const Unknowns unknowns = number_unknowns(mesh, {fixed("left")});
  const auto complaint = [&] {
    return problem_message([&] { static_cast<void>(assemble(mesh, t6(), {}, unknowns, {})); });
  };
  CHECK(complaint().empty());
  mesh.nodes.row(middle) << 0.5, 0.45;
  CHECK_NOTHROW(check_mesh(mesh));
  CHECK_THAT(complaint(), ContainsSubstring("cell 0 folds over itself"));
}
