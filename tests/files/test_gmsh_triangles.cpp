// Files of Gmsh with triangles, alone and beside quadrilaterals, and surfaces that are parts of one body.
#include <cmath>

#include "addons/files/gmsh.hpp"
#include "catch_compat.hpp"
#include "fuzz/check_gmsh.hpp"
#include "signorini/core/rounding.hpp"
#include "support/folder.hpp"
#include "support/mesh_measures.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Index;
using signorini_test::area_by_rim;
using signorini_test::area_of;
using signorini_test::content_of;
using signorini_test::is_rim;
using signorini_test::problem_message;

namespace {

std::string file(const std::string& name) {
  return std::string(SIGNORINI_TEST_DATA "/gmsh/") + name + ".msh";
}

/// The positions of Gmsh are rounded to 1e-11.
constexpr double gmsh_rounding = 1e-10;

}  // namespace

TEST_CASE("a body of triangles and quadrilaterals, and one of triangles", "[mesh][gmsh]") {
  const std::string name = GENERATE("linear_v41", "quadratic_v22", "quadratic_v41");
  CAPTURE(name);
  const bool linear = name[0] == 'l';
  const std::vector<Mesh> bodies = read_gmsh(file("mixed_" + name));
  REQUIRE(bodies.size() == 2);
  const Mesh& plate = mesh_named(bodies, "plate");
  const Mesh& arch = mesh_named(bodies, "arch");
  CHECK(plate.cells.cols() == (linear ? 4 : 8));
  CHECK(arch.cells.cols() == (linear ? 3 : 6));
  Index quadrilaterals = 0;
  for (Index cell = 0; cell < plate.n_cells(); ++cell) quadrilaterals += plate.corners(cell) - 3;
  CHECK(quadrilaterals == 4);
  CHECK(plate.n_cells() == 4 + 14);
  for (const Mesh& mesh : bodies) CHECK_NOTHROW(check_mesh(mesh));
  CHECK(area_of(plate) == Approx(2).margin(gmsh_rounding));
  // Four chords, or parabolas through their ends and the points of the circle between them.
  const double angle = pi / 4;
  const double chords = 2 * std::sin(angle);
  const double bend = 1 - std::cos(angle / 2);
  const double parabolas = chords + 4 * 2.0 / 3 * (2 * std::sin(angle / 2)) * bend;
  CHECK(area_of(arch) == Approx(linear ? chords : parabolas).margin(gmsh_rounding));
  CHECK(is_rim(arch, {"shared", "round"}));
  CHECK(boundary(plate, "base").size() == 4);
  CHECK(boundary(plate, "shared").size() == 4);
  std::vector<Index> of_plate = boundary_nodes(plate, "shared");
  const std::vector<Index> of_arch = boundary_nodes(arch, "shared");
  REQUIRE(of_plate.size() == of_arch.size());
  std::reverse(of_plate.begin(), of_plate.end());
  for (std::size_t k = 0; k < of_arch.size(); ++k)
    CHECK(plate.nodes.row(of_plate[k]) == arch.nodes.row(of_arch[k]));
}

TEST_CASE("a triangle that runs clockwise is turned, with its midpoints", "[mesh][gmsh]") {
  for (const bool clockwise : {false, true}) {
    const std::string nodes = clockwise ? "1 3 2 6 5 4" : "1 2 3 4 5 6";
    const std::vector<Mesh> read = parse_gmsh(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 1 0 0\n"
        "5 1.1 1.2 0\n6 0 1 0\n$EndNodes\n$Elements\n2\n1 9 2 1 1 " +
            nodes + "\n2 8 2 3 1 3 2 5\n$EndElements\n",
        "file");
    const Mesh& mesh = read.front();
    CHECK_NOTHROW(check_mesh(mesh));
    CHECK(area_of(mesh) == Approx(2 + 2.0 / 3 * 2 * 0.3).epsilon(1e-14));
    const std::vector<Index> slope = boundary_nodes(mesh, "curve 3");
    REQUIRE(slope.size() == 3);
    CHECK(mesh.nodes.row(slope[1]) == Eigen::RowVector2d(1.1, 1.2));
  }
}

TEST_CASE("surfaces become parts of one body, which share their nodes", "[mesh][gmsh]") {
  const std::string name = GENERATE("linear_v41", "quadratic_v41");
  const std::vector<Mesh> apart = read_gmsh(file("mixed_" + name));
  const std::vector<Mesh> one = read_gmsh(file("mixed_" + name), {{"bridge", {"plate", "arch"}}});
  REQUIRE(one.size() == 1);
  const Mesh& bridge = one.front();
  CHECK(bridge.name == "bridge");
  CHECK_NOTHROW(check_mesh(bridge));
  const std::size_t shared = boundary_nodes(apart[0], "shared").size();
  CHECK(bridge.n_nodes() == apart[0].n_nodes() + apart[1].n_nodes() - static_cast<Index>(shared));
  CHECK(area_by_rim(bridge) == Approx(area_by_rim(apart[0]) + area_by_rim(apart[1])));
  REQUIRE(bridge.regions.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<Index>& cells = bridge.regions.at(apart[k].name);
    REQUIRE(static_cast<Index>(cells.size()) == apart[k].n_cells());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const Index cell = static_cast<Index>(c);
      for (Index j = 0; j < apart[k].cell_size(cell); ++j)
        CHECK(bridge.nodes.row(bridge.cells(cells[c], j)) ==
              apart[k].nodes.row(apart[k].cells(cell, j)));
    }
  }
  CHECK(bridge.boundaries.count("shared") == 0);
  CHECK(boundary(bridge, "round").size() == 4);
  const auto complaint = [&](const GmshParts& parts) {
    return problem_message(
        [&] { static_cast<void>(parse_gmsh(content_of(file("mixed_" + name)), "file", parts)); });
  };
  CHECK(complaint({{"bridge", {"plate", "roof"}}}) ==
        "file:1: there is no physical surface 'roof' for the body 'bridge'; there are: "
        "'arch', 'plate'");
  CHECK_THAT(complaint({{"a", {"plate"}}, {"b", {"plate"}}}),
             ContainsSubstring("is to be part of 'a' and of 'b'; leave it in one"));
  CHECK_THAT(complaint({{"arch", {"plate"}}}), ContainsSubstring("are both named 'arch'"));
}
