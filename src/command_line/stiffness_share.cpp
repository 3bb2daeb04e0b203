#include "command_line/stiffness_share.hpp"

#include "addons/effects/springs.hpp"
#include "signorini/core/errors.hpp"

namespace command_line {

using namespace signorini;
using Eigen::Index;

namespace {

/// The stiffness of some cells of a body, on all unknowns of the body. K is a sum over cells,
/// so that processes can assemble parts of it. A temperature gives loads and no stiffness: it
/// is left out. If the mesh has both shapes and these cells are all triangles, they are
/// assembled with the element that triangles have beside quadrilaterals. Otherwise the sum
/// would not be the K of the whole mesh.
Eigen::SparseMatrix<double> stiffness_of_cells(const BodyModel& body, Index first, Index count) {
  if (count == 0) return {body.unknowns.count, body.unknowns.count};
  Mesh part = body.mesh;
  part.cells = body.mesh.cells.middleRows(first, count).eval();
  MaterialField material = body.material;
  material.eigenstrain = {};
  if (const auto begin = material.number_of.begin() + first; !material.number_of.empty())
    material.number_of = {begin, begin + count};
  bool triangles = true;  // beside the quadrilaterals of other shares
  for (Index cell = 0; cell < count; ++cell) triangles = triangles && part.corners(cell) == 3;
  const bool beside = triangles && body.element.corners() != 3;
  Eigen::SparseMatrix<double> K;
  assemble(part, beside ? triangle_beside(part) : body.element, material, body.unknowns, {})
      .stiffness.swap(K);  // a move would copy it
  return K;
}

}  // namespace

/// Cells are dealt out by integer division: of 10 cells, 3 processes get 3, 3 and 4. No cell
/// is lost and none comes twice. Springs are no cells. The first process alone adds them, or
/// they would count once per process.
Eigen::SparseMatrix<double> stiffness_share(const std::vector<BodyModel>& bodies, int part,
                                            int parts) {
  require_argument(part >= 0 && part < parts, "stiffness_share: expected a share from 0 to ",
                   parts - 1, ", got ", part);
  std::vector<Eigen::SparseMatrix<double>> blocks;
  for (const BodyModel& body : bodies) {
    const Index first = body.mesh.n_cells() * part / parts;
    const Index end = body.mesh.n_cells() * (part + 1) / parts;
    blocks.push_back(stiffness_of_cells(body, first, end - first));
  }
  QuadraticProgramme share;
  put_along_diagonal(bodies, blocks, share.stiffness);
  share.load = Eigen::VectorXd::Zero(count_unknowns(bodies));
  if (part == 0)
    for (const BodyModel& body : bodies) add_springs(body, share);
  share.stiffness.makeCompressed();
  Eigen::SparseMatrix<double> K;
  share.stiffness.swap(K);
  return K;
}

Eigen::SparseMatrix<double> stiffness_share(const Scene& scene, int part, int parts) {
  const Plan draft = plan(scene);
  if (!draft.equations) return stiffness_share(draft.bodies, part, parts);
  if (part > 0) return {draft.unknowns.count, draft.unknowns.count};
  Ledger unread;
  return build(scene, unread).programme.stiffness;
}

}  // namespace command_line
