#include "addons/estimate/finer_meshes.hpp"

#include <algorithm>
#include <utility>

#include "addons/estimate/facing_marks.hpp"
#include "addons/estimate/mesh_refinement.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Says of meshes why they cannot be solved, or how many unknowns they have.
void judge(const std::vector<HalvedMesh>& meshes, Index most_unknowns, FinerMeshes& finer) {
  Index unknowns = 0;
  for (const HalvedMesh& halved : meshes) {
    try {
      check_mesh(halved.mesh);
    } catch (const ProblemError& error) {
      finer.obstacle = text(
          "geometry: the sides are too long for the curve they follow, a finer mesh would have bad "
          "cells: ",
          error.what());
      return;
    }
    unknowns += 2 * halved.mesh.n_nodes();
  }
  if (unknowns <= most_unknowns) {
    finer.unknowns = unknowns;
    return;
  }
  finer.too_many = true;
  finer.obstacle = text("budget of unknowns: the next mesh would have about ", unknowns, ", and ",
                        most_unknowns, " are allowed");
}

}  // namespace

bool any_marked(const std::vector<MarkedEdges>& marks) {
  return std::any_of(marks.begin(), marks.end(), [](const MarkedEdges& body) {
    return std::any_of(body.halved.begin(), body.halved.end(),
                       [](char times) { return times > 0; });
  });
}

FinerMeshes finer_meshes(const std::vector<ContactSpec>& contacts, std::vector<BodyModel> bodies,
                         std::vector<MarkedEdges> marks, Index most_unknowns) {
  FinerMeshes finer;
  while (any_marked(marks)) {
    mark_facing(contacts, bodies, marks);
    std::vector<HalvedMesh> halved;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      halved.push_back(halved_once(bodies[b].mesh, marks[b]));
    judge(halved, most_unknowns, finer);
    if (!finer.obstacle.empty()) break;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      bodies[b].mesh = std::move(halved[b].mesh);
      marks[b] = std::move(halved[b].marks);
    }
    ++finer.halvings;
  }
  for (BodyModel& body : bodies) finer.meshes.push_back(std::move(body.mesh));
  return finer;
}

}  // namespace signorini
