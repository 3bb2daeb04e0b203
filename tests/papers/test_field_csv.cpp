#include <map>
#include <sstream>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "meshes/split.hpp"
#include "papers/field_csv.hpp"
#include "papers/zero_line_csv.hpp"

using namespace signorini;

namespace {

// Area of each band, by the shoelace formula over the closed polygons.
std::map<int, double> areas(const std::string& csv) {
  std::istringstream lines(csv);
  std::map<int, double> sums;
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  CHECK(line == "x,y,band");
  bool first = true;
  double x_before = 0, y_before = 0;
  while (std::getline(lines, line)) {
    double x = 0, y = 0;
    int band = 0;
    const bool blank = std::sscanf(line.c_str(), "%lf,%lf,%d", &x, &y, &band) != 3;
    if (!blank && !first) sums[band] += (x_before * y - x * y_before) / 2;
    first = blank;
    x_before = x;
    y_before = y;
  }
  return sums;
}

}  // namespace

TEST_CASE("a field is a closed polygon per cell where the body has moved to", "[field_csv]") {
  const Mesh mesh = block("block", {0, 0}, {2, 1}, 2, 1);
  NodeArray u = NodeArray::Zero(6, 2);
  u(1, 1) = -0.25;  // the node at (1, 0)
  CHECK(deformed_cells_csv(mesh, u, Eigen::Vector2d(7, 8), 2) ==
        "# tolerance rel 1e-4 abs 0.00016\nx,y,value\n"
        "0,0,7\n1,-0.5,7\n1,1,7\n0,1,7\n0,0,7\n\n"
        "1,-0.5,8\n2,0,8\n2,1,8\n1,1,8\n1,-0.5,8\n\n");
}

TEST_CASE("only the corners of a quadratic cell are drawn", "[field_csv]") {
  const Mesh mesh = block("block", {0, 0}, {1, 1}, 1, 1, MeshOrder::Quadratic);
  CHECK(deformed_cells_csv(mesh, NodeArray::Zero(8, 2), Eigen::VectorXd::Constant(1, 0.5)) ==
        "# tolerance rel 1e-4 abs 2e-05\nx,y,value\n"
        "0,0,0.5\n1,0,0.5\n1,1,0.5\n0,1,0.5\n0,0,0.5\n\n");
}

TEST_CASE("triangles are drawn with three corners, and cut without a point in the middle",
          "[field_csv]") {
  const Mesh mesh = split(make_block({}));  // (0, 0), (1, 0), (1, 1) and (1, 1), (0, 1), (0, 0)
  const NodeArray still = NodeArray::Zero(4, 2);
  CHECK(deformed_cells_csv(mesh, still, Eigen::Vector2d(7, 8)) ==
        "# tolerance rel 1e-4 abs 0.00016\nx,y,value\n"
        "0,0,7\n1,0,7\n1,1,7\n0,0,7\n\n1,1,8\n0,1,8\n0,0,8\n1,1,8\n\n");
  const Eigen::VectorXd x = mesh.nodes.col(0);
  CHECK(areas(deformed_bands_csv(mesh, still, x, {0.25})).at(0) == Approx(0.25).margin(1e-5));
  CHECK(areas(deformed_bands_csv(mesh, still, x, {0.25})).at(1) == Approx(0.75).margin(1e-5));
  CHECK(deformed_zero_line_csv(mesh, still, x.array() - 0.25) ==
        "# tolerance rel 1e-4 abs 2e-05\nx,y\n"
        "0.25,0\n0.25,0.25\n\n0.25,1\n0.25,0.25\n\n");
}

TEST_CASE("the zero line of a linear field is straight and moves with the body", "[field_csv]") {
  const Mesh mesh = block("block", {0, 0}, {4, 1}, 1, 1);
  NodeArray u = NodeArray::Zero(4, 2);
  u.col(1).setConstant(0.5);
  const Eigen::VectorXd value = mesh.nodes.col(0).array() - 1;  // negative at the left quarter
  CHECK(deformed_zero_line_csv(mesh, u, value, 2) ==
        "# tolerance rel 1e-4 abs 8e-05\nx,y\n"
        "1,1\n1,1.25\n\n1,2\n1,1.75\n\n1,1.25\n1,1.75\n\n");
}

