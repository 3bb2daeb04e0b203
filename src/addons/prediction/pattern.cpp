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
      unconnected_systems(pattern, plan.law, mode_entries(plan.modes));
  if (systems.empty()) systems = {whole_system(pattern, static_cast<Index>(plan.modes.size()))};
  pattern.stiffness.swap(known.stiffness);
  pattern.A.swap(known.rows);
  return systems;
}

/// What effects make of K and of the rows behind all others, such as equations that are taken into them.
void finish(const Plan& plan, Pattern& known) {
  if (!plan.finish) return;
  Model model{plan, {}, {}};
  model.parts.clear();
  model.programme.stiffness.swap(known.stiffness);
  model.programme.stiffness.coeffs().setOnes();
  model.programme.A.swap(known.rows);
  model.programme.load.setZero(model.programme.stiffness.cols());
  model.programme.initial_gap.setZero(model.programme.A.rows());
  plan.finish(model);
  model.programme.stiffness.swap(known.stiffness);
  model.programme.A.swap(known.rows);
}

}  // namespace

Pattern pattern_of(const Plan& plan) {
  Pattern known;
  std::vector<Eigen::SparseMatrix<double>> blocks;
  for (const BodyModel& body : plan.bodies)
    blocks.push_back(stiffness_pattern(body.mesh, body.unknowns));
  put_along_diagonal(plan.bodies, blocks, known.stiffness);
  known.rows = contact_rows(plan.gaps, plan.law);
  finish(plan, known);
  known.systems = systems_of(plan, known);
  {
    const Ledger::Phase factor(known.taken, "factor");
    const Ledger::Phase ordering(known.taken, "ordering");
    known.order = std::make_shared<const SeparatorTree>(
        separator_tree(known.stiffness, unknown_positions(plan)));
    known.taken.count("orders", 1);
  }
  Ledger fronts;
  {
    const Ledger::Phase phase(fronts, "analysis");
    known.fronts = fronts_of(known.stiffness, *known.order);
  }
  known.analysis = fronts.seconds("analysis");
  known.paths = row_paths(known.fronts, known.rows);
  return known;
}

}  // namespace signorini
