// Several processes assemble K by parts.
#include "catch_compat.hpp"
#include "command_line/stiffness_share.hpp"
#include "support/effect_examples.hpp"
#include "support/random_scenes.hpp"

using namespace signorini;
using command_line::stiffness_share;
using Eigen::SparseMatrix;

namespace {

/// Whether the shares of any number of processes add up to K, to rounding.
void check_shares(const Scene& scene) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  const SparseMatrix<double>& K = model.programme.stiffness;
  const std::vector<BodyModel> bodies = plan(scene).bodies;
  const bool joined = model.equations != nullptr;
  for (const int parts : {1, 2, 3, 7}) {
    CAPTURE(parts);
    SparseMatrix<double> sum(K.rows(), K.cols());
    SparseMatrix<double> sizes(K.rows(), K.cols());
    for (int part = 0; part < parts; ++part) {
      const SparseMatrix<double> share = stiffness_share(scene, part, parts);
      REQUIRE(share.isCompressed());
      if (parts > 1 && !joined && bodies.front().mesh.n_cells() >= parts)
        CHECK(share.nonZeros() < K.nonZeros());
      sum += share;
      sizes += share.cwiseAbs();
    }
    CHECK((sum - K).norm() <= 1e-15 * sizes.norm());
  }
}

}  // namespace

TEST_CASE("the shares of K add up to K, whatever the scene calls for", "[scene][shares]") {
  for (const auto& [name, example] : signorini_test::effect_examples()) {
    CAPTURE(name);
    check_shares(example.with);
  }
}

TEST_CASE("a share may have the triangles of a mixed mesh alone", "[scene][shares]") {
  Scene scene = signorini_test::plain_beam();
  Mesh& mesh = scene.bodies.front().mesh;
  const Eigen::Index cells = mesh.n_cells();
  Eigen::Index triangles = 0;
  mesh.cells.conservativeResize(cells + 2, Eigen::NoChange);
  for (const Eigen::Index cell : {cells - 1, cells - 2}) {  // cut in two, at the end
    const auto corners = mesh.cells.row(cell).head(4).eval();
    mesh.cells.row(cell).setConstant(-1);
    mesh.cells.row(cell).head(3) << corners(0), corners(1), corners(2);
    mesh.cells.row(cells + triangles).setConstant(-1);
    mesh.cells.row(cells + triangles++).head(3) << corners(0), corners(2), corners(3);
  }
  scene.contacts.clear();
  mesh.boundaries.erase("right");
  mesh.boundaries.erase("top");
  for (BodyModel& body : plan(scene).bodies) {
    const Eigen::Index all = body.mesh.n_cells();
    REQUIRE(body.mesh.corners(all - 1) == 3);
    const SparseMatrix<double> share =
        stiffness_share({body}, static_cast<int>(all) - 1, static_cast<int>(all));
    CHECK(share.nonZeros() > 0);
  }
  check_shares(scene);
}
