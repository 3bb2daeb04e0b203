#include "catch_compat.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/report/field_csv.hpp"

using namespace signorini;

TEST_CASE("a field is a closed polygon per cell where the body has moved to", "[field_csv]") {
  BlockSpec spec;
  spec.size = {2, 1};
  spec.cells_x = 2;
  const Mesh mesh = make_block(spec);
  NodeArray u = NodeArray::Zero(6, 2);
  u(1, 1) = -0.25;  // the node at (1, 0)
  CHECK(deformed_cells_csv(mesh, u, Eigen::Vector2d(7, 8), 2) ==
        "# tolerance rel 1e-4 abs 0.00016\nx,y,value\n"
        "0,0,7\n1,-0.5,7\n1,1,7\n0,1,7\n0,0,7\n\n"
        "1,-0.5,8\n2,0,8\n2,1,8\n1,1,8\n1,-0.5,8\n\n");
}

TEST_CASE("only the corners of a quadratic cell are drawn", "[field_csv]") {
  BlockSpec spec;
  spec.order = MeshOrder::Quadratic;
  const Mesh mesh = make_block(spec);
  CHECK(deformed_cells_csv(mesh, NodeArray::Zero(8, 2), Eigen::VectorXd::Constant(1, 0.5)) ==
        "# tolerance rel 1e-4 abs 2e-05\nx,y,value\n"
        "0,0,0.5\n1,0,0.5\n1,1,0.5\n0,1,0.5\n0,0,0.5\n\n");
}

TEST_CASE("a band is the part of a cell between two levels", "[field_csv]") {
  BlockSpec spec;
  spec.size = {4, 1};
  const Mesh mesh = make_block(spec);  // nodes (0, 0), (4, 0), (0, 1), (4, 1)
  const Eigen::Vector3d levels(0, 1, 2);
  const Eigen::Vector4d rising(0, 4, 0,
                               4);  // the level 1 at x = 1; the second band has what is above 2
  CHECK(deformed_bands_csv(mesh, NodeArray::Zero(4, 2), rising, levels) ==
        "# tolerance rel 1e-4 abs 8e-05\nx,y,value\n"
        "0,0,0.5\n1,0,0.5\n1,1,0.5\n0,1,0.5\n0,0,0.5\n\n"
        "1,0,1.5\n4,0,1.5\n4,1,1.5\n1,1,1.5\n1,0,1.5\n\n");
  NodeArray u = NodeArray::Zero(4, 2);
  u(3, 1) = 1;  // a triangle of the second band, at a place that has moved by half of u
  CHECK(deformed_bands_csv(mesh, u, Eigen::Vector4d(0, 0.5, 0.5, 1.5), levels, 0.5) ==
        "# tolerance rel 1e-4 abs 8e-05\nx,y,value\n"
        "0,0,0.5\n4,0,0.5\n4,0.75,0.5\n2,1.25,0.5\n0,1,0.5\n0,0,0.5\n\n"
        "4,0.75,1.5\n4,1.5,1.5\n2,1.25,1.5\n4,0.75,1.5\n\n");
}

TEST_CASE("rounding of a value on a level changes no band", "[field_csv]") {
  const Mesh mesh = make_block({});
  const Eigen::Vector3d levels(0, 1, 2);
  const Eigen::Vector4d on(0, 1, 0, 1), above = on.array() + 1e-13, below = on.array() - 1e-13;
  const NodeArray u = NodeArray::Zero(4, 2);
  const std::string bands = deformed_bands_csv(mesh, u, on, levels);
  CHECK(deformed_bands_csv(mesh, u, above, levels) == bands);
  CHECK(deformed_bands_csv(mesh, u, below, levels) == bands);
}

TEST_CASE("a field of the wrong size is refused", "[field_csv]") {
  const Mesh mesh = make_block({});
  CHECK_THROWS_AS(deformed_cells_csv(mesh, NodeArray::Zero(3, 2), Eigen::VectorXd::Zero(1)),
                  std::invalid_argument);
  CHECK_THROWS_AS(deformed_cells_csv(mesh, NodeArray::Zero(4, 2), Eigen::VectorXd::Zero(2)),
                  std::invalid_argument);
  CHECK_THROWS_AS(deformed_bands_csv(mesh, NodeArray::Zero(4, 2), Eigen::VectorXd::Zero(1),
                                     Eigen::Vector2d(0, 1)),
                  std::invalid_argument);
  CHECK_THROWS_AS(deformed_bands_csv(mesh, NodeArray::Zero(4, 2), Eigen::VectorXd::Zero(4),
                                     Eigen::VectorXd::Zero(1)),
                  std::invalid_argument);
}
