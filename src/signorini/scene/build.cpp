// # From plan to model
//
// The plan knows what the scene calls for. Here it gets its numbers, the four of the
// programme
// \f[ \min_u\; \tfrac12 u^T K u - p^T u \quad\text{subject to}\quad Au \le g. \f]
// K and p come from cells and supports. Each effect then adds its own part: loads to p,
// springs to K, contact A and g, friction more rows.
//
// The smallest example with two bodies has one unknown each, stiffness 2 and 3, and a gap of
// 1 between them that closes when the first moves towards the second:
// \f[ K = \begin{pmatrix} 2 & 0 \\ 0 & 3 \end{pmatrix}, \quad p = \binom{6}{0}, \f]
// with \f$ A = (1, -1) \f$ and \f$ g = 1 \f$. Without contact \f$ u = (3, 0) \f$ overlaps by
// 2. The force 2.4 closes the gap: u = (1.8, 0.8).

#include <utility>

#include "signorini/core/bytes.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/notes.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// K of all bodies without loads, one block after another, and p of what their supports move.
// Given displacements are no effect: K has no columns for them, and what these columns would
// do is a load.
LinearSystem assemble_all(const std::vector<BodyModel>& bodies, Index count) {
  LinearSystem all{{}, Eigen::VectorXd(count)};
  std::vector<Eigen::SparseMatrix<double>> blocks(bodies.size());
  auto block = blocks.begin();
  for (const BodyModel& body : bodies) {
    LinearSystem own = assemble(body.mesh, body.element, body.material, body.unknowns, {});
    all.load.segment(body.first_unknown, body.unknowns.count) = own.load;
    (block++)->swap(own.stiffness);  // Eigen's matrices would be copied by a move
  }
  put_along_diagonal(bodies, blocks, all.stiffness);
  return all;
}

}  // namespace

// The plan is moved into the model, because meshes are large. Nothing here asks what the
// scene calls for: the list of effects says it. Without contact A has no rows, and later
// steps need no branch for that.
Model build(Plan plan, Ledger& ledger) {
  const Ledger::Phase phase(ledger, "assembly");
  Model model{std::move(plan), {}, {}};
  LinearSystem system =
      with_context(model.notes, [&] { return assemble_all(model.bodies, model.unknowns.count); });
  model.programme.stiffness.swap(system.stiffness);
  model.programme.load.swap(system.load);
  model.programme.A.resize(0, model.unknowns.count);
  model.pairs.opening.resize(0, 2 * count_nodes(model.bodies));
  with_context(model.notes, [&] {
    for (const Effect* effect : model.effects)
      if (effect->add != nullptr) effect->add(model);
    if (model.finish) model.finish(model);
  });
  model.gaps = {};
  const QuadraticProgramme& programme = model.programme;
  ledger.count("unknowns", model.unknowns.count);
  ledger.count("pairs", model.pairs.weight.size());
  ledger.count("rows", programme.A.rows());
  ledger.count("stiffness entries", programme.stiffness.nonZeros());
  ledger.bytes(bytes_of(programme.stiffness) + bytes_of(programme.A));
  return model;
}

// The ledger times planning and assembly apart. The phase of the plan must have ended when
// that of the assembly begins.
Model build(const Scene& scene, Ledger& ledger) {
  const auto planned = [&] {
    const Ledger::Phase phase(ledger, "plan");
    return plan(scene);
  };
  return build(planned(), ledger);
}

}  // namespace signorini
