// Files of Gmsh: what becomes of physical groups, in both versions and both orders, and by hand.
#include <vector>

#include "addons/files/gmsh.hpp"
#include "addons/files/gmsh_boundaries.hpp"
#include "catch_compat.hpp"
#include "fuzz/check_gmsh.hpp"
#include "support/folder.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Index;
using signorini_test::area_by_rim;
using signorini_test::problem_message;

namespace {

std::string file(const std::string& name) {
  return std::string(SIGNORINI_TEST_DATA "/gmsh/") + name + ".msh";
}

std::vector<std::string> boundary_names(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const auto& [name, sides] : mesh.boundaries) names.push_back(name);
  return names;
}

/// Positions of the nodes of a boundary, one after the other in a row of text.
std::string walk(const Mesh& mesh, const std::string& name) {
  std::string result;
  for (const Index node : boundary_nodes(mesh, name))
    result += text("(", mesh.nodes(node, 0), ",", mesh.nodes(node, 1), ")");
  return result;
}

/// The positions of Gmsh are rounded to 1e-11; what is counted and compared here is not.
constexpr double gmsh_rounding = 1e-10;

}  // namespace

TEST_CASE("physical surfaces become bodies, the curve between them a boundary of both",
          "[mesh][gmsh]") {
  const std::string name = GENERATE("q4_v22", "q4_v41", "q8_v22", "q8_v41");
  CAPTURE(name);
  const bool linear = name[1] == '4';
  const std::vector<Mesh> bodies = read_gmsh(file("two_bodies_" + name));
  REQUIRE(bodies.size() == 2);
  const Mesh& lower = mesh_named(bodies, "lower plate");
  const Mesh& upper = mesh_named(bodies, "upper");
  CHECK(&lower == bodies.data());  // in the order of the tags 1 and 7
  CHECK(boundary_names(lower) == std::vector<std::string>{"outer", "shared"});
  CHECK(boundary_names(upper) == std::vector<std::string>{"outer", "shared", "top"});
  for (const Mesh& mesh : bodies) {
    CHECK(mesh.n_cells() == 2);
    CHECK(mesh.n_nodes() == (linear ? 6 : 13));
    CHECK(mesh.cells.cols() == (linear ? 4 : 8));
    CHECK(check_mesh(mesh).smallest_jacobian_ratio == Approx(1).margin(gmsh_rounding));
    CHECK(area_by_rim(mesh) == Approx(2).margin(gmsh_rounding));
    CHECK(boundary(mesh, "shared").size() == 2);
    CHECK(boundary(mesh, "outer").size() == 4);
  }
  // The body is to the left, so the two walk against each other. Gmsh has the curve against lower.
  const std::vector<Index> of_lower = boundary_nodes(lower, "shared");
  const std::vector<Index> of_upper = boundary_nodes(upper, "shared");
  REQUIRE(of_lower.size() == (linear ? 3u : 5u));
  REQUIRE(of_upper.size() == of_lower.size());
  for (std::size_t k = 0; k < of_lower.size(); ++k) {
    const Index facing = of_upper[of_lower.size() - 1 - k];
    CHECK(lower.nodes.row(of_lower[k]) == upper.nodes.row(facing));  // the same bits
    const double x = 2 - 2 * static_cast<double>(k) / static_cast<double>(of_lower.size() - 1);
    CHECK(lower.nodes(of_lower[k], 0) == Approx(x).margin(gmsh_rounding));
    CHECK(lower.nodes(of_lower[k], 1) == 1);
  }
}

TEST_CASE("both versions of the format give the same meshes", "[mesh][gmsh]") {
  const std::string order = GENERATE("q4", "q8");
  const std::vector<Mesh> a = read_gmsh(file("two_bodies_" + order + "_v22"));
  const std::vector<Mesh> b = read_gmsh(file("two_bodies_" + order + "_v41"));
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(a[k].name == b[k].name);
    CHECK(a[k].nodes == b[k].nodes);
    CHECK(a[k].cells == b[k].cells);
    for (const std::string& name : boundary_names(a[k]))
      CHECK(walk(a[k], name) == walk(b[k], name));
  }
}

