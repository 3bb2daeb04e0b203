#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "meshes/hertz_meshes.hpp"
#include "support/mesh_measures.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

/// x of the nodes of a contact boundary, from the axis outwards.
std::vector<double> outwards(const Mesh& mesh, const std::string& name) {
  std::vector<double> x;
  for (const Index node : boundary_nodes(mesh, name)) x.push_back(mesh.nodes(node, 0));
  std::sort(x.begin(), x.end());
  return x;
}

}  // namespace

TEST_CASE("the default meshes of Hertz's problem have at most 1412 nodes, 12 to half a contact",
          "[hertz-mesh]") {
  const HertzMeshes meshes = make_hertz_meshes({});
  CHECK(meshes.disc.n_nodes() + meshes.plate.n_nodes() <= 1412);
  const std::vector<double> rim = outwards(meshes.disc, "rim");
  const std::vector<double> surface = outwards(meshes.plate, "surface");
  CHECK(rim[1] < 1.0800 / 12);
  for (const Mesh* mesh : {&meshes.disc, &meshes.plate}) {
    const MeshQuality quality = check_mesh(*mesh);
    CHECK(quality.smallest_jacobian_ratio > 0.6);
    CHECK(quality.largest_aspect_ratio < 15);
  }
  // Equal cores match.
  for (std::size_t k = 0; k <= 16; ++k)
    CHECK(rim[k] == Approx(surface[k]).epsilon(1e-14).margin(1e-300));
  CHECK(rim.back() == Approx(50).epsilon(1e-15));
  CHECK(surface.back() == 95);
}

TEST_CASE("every number of the specification goes where it belongs", "[hertz-mesh]") {
  HertzMeshSpec spec;
  spec.radius = 10;
  spec.plate = {20, 30};
  spec.core = 0.5;
  spec.plate_core = 1.2;
  spec.disc_cells = 5;
  spec.disc_rows = 4;
  spec.disc_layers = 3;
  spec.plate_cells = 6;
  spec.plate_rows = 7;
  spec.plate_layers = 8;
  spec.layer_grading = 2;
  const HertzMeshes meshes = make_hertz_meshes(spec);
  CHECK(meshes.disc.n_nodes() == 6 * 5 + 10 * 3);
  CHECK(meshes.plate.n_nodes() == 7 * 8 + 14 * 8);
  const std::vector<double> rim = outwards(meshes.disc, "rim");
  const std::vector<double> surface = outwards(meshes.plate, "surface");
  CHECK(rim.size() == 6 + 3);
  CHECK(rim[5] == Approx(0.5).epsilon(1e-14));
  CHECK(rim.back() == Approx(10).epsilon(1e-15));
  CHECK(surface.size() == 7 + 8);
  CHECK(surface[6] == Approx(0.6).epsilon(1e-14));
  CHECK(std::log(20 / surface[13]) / std::log(surface[7] / 0.6) == Approx(2).epsilon(1e-12));
  CHECK(meshes.plate.nodes.col(1).minCoeff() == -30);
  CHECK(boundary(meshes.disc, "axis").size() == 4 + 3);
  CHECK(boundary(meshes.plate, "axis").size() == 7 + 8);
}

TEST_CASE("counts make 72 pairs of good meshes of 1200 to 1412 nodes", "[hertz-mesh]") {
  int pairs = 0;
  for (const double core : {1.3, 1.4, 1.5, 1.6})
    for (const Index plate_cells : {14, 15, 16})  // 16 matches
      for (const Index layers : {14, 15, 16})
        for (const double grading : {1.0, 3.0}) {
          HertzMeshSpec spec;
          spec.core = core;
          spec.plate_cells = plate_cells;
          spec.disc_layers = layers;
          spec.plate_layers = layers + 1;
          spec.layer_grading = grading;
          const HertzMeshes meshes = make_hertz_meshes(spec);
          const Index nodes = meshes.disc.n_nodes() + meshes.plate.n_nodes();
          CAPTURE(core, plate_cells, layers, grading, nodes);
          CHECK(nodes >= 1200);
          CHECK(nodes <= 1412);
          CHECK(check_mesh(meshes.disc).smallest_jacobian_ratio > 0.5);
          CHECK(check_mesh(meshes.plate).smallest_jacobian_ratio > 0.5);
          ++pairs;
        }
  CHECK(pairs == 72);
}

TEST_CASE("quadratic meshes of Hertz's problem match at midpoints too", "[hertz-mesh]") {
  HertzMeshSpec spec;
  spec.order = MeshOrder::Quadratic;
  spec.disc_cells = spec.plate_cells = 8;
  const HertzMeshes meshes = make_hertz_meshes(spec);
  CHECK_NOTHROW(check_mesh(meshes.disc));
  CHECK_NOTHROW(check_mesh(meshes.plate));
  const std::vector<double> rim = outwards(meshes.disc, "rim");
  const std::vector<double> surface = outwards(meshes.plate, "surface");
  for (std::size_t k = 0; k <= 16; ++k)
    CHECK(rim[k] == Approx(surface[k]).epsilon(1e-14).margin(1e-300));
  CHECK(area_of(meshes.plate) == Approx(95 * 95).epsilon(1e-14).margin(0));
}
