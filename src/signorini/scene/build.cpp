#include <utility>

#include "signorini/core/bytes.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/notes.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// K of all bodies without loads, one block after another, and p of what their supports move.
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

Model build(const Scene& scene, Ledger& ledger) {
  const auto planned = [&] {
    const Ledger::Phase phase(ledger, "plan");
    return plan(scene);
  };
  return build(planned(), ledger);
}

}  // namespace signorini