TEST_CASE("a cell that runs clockwise is turned, lines are chained, tags may have holes",
          "[mesh][gmsh]") {
  const std::vector<Mesh> bodies = read_gmsh(file("by_hand_v22"));
  REQUIRE(bodies.size() == 1);
  const Mesh& plate = bodies.front();
  CHECK(plate.name == "plate");
  CHECK(plate.n_nodes() == 6);  // without those that belong to no cell
  CHECK(check_mesh(plate).smallest_jacobian_ratio == 1);
  CHECK(area_by_rim(plate) == 2);
  CHECK(boundary_names(plate) == std::vector<std::string>{"all round # 1", "bottom"});
  CHECK(walk(plate, "bottom") == "(0,0)(1,0)(2,0)");
  CHECK(walk(plate, "all round # 1") == "(2,0)(2,1)(1,1)(0,1)(0,0)(1,0)");
}

TEST_CASE("without physical surfaces one body, groups without a name get one", "[mesh][gmsh]") {
  const std::vector<Mesh> bodies = read_gmsh(file("by_hand_q8_v41"));
  REQUIRE(bodies.size() == 1);
  const Mesh& body = bodies.front();
  CHECK(body.name == "body");
  check_mesh(body);
  CHECK(boundary_names(body) == std::vector<std::string>{"curve 4", "curve 6"});
  CHECK(walk(body, "curve 6") == "(1,0)(1,0.5)(1,1)(0.5,1.25)(0,1)");
  CHECK(walk(body, "curve 4") ==
        "(0,0)(0.5,0)(1,0)"
        "(1,0.5)(1,1)(0.5,1.25)(0,1)");
}

TEST_CASE("midpoints are turned with their cell", "[mesh][gmsh]") {
  std::string content = signorini_test::content_of(file("by_hand_q8_v41"));
  const std::string forward = "4 11 12 13 14 15 16 17 18";
  content.replace(content.find(forward), forward.size(), "4 12 11 14 13 15 18 17 16");
  const std::vector<Mesh> turned = parse_gmsh(content, "file");
  check_mesh(turned.front());
  CHECK(area_by_rim(turned.front()) == 1);
  CHECK(walk(turned.front(), "curve 6") == "(1,0)(1,0.5)(1,1)(0.5,1.25)(0,1)");
}

TEST_CASE("line ends of Windows and a byte order mark change nothing", "[mesh][gmsh]") {
  const std::string content = signorini_test::content_of(file("two_bodies_q4_v41"));
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : content) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::vector<Mesh> plain = parse_gmsh(content, "file");
  const std::vector<Mesh> other = parse_gmsh(windows, "file");
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(plain[k].nodes == other[k].nodes);
    CHECK(plain[k].cells == other[k].cells);
    CHECK(boundary_names(plain[k]) == boundary_names(other[k]));
  }
}

TEST_CASE("sides are chained piece after piece, open ones first", "[mesh][gmsh]") {
  Mesh mesh;  // five cells in a row, corners along the bottom 0 to 5, along the top 6 to 11
  mesh.cells.resize(5, 4);
  for (int k = 0; k < 5; ++k) mesh.cells.row(k) << k, k + 1, k + 7, k + 6;
  const auto chain = [&](const std::vector<CellSide>& sides) {
    std::string result;
    for (const CellSide& side : chained(mesh, sides)) result += text(side.cell, side.side, ' ');
    return result;
  };
  CHECK(chain({}).empty());
  CHECK(chain({{1, 0}, {0, 0}, {4, 0}, {3, 0}}) == "00 10 30 40 ");
  CHECK(chain({{4, 0}, {3, 0}, {1, 0}, {0, 0}}) == "30 40 00 10 ");
  CHECK(chain({{2, 3}, {2, 2}, {2, 1}, {2, 0}, {0, 0}}) == "00 23 20 21 22 ");
  CHECK(chain({{0, 3}, {0, 0}, {0, 1}, {0, 2}}) == "03 00 01 02 ");
}

TEST_CASE("a mesh is looked up by its name", "[mesh][gmsh]") {
  const std::vector<Mesh> bodies = read_gmsh(file("two_bodies_q4_v22"));
  CHECK(problem_message([&] { static_cast<void>(mesh_named(bodies, "middle")); }) ==
        "there is no mesh 'middle'; there are: lower plate, upper");
  CHECK(problem_message([&] { static_cast<void>(mesh_named({}, "x")); }) ==
        "there is no mesh 'x'; there are: none");
}