TEST_CASE("a field that only touches zero from above has no zero line", "[field_csv]") {
  const Mesh mesh = make_block({});
  CHECK(deformed_zero_line_csv(mesh, NodeArray::Zero(4, 2), Eigen::Vector4d(0, 1, 2, 3)) ==
        "# tolerance rel 1e-4 abs 2e-05\nx,y\n");
  CHECK_THROWS_AS(deformed_zero_line_csv(mesh, NodeArray::Zero(4, 2), Eigen::Vector3d(0, 1, 2)),
                  std::invalid_argument);
}

TEST_CASE("a field of the wrong size is refused", "[field_csv]") {
  const Mesh mesh = make_block({});
  CHECK_THROWS_AS(deformed_cells_csv(mesh, NodeArray::Zero(3, 2), Eigen::VectorXd::Zero(1)),
                  std::invalid_argument);
  CHECK_THROWS_AS(deformed_cells_csv(mesh, NodeArray::Zero(4, 2), Eigen::VectorXd::Zero(2)),
                  std::invalid_argument);
}

// x + 2 y on [0, 2] x [0, 1] is below 1 on a triangle of area 1/4 and above 2.5 on another of 9/16.
TEST_CASE("bands of a linear field have its areas, on any mesh and where the body has moved to",
          "[field_csv]") {
  BlockSpec spec;
  spec.size = {2, 1};
  spec.cells_x = GENERATE(1, 3, 8);
  spec.cells_y = GENERATE(1, 2, 5);
  const Mesh mesh = make_block(spec);
  const Eigen::VectorXd value = mesh.nodes.col(0) + 2 * mesh.nodes.col(1);
  const NodeArray stretched = mesh.nodes;
  const auto area = areas(deformed_bands_csv(mesh, stretched, value, {1, 2.5}, 1));
  CAPTURE(spec.cells_x, spec.cells_y);
  REQUIRE(area.size() == 3);  // four times as large, printed with 5 digits
  CHECK(area.at(0) == Approx(4 * 0.25).epsilon(1e-4));
  CHECK(area.at(2) == Approx(4 * 0.5625).epsilon(1e-4));
  CHECK(area.at(1) == Approx(4 * (2 - 0.25 - 0.5625)).epsilon(1e-4));
}

TEST_CASE("a cell between two levels stays whole, and rounding at a level cuts nothing",
          "[field_csv]") {
  const Mesh mesh = make_block({});
  const Eigen::Vector4d value(1, 1 - 1e-15, 2, 2);
  const std::string whole = "# tolerance rel 1e-4 abs 2e-05\nx,y,band\n0,0,1\n1,0,1\n1,1,1\n";
  CHECK(deformed_bands_csv(mesh, NodeArray::Zero(4, 2), value, {1, 2}) ==
        whole + "0,1,1\n0,0,1\n\n");
}

TEST_CASE("bands of wrong sizes or levels are refused", "[field_csv]") {
  const Mesh mesh = make_block({});
  const NodeArray u = NodeArray::Zero(4, 2);
  CHECK_THROWS_AS(deformed_bands_csv(mesh, u, Eigen::VectorXd::Zero(1), {0}),
                  std::invalid_argument);
  CHECK_THROWS_AS(deformed_bands_csv(mesh, u, Eigen::VectorXd::Zero(4), {1, 1}),
                  std::invalid_argument);
}

TEST_CASE("an arrow ends on the surface and has the length and the way of its pressure",
          "[field_csv]") {
  NodeArray place(2, 2), normal(2, 2);
  place << 10, 0, 8, 6;
  normal << 0, 1, 0.8, 0.6;
  CHECK(pressure_arrows_csv(place, normal, Eigen::Vector2d(3, 5)) ==
        "# tolerance rel 1e-4 abs 0.0002\nx,y,px,py\n10,0,0,3\n8,6,4,3\n");
  CHECK_THROWS_AS(pressure_arrows_csv(place, normal, Eigen::Vector3d(3, 5, 7)),
                  std::invalid_argument);
  CHECK_THROWS_AS(pressure_arrows_csv(place, normal.topRows(1), Eigen::Vector2d(3, 5)),
                  std::invalid_argument);
}
