#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "support/meshes.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::RowVector2d;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::block_for;
using signorini_test::problem_message;

namespace {

/// Moment of nodal forces about the origin.
double moment_of(const Mesh& mesh, const NodeArray& force) {
  return mesh.nodes.col(0).dot(force.col(1)) - mesh.nodes.col(1).dot(force.col(0));
}

/// A sheet that is bent: no side of it is straight.
Mesh curved(const Element& element) {
  return mapped(block_for(element, {3, 2}, 3, 2), [](const Vector2d& x) {
    return Vector2d(x.x() + 0.1 * std::sin(2 * x.y()), x.y() + 0.15 * std::sin(x.x() + x.y()));
  });
}

Material sheet(double thickness) { return {100, 0.3, PlaneState::Stress, thickness}; }

}  // namespace

TEST_CASE("a pressure pushes against the body, with its length and thickness", "[assembly]") {
  for (const Element& element : {q4(), q8()}) {
    CAPTURE(element.name);
    const Mesh mesh = block_for(element, {3, 2}, 3, 2);
    const auto resultant = [&](const char* side) {
      Loads loads;
      loads.edges.push_back({side, 5, {}});
      const NodeArray force = nodal_loads(mesh, element, sheet(0.5), loads);
      return Eigen::RowVector3d(force.col(0).sum(), force.col(1).sum(), moment_of(mesh, force));
    };
    // 5 x length x 0.5 towards the inside; the lever arm is that of the middle of the side.
    CHECK((resultant("top") - Eigen::RowVector3d(0, -7.5, -7.5 * 1.5)).norm() < 1e-13);
    CHECK((resultant("bottom") - Eigen::RowVector3d(0, 7.5, 7.5 * 1.5)).norm() < 1e-13);
    CHECK((resultant("left") - Eigen::RowVector3d(5, 0, -5)).norm() < 1e-13);
    CHECK((resultant("right") - Eigen::RowVector3d(-5, 0, 5)).norm() < 1e-13);
  }
}

TEST_CASE("a uniform pressure all around a curved body has no resultant", "[assembly]") {
  for (const Element& element : {q4(), q8()}) {
    CAPTURE(element.name);
    const Mesh mesh = curved(element);
    Loads loads;
    for (const char* side : {"bottom", "right", "top", "left"})
      loads.edges.push_back({side, 4, {}});
    const NodeArray force = nodal_loads(mesh, element, sheet(1), loads);
    CHECK(force.norm() > 1);
    CHECK(force.colwise().sum().norm() < 1e-13);
    CHECK(std::abs(moment_of(mesh, force)) < 1e-13);
  }
}

TEST_CASE("a traction that varies along a side has its exact force and moment",
          "[assembly][XuanLi2002-4]") {
  // t = (y, 2 + y) on x = 3, 0 < y < 2, thickness 0.5: force (1, 3), moment 3 x 3 - 0.5 x 8 / 3.
  for (const Element& element : {q4(), q8()}) {
    CAPTURE(element.name);
    const Mesh mesh = block_for(element, {3, 2}, 3, 2);
    Loads loads;
    loads.edges.push_back(
        {"right", 0, [](const Vector2d& x) { return Vector2d(x.y(), 2 + x.y()); }});
    const NodeArray force = nodal_loads(mesh, element, sheet(0.5), loads);
    CHECK((force.colwise().sum() - RowVector2d(1, 3)).norm() < 1e-13);
    CHECK(moment_of(mesh, force) == Approx(9 - 4.0 / 3.0).epsilon(1e-13));
  }
}

TEST_CASE("a pressure on a linear side goes half to each end, on a quadratic one 1:4:1",
          "[assembly]") {
  const auto forces = [](const Element& element) {
    const Mesh mesh = block_for(element, {6, 1}, 1, 1);
    Loads loads;
    loads.edges.push_back({"top", 1, {}});
    const NodeArray force = nodal_loads(mesh, element, sheet(1), loads);
    std::vector<double> list;
    for (const Index node : boundary_nodes(mesh, "top")) list.push_back(-force(node, 1));
    return list;
  };
  const std::vector<double> linear = forces(q4());
  REQUIRE(linear.size() == 2);
  CHECK(linear[0] == Approx(3).epsilon(1e-14));
  CHECK(linear[1] == Approx(3).epsilon(1e-14));
  const std::vector<double> quadratic = forces(q8());
  REQUIRE(quadratic.size() == 3);
  CHECK(quadratic[0] == Approx(1).epsilon(1e-14));
  CHECK(quadratic[1] == Approx(4).epsilon(1e-14));
  CHECK(quadratic[2] == Approx(1).epsilon(1e-14));
}

