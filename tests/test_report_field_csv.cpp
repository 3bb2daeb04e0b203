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

TEST_CASE("a field of the wrong size is refused", "[field_csv]") {
  const Mesh mesh = make_block({});
  CHECK_THROWS_AS(deformed_cells_csv(mesh, NodeArray::Zero(3, 2), Eigen::VectorXd::Zero(1)),
                  std::invalid_argument);
  CHECK_THROWS_AS(deformed_cells_csv(mesh, NodeArray::Zero(4, 2), Eigen::VectorXd::Zero(2)),
                  std::invalid_argument);
}
