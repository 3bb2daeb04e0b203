#include <algorithm>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "signorini/fem/assembly.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/elements.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using ex0_2::Part;
using ex0_2::System;

namespace {

const signorini::Material material{3, 0.3, signorini::PlaneState::Strain, 2};

// The cells of a block as parts.
std::vector<Part> parts_of(const signorini::Mesh& mesh) {
  std::vector<Part> parts;
  signorini::visit_cells(mesh, signorini::q4(), material, [&](const signorini::Cell& cell) {
    Part part{{}, signorini::cell_stiffness(cell.element, cell.body)};
    for (Index k = 0; k < 4; ++k) part.nodes.push_back(cell.node(k));
    parts.push_back(part);
  });
  return parts;
}

}  // namespace

TEST_CASE("ex0.2 held out: the library's system, with displacements that are given", "[ex0.2]") {
  const signorini::Mesh mesh = signorini::block("block", {0, 0}, {3, 2}, 4, 3);
  const signorini::Unknowns unknowns = signorini::number_unknowns(
      mesh, {signorini::prescribed("left", signorini::Axis::X, -0.2), signorini::fixed("right")});
  std::map<Index, double> held;
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    for (Index axis = 0; axis < 2; ++axis)
      if (unknowns.number(node, axis) < 0) held[2 * node + axis] = unknowns.held(node, axis);
  std::vector<Part> parts = parts_of(mesh);
  std::reverse(parts.begin(), parts.end());
  const System ours = ex0_2::assemble(mesh.n_nodes(), parts, held);
  const signorini::LinearSystem theirs =
      signorini::assemble(mesh, signorini::q4(), material, unknowns, {});
  REQUIRE(ours.stiffness.rows() == theirs.stiffness.rows());
  CHECK(equal_within(Eigen::MatrixXd(ours.stiffness), Eigen::MatrixXd(theirs.stiffness),
                     1e-13 * theirs.stiffness.norm()));
  CHECK(equal_within(ours.load, theirs.load, 1e-13 * theirs.load.norm()));
  CHECK(ours.stiffness.nonZeros() <= theirs.stiffness.nonZeros());  // zeros need no place
}

TEST_CASE("ex0.2 held out: a node that stands twice, as where a quadrilateral becomes a triangle",
          "[ex0.2]") {
  signorini::Random random(4);
  Part part{{0, 1, 1}, Eigen::MatrixXd(6, 6)};
  for (Index i = 0; i < 36; ++i) part.stiffness(i) = random.uniform(-1, 1);
  const Eigen::MatrixXd K = ex0_2::assemble(2, {part}, {}).stiffness;
  Eigen::MatrixXd join = Eigen::MatrixXd::Zero(6, 4);
  join.topLeftCorner(2, 2).setIdentity();
  join.block(2, 2, 2, 2).setIdentity();
  join.block(4, 2, 2, 2).setIdentity();
  CHECK(equal_within(K, join.transpose() * part.stiffness * join, 1e-14));
}

TEST_CASE("ex0.2 held out: all held, no cells, and what does not fit", "[ex0.2]") {
  const Part part{{0, 1}, Eigen::Matrix4d::Identity()};
  CHECK(ex0_2::assemble(2, {part}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}).load.size() == 0);
  CHECK(ex0_2::assemble(3, {}, {{2, 0}}).stiffness.rows() == 5);
  CHECK_THROWS_AS(ex0_2::assemble(1, {part}, {}), std::invalid_argument);
  CHECK_THROWS_AS(ex0_2::assemble(2, {{{0, 1}, Eigen::Matrix3d::Identity()}}, {}),
                  std::invalid_argument);
  CHECK_THROWS_AS(ex0_2::assemble(2, {part}, {{4, 0}}), std::invalid_argument);
}
