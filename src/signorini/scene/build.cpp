#include <utility>

#include "signorini/scene/bodies.hpp"
#include "signorini/scene/doubts.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// K of all bodies without loads, one block after another, and p of what their supports move.
LinearSystem assemble_all(const std::vector<BodyModel>& bodies, Index count) {
  const auto assembled = [](const BodyModel& body) {
    return assemble(body.mesh, body.element, body.material, body.unknowns, {});
  };
  if (bodies.size() == 1) return assembled(bodies.front());
  LinearSystem all{Eigen::SparseMatrix<double>(count, count), Eigen::VectorXd(count)};
  for (const BodyModel& body : bodies) {
    const LinearSystem own = assembled(body);
    const Index first = body.first_unknown;
    all.load.segment(first, body.unknowns.count) = own.load;
    all.stiffness.reserve(all.stiffness.nonZeros() + own.stiffness.nonZeros());
    for (Index k = 0; k < body.unknowns.count; ++k) {
      all.stiffness.startVec(first + k);
      for (Eigen::SparseMatrix<double>::InnerIterator it(own.stiffness, k); it; ++it)
        all.stiffness.insertBack(first + it.row(), first + k) = it.value();
    }
  }
  all.stiffness.finalize();
  return all;
}

}  // namespace

Model build(Plan plan, Ledger& ledger) {
  const Ledger::Phase phase(ledger, "assembly");
  Model model;
  LinearSystem system =
      telling(plan.notes, [&] { return assemble_all(plan.bodies, plan.unknowns.count); });
  model.programme.stiffness.swap(system.stiffness);
  model.programme.load.swap(system.load);
  model.programme.A.resize(0, plan.unknowns.count);
  model.pairs.opening.resize(0, 2 * count_nodes(plan.bodies));
  model.bodies = std::move(plan.bodies);
  model.unknowns = std::move(plan.unknowns);
  model.solver = std::move(plan.solver);
  model.notes = std::move(plan.notes);
  telling(model.notes, [&] {
    for (const Effect* effect : plan.effects) effect->add(plan, model);
  });
  ledger.count("unknowns", model.unknowns.count);
  ledger.count("pairs", model.pairs.weight.size());
  return model;
}

Model build(const Scene& scene, Ledger& ledger) {
  Plan planned = [&] {
    const Ledger::Phase phase(ledger, "plan");
    return plan(scene);
  }();
  return build(std::move(planned), ledger);
}

}  // namespace signorini
