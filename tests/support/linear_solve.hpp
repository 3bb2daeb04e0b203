// Plain solution of K u = p for tests without contact.
#pragma once
#include "addons/frontal/frontal_factor.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini_test {

inline signorini::NodeArray solve_body(const signorini::Mesh& mesh,
                                       const signorini::Element& element,
                                       const signorini::MaterialField& material,
                                       const std::vector<signorini::Support>& supports,
                                       const signorini::Loads& loads = {}) {
  const signorini::Unknowns unknowns =
      signorini::number_unknowns(mesh, supports, material.base.state);
  const signorini::LinearSystem system =
      signorini::assemble(mesh, element, material, unknowns, loads);
  signorini::Ledger ledger;
  const signorini::FrontalFactor factor(
      system.stiffness,
      signorini::separator_tree(system.stiffness, unknown_positions(mesh, unknowns)), ledger);
  return expand(unknowns, factor.solve(system.load));
}

inline signorini::NodeArray solve_body(const signorini::Mesh& mesh,
                                       const signorini::Element& element,
                                       const signorini::Material& material,
                                       const std::vector<signorini::Support>& supports,
                                       const signorini::Loads& loads = {}) {
  return solve_body(mesh, element, signorini::MaterialField(material), supports, loads);
}

}  // namespace signorini_test
