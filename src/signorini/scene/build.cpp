#include <utility>

#include "signorini/scene/bodies.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// K and p of all bodies, one block after another.
LinearSystem assemble_all(const Scene& scene, const std::vector<BodyModel>& bodies, Index count) {
  LinearSystem all;
  all.stiffness.resize(count, count);
  all.load.resize(count);
  Eigen::VectorXi lengths(count);
  std::vector<LinearSystem> systems;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyModel& body = bodies[b];
    systems.push_back(
        assemble(body.mesh, body.element, body.material, body.unknowns, scene.bodies[b].loads));
    all.load.segment(body.first_unknown, body.unknowns.count) = systems.back().load;
    for (Index k = 0; k < body.unknowns.count; ++k)
      lengths(body.first_unknown + k) =
          static_cast<int>(systems.back().stiffness.innerVector(k).nonZeros());
  }
  if (bodies.size() == 1) return std::move(systems.front());
  all.stiffness.reserve(lengths);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (Index k = 0; k < bodies[b].unknowns.count; ++k)
      for (Eigen::SparseMatrix<double>::InnerIterator it(systems[b].stiffness, k); it; ++it)
        all.stiffness.insert(bodies[b].first_unknown + it.row(), bodies[b].first_unknown + k) =
            it.value();
  all.stiffness.makeCompressed();
  return all;
}

}  // namespace

Model build(const Scene& scene, Ledger& ledger) {
  Plan now = [&] {
    const Ledger::Phase phase(ledger, "plan");
    return plan(scene);
  }();
  const Ledger::Phase phase(ledger, "assembly");
  Model model;
  model.unknowns = joined(now.unknowns);
  const std::vector<Index> first = first_unknowns(now.unknowns);
  Index first_node = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    model.bodies.push_back({body.mesh, find_element(body.element), body.material,
                            std::move(now.unknowns[b]), first_node, first[b]});
    first_node += body.mesh.n_nodes();
  }
  LinearSystem system = assemble_all(scene, model.bodies, model.unknowns.count);
  ledger.count("unknowns", model.unknowns.count);
  ledger.count("pairs", now.gaps.pairs.initial_gap.size());
  model.programme.initial_gap = now.gaps.pairs.initial_gap;
  if (!now.law.pair.empty()) {
    now.gaps.A = below(now.gaps.A, -now.gaps.T);
    model.programme.initial_gap.conservativeResize(now.gaps.A.rows());
    model.programme.initial_gap.tail(now.gaps.initial_slip.size()) = now.gaps.initial_slip;
  }
  model.law = std::move(now.law);
  model.programme.stiffness.swap(system.stiffness);
  model.programme.load.swap(system.load);
  model.programme.A.swap(now.gaps.A);
  model.pairs = std::move(now.gaps.pairs);
  model.modes = std::move(now.modes);
  model.solver = std::move(now.solver);
  return model;
}

}  // namespace signorini
