#include "addons/prediction/pattern.hpp"

#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// The systems that a plan falls into, as far as the patterns of K and A tell.
std::vector<SystemParts> systems_of(const Plan& plan, Pattern& known) {
  QuadraticProgramme pattern;
  pattern.stiffness.swap(known.stiffness);
  pattern.A.swap(known.rows);
  pattern.stiffness.coeffs().setOnes();
  pattern.load.setZero(pattern.stiffness.cols());
  std::vector<SystemParts> systems =
      unconnected_systems(pattern, plan.law, mode_shapes(plan.modes));
  if (systems.empty()) systems = {whole_system(pattern, static_cast<Index>(plan.modes.size()))};
  pattern.stiffness.swap(known.stiffness);
  pattern.A.swap(known.rows);
  return systems;
}

}  // namespace

Pattern pattern_of(const Plan& plan) {
  Pattern known;
  std::vector<Eigen::SparseMatrix<double>> blocks;
  for (const BodyModel& body : plan.bodies)
    blocks.push_back(stiffness_pattern(body.mesh, body.unknowns));
  put_along_diagonal(plan.bodies, blocks, known.stiffness);
  known.rows = contact_rows(plan.gaps, plan.law);
  known.systems = systems_of(plan, known);
  Ledger taken;
  SeparatorTree tree;
  {
    const Ledger::Phase phase(taken, "ordering");
    tree = separator_tree(known.stiffness, unknown_positions(plan.bodies));
  }
  {
    const Ledger::Phase phase(taken, "analysis");
    known.fronts = fronts_of(known.stiffness, tree);
  }
  known.ordering = taken.seconds("ordering");
  known.analysis = taken.seconds("analysis");
  known.paths = row_paths(known.fronts, known.rows);
  return known;
}

}  // namespace signorini
