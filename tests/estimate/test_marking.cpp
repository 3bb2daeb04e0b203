// Which edges are halved for a smaller error.
#include <algorithm>

#include "addons/estimate/facing_marks.hpp"
#include "addons/estimate/mesh_refinement.hpp"
#include "catch_compat.hpp"
#include "meshes/disc.hpp"
#include "meshes/ring.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

/// An estimate that blames one cell of the only body.
Estimate blaming(const Model& model, Index cell, double first_direction) {
  Estimate estimate;
  const Index cells = model.bodies[0].mesh.n_cells();
  estimate.share = {Eigen::VectorXd::Zero(cells)};
  estimate.share[0](cell) = -1;
  estimate.parts.interior = -1;
  estimate.first_direction = {Eigen::VectorXd::Constant(cells, first_direction)};
  return estimate;
}

Index marked(const MarkedEdges& marks) {
  return std::count_if(marks.halved.begin(), marks.halved.end(), [](char m) { return m != 0; });
}

}  // namespace

TEST_CASE("the chord across the blamed cell is halved, in the direction that is too coarse",
          "[accuracy]") {
  const SolvedScene run = solved(cantilever("q4", 10, 3), "cantilever");
  const auto along = mark_elements(run.model, run.solution, blaming(run.model, 14, 1), 0.3, 1);
  CHECK(marked(along[0]) == 4);  // up through three rows
  CHECK(along[0].halved[static_cast<std::size_t>(along[0].edges.at({14, 0}))] == 1);
  const auto often = mark_elements(run.model, run.solution, blaming(run.model, 14, 1), 0.05, 1);
  CHECK(often[0].halved[static_cast<std::size_t>(often[0].edges.at({14, 0}))] == 3);  // 1/64 left
  CHECK(marked(often[0]) == 4);
  const auto across = mark_elements(run.model, run.solution, blaming(run.model, 14, 0), 0.3, 1);
  CHECK(marked(across[0]) == 11);
  CHECK(across[0].halved[static_cast<std::size_t>(across[0].edges.at({14, 1}))] == 1);
  // A part falls to the dearer direction: it stays as long as enough is lost without it.
  const auto most = mark_elements(run.model, run.solution, blaming(run.model, 14, 0.9), 0.5, 1);
  CHECK(marked(most[0]) == 4);
  const auto both = mark_elements(run.model, run.solution, blaming(run.model, 14, 0.5), 0.3, 1);
  CHECK(marked(both[0]) == 15);
}

TEST_CASE("a contact that closes few pairs is refined there and nowhere else", "[accuracy]") {
  const SolvedScene run = solved(cantilever("q4", 10, 2), "cantilever");
  const std::size_t closed = run.solution.contact.active().size();
  REQUIRE(closed > 0);
  CHECK(marks_where_coarse(run.model, run.solution, closed).empty());
  const auto marks = marks_where_coarse(run.model, run.solution, closed + 1);
  REQUIRE(marks.size() == 1);
  const std::vector<CellSide>& bottom = boundary(run.model.bodies[0].mesh, "bottom");
  const auto is_marked = [&](std::size_t side) {
    return marks[0].halved[static_cast<std::size_t>(marks[0].edges.at(bottom[side]))] != 0;
  };
  CHECK(is_marked(bottom.size() - 1));  // at the tip
  CHECK_FALSE(is_marked(0));            // at the clamp
}

TEST_CASE("curved sides that touch are refined together, straight ones are not", "[accuracy]") {
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t b = 0; b < 2; ++b) {
    AnnulusSpec spec;
    spec.name = b == 0 ? "shaft" : "hub";
    spec.inner_radius = b == 0 ? 1 : 2;
    spec.outer_radius = b == 0 ? 2 : 3;
    spec.cells_angle = 6;
    spec.cells_radius = 2;
    spec.sector = Sector::Quarter;
    scene.bodies[b].mesh = make_annulus(spec);
    scene.bodies[b].material = {1000, 0.3, PlaneState::Strain, 1};
    scene.bodies[b].supports = {symmetric("symmetry"), symmetric("symmetry_y")};
  }
  scene.contacts = {{{"outer", "shaft"}, Side{"inner", "hub"}}};
  const Plan planned = plan(scene);
  const auto mark_one = [&](std::size_t body, const char* name) {
    std::vector<MarkedEdges> marks;
    for (const BodyModel& own : planned.bodies) {
      const MeshEdges all = edges(own.mesh);
      marks.push_back({all, std::vector<char>(all.size(), 0)});
    }
    const CellSide side = boundary(scene.bodies[body].mesh, name)[1];
    marks[body].halved[static_cast<std::size_t>(marks[body].edges.at(side))] = 1;
    mark_facing(scene.contacts, planned.bodies, marks);
    return marks;
  };
  for (const auto& marks : {mark_one(0, "outer"), mark_one(1, "inner")}) {
    CHECK(marked(marks[0]) == 3);  // one chord from rim to rim, in both
    CHECK(marked(marks[1]) == 3);
  }
  const auto radial = mark_one(0, "symmetry");  // a chord along the rims faces nothing
  CHECK(marked(radial[0]) == 7);
  CHECK(marked(radial[1]) == 0);
}
