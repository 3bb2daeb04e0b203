// Gauss points that yield.
#pragma once
#include "interfaces.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/springs.hpp"

namespace ch10 {

/// Pressures of points that let the bodies overlap by alpha h / E* times the pressure.
struct Soft {
  PressureError error;
  double overlap;  ///< the largest, over the depth b^2 / 2 R to which the flattened disc reaches
};

inline Soft soft_points(const Scene& scene, double alpha) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  const Eigen::VectorXd& weight = model.pairs.weight;
  // [soft]
  const double h = HertzMeshSpec().core / static_cast<double>(HertzMeshSpec().disc_cells);
  const double yielding = alpha * h / hertz_contact.modulus;  // overlap per pressure
  ContactProblem soft = condensed.problem;
  soft.compliance.diagonal() += yielding * weight.cwiseInverse();
  const ContactState state = solve(soft, find_solver(scene.solver));
  // [soft]
  if (state.report.status != Status::Solved) throw NotSolved(text("alpha = ", alpha));
  const Eigen::VectorXd p = state.force.cwiseQuotient(weight);
  const double b = hertz_half_width(hertz_contact);
  return {against_hertz(model.pairs.position, weight, p),
          yielding * p.maxCoeff() * 2 * hertz_contact.radius / (b * b)};
}

}  // namespace ch10