TEST_CASE("the weights of a boundary sum to its length times thickness", "[assembly]") {
  for (const Element& element : {q4(), q8()}) {
    CAPTURE(element.name);
    const Mesh mesh = mapped(block_for(element, {3, 2}, 3, 2), [](const Vector2d& x) {
      return Vector2d(3 * x.x() - 4 * x.y(), 4 * x.x() + 3 * x.y());  // turned and 5 times larger
    });
    const Eigen::VectorXd weights = boundary_weights(mesh, "bottom", {0.5});
    CHECK(weights.sum() == Approx(7.5).epsilon(1e-14));
    if (element.n_nodes == 4) {
      const Eigen::Vector4d share(0.5, 1, 1, 0.5);
      CHECK((weights - 2.5 * share).norm() < 1e-13);
    } else {
      Eigen::VectorXd share(7);
      share << 1, 4, 2, 4, 2, 4, 1;
      CHECK((weights - 2.5 / 6 * share).norm() < 1e-13);
    }
  }
}

TEST_CASE("the stiffness matrix is symmetric and holds both triangles", "[assembly]") {
  const Element element = q4_incompatible();
  const Mesh mesh = curved(element);
  const LinearSystem system =
      assemble(mesh, element, sheet(1), number_unknowns(mesh, {fixed("left")}), {});
  const Eigen::SparseMatrix<double> transposed = system.stiffness.transpose();
  CHECK((system.stiffness - transposed).norm() == 0);
  CHECK(system.stiffness.nonZeros() > 2 * system.stiffness.rows());
}

TEST_CASE("a given displacement acts as the load that its reaction would do", "[assembly]") {
  // p = -K_fh u_h: the free rows of the whole matrix times the given displacements.
  const Element element = q4();
  const Mesh mesh = curved(element);
  const Unknowns all = number_unknowns(mesh, {});
  const Unknowns some = number_unknowns(mesh, {prescribed("left", Axis::X, 0.5)});
  const LinearSystem whole = assemble(mesh, element, sheet(1), all, {});
  const LinearSystem part = assemble(mesh, element, sheet(1), some, {});
  Eigen::VectorXd given = Eigen::VectorXd::Zero(all.count);
  for (Index node = 0; node < mesh.n_nodes(); ++node) given(2 * node) = some.held(node, 0);
  const Eigen::VectorXd reaction = whole.stiffness * given;
  double difference = 0;
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      if (some.number(node, axis) >= 0)
        difference = std::max(
            difference, std::abs(part.load(some.number(node, axis)) + reaction(2 * node + axis)));
  CHECK(difference < 1e-12 * reaction.norm());
  CHECK(part.load.norm() > 1);
}

TEST_CASE("displacements are put back where they belong", "[assembly]") {
  const Mesh mesh = block_for(q4(), {1, 1}, 1, 1);
  const Unknowns unknowns =
      number_unknowns(mesh, {fixed("left"), prescribed("right", Axis::X, 0.25)});
  const NodeArray all = expand(unknowns, Vector2d(3, 4));
  NodeArray expected(4, 2);
  expected << 0, 0, 0.25, 3, 0, 0, 0.25, 4;
  CHECK(all == expected);
  CHECK_THROWS_AS(expand(unknowns, Eigen::VectorXd::Zero(3)), std::invalid_argument);
}

TEST_CASE("what cannot be assembled is named", "[assembly]") {
  const Mesh mesh = block_for(q4(), {1, 1}, 1, 1);
  const Unknowns unknowns = number_unknowns(mesh, {fixed("left")});
  const auto complaint = [&](const Element& element, const Material& material, const Loads& loads) {
    return problem_message(
        [&] { static_cast<void>(assemble(mesh, element, material, unknowns, loads)); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(complaint(q8(), sheet(1), {}),
             ContainsSubstring("cells of 4 nodes") && ContainsSubstring("q8 needs 8"));
  CHECK_THAT(complaint(q4(), {-1, 0, PlaneState::Strain, 1}, {}), ContainsSubstring("Young's"));
  CHECK_THAT(complaint(q4(), sheet(1), {{}, {{"roof", 1, {}}}}),
             ContainsSubstring("no boundary 'roof'"));
  CHECK_THAT(complaint(q4(), sheet(1), {{}, {{"top", nan, {}}}}),
             ContainsSubstring("load on 'top'") && ContainsSubstring("not finite"));
  CHECK_THAT(complaint(q4(), sheet(1), {[&](const Vector2d&) { return Vector2d(0, nan); }, {}}),
             ContainsSubstring("body force on 'block': not finite at ("));
}
