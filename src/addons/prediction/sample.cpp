#include "addons/prediction/sample.hpp"

#include <algorithm>
#include <map>

#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Some cells of a body as a mesh of their own, without boundaries: the first ones, and among them one that the
/// element is for.
Mesh some_cells(const BodyModel& body) {
  constexpr Index enough = 200;
  const Mesh& mesh = body.mesh;
  Mesh part;
  part.name = mesh.name;
  part.cells = mesh.cells.topRows(std::min(enough, mesh.n_cells()));
  for (Index cell = part.n_cells(); cell < mesh.n_cells(); ++cell)
    if (mesh.cell_size(cell) == body.element.n_nodes) {
      part.cells.row(0) = mesh.cells.row(cell);
      break;
    }
  std::map<Index, Index> number;
  for (Index cell = 0; cell < part.n_cells(); ++cell)
    for (Index k = 0; k < part.cell_size(cell); ++k) {
      Index& node = part.cells(cell, k);
      node = number.try_emplace(node, static_cast<Index>(number.size())).first->second;
    }
  part.nodes.resize(static_cast<Index>(number.size()), 2);
  for (const auto& [from, to] : number) part.nodes.row(to) = mesh.nodes.row(from);
  return part;
}

}  // namespace

Sample sample_of(const Plan& plan, Index stiffness_entries) {
  Sample all;
  Index entries = 0;
  Ledger residuals;
  for (const BodyModel& body : plan.bodies) {
    const Mesh part = some_cells(body);
    QuadraticProgramme programme;
    Ledger assembly;
    {
      const Ledger::Phase phase(assembly, "assembly");
      LinearSystem system =
          assemble(part, body.element, body.material.base, number_unknowns(part, {}), {});
      programme.stiffness.swap(system.stiffness);
      programme.load.swap(system.load);
    }
    const Index n = programme.load.size();
    programme.A.resize(0, n);
    const PrimalDual at{VectorXd::Ones(n), VectorXd::Zero(n), VectorXd()};
    {
      const Ledger::Phase phase(residuals, "residual");
      static_cast<void>(equilibrium_residual(programme, at));
    }
    entries += programme.stiffness.nonZeros();
    all.assembly += assembly.seconds("assembly") * static_cast<double>(body.mesh.n_cells()) /
                    static_cast<double>(part.n_cells());
  }
  all.residual = residuals.seconds("residual") * static_cast<double>(stiffness_entries) /
                 static_cast<double>(entries);
  return all;
}

}  // namespace signorini
