#include "addons/estimate/estimate.hpp"

#include <cmath>
#include <utility>

#include "addons/estimate/anisotropy.hpp"
#include "addons/estimate/contact_edges.hpp"
#include "addons/estimate/contact_ends.hpp"
#include "addons/estimate/dual.hpp"
#include "addons/estimate/error_products.hpp"
#include "addons/estimate/outline.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Displacements of the nodes of a body, zero where they are held.
NodeArray of_body(const BodyModel& body, const VectorXd& displacement) {
  NodeArray nodes = NodeArray::Zero(body.mesh.n_nodes(), 2);
  for (Index node = 0; node < nodes.rows(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      if (const Index unknown = body.unknowns.number(node, axis); unknown >= 0)
        nodes(node, axis) = displacement(body.first_unknown + unknown);
  return nodes;
}

/// What is left of the equations of a solution, and what that can change goals by.
struct Residuals {
  VectorXd force, gap;

  Residuals(const QuadraticProgramme& programme, const PrimalDual& solution)
      : force(equilibrium_residual(programme, solution)), gap(gaps(programme, solution)) {}
  [[nodiscard]] double change(const DualSolution& dual) const {
    return (dual.displacement + dual.rigid).cwiseAbs().dot(force.cwiseAbs()) +
           dual.force.cwiseAbs().dot(gap.cwiseAbs());
  }
};

}  // namespace

double ErrorParts::sizes() const {
  return std::abs(interior) + std::abs(gap) + std::abs(quadrature_error) + std::abs(free_boundary) +
         std::abs(outline);
}

double ErrorParts::norm() const {
  return Eigen::Vector<double, 5>(interior, gap, quadrature_error, free_boundary, outline)
      .stableNorm();
}

std::vector<Estimate> estimates(const Model& model, const Condensed& condensed,
                                const Solution& solution, const std::vector<Goal>& goals,
                                Ledger& ledger) {
  const Ledger::Phase phase(ledger, "estimate");
  require_input(
      model.path.times.empty(),
      "estimate: the model has load steps, whose errors add up along the path; only that of a "
      "scene solved in one step is "
      "estimated: leave the path out, or compare with a finer mesh");
  const Dual dual(model, condensed, solution);
  for (std::size_t pair = 0; pair < model.pairs.node.size(); ++pair)
    require_input(
        model.pairs.node[pair] >= 0, "estimate: the pairs of ",
        model.contacts[model.contact_of[pair]],
        " are Gauss points with forces of their own, whose error is not estimated; use the gap "
        "operator mortar or node_to_segment");
  const QuadraticProgramme& programme = model.programme;
  const Residuals residuals(programme, solution.refined);
  const std::vector<ContactEdge> edges = contact_edges(model);
  const std::vector<ContactEnd> ends =
      dual.slides() ? std::vector<ContactEnd>() : contact_ends(edges, solution, dual);
  std::vector<Estimate> all;
  std::vector<DualSolution> duals;
  for (const Goal& goal : goals) {
    Estimate one{goal.name, value(model, solution, goal), {}, 0, true, 0, {}, {}, {}};
    one.is_signed = std::holds_alternative<ContactForce>(goal.quantity) ||
                    std::holds_alternative<NormalForce>(goal.quantity) ||
                    std::holds_alternative<Displacement>(goal.quantity);
    const GoalGradient change = gradient(model, solution, goal);
    duals.push_back(dual.solve(change, ledger));
    const DualSolution& z = duals.back();
    one.algebraic = residuals.change(z);
    one.parts.gap = gap_between_nodes(model, edges, z.force);
    one.parts.quadrature_error = quadrature_error(model, solution, goal);
    VectorXd per_force = -(programme.A * (z.displacement + z.rigid));
    if (change.force.size() > 0) per_force += change.force;
    for (const ContactEnd& end : ends)
      one.parts.free_boundary += free_boundary(end, per_force(end.open), z.force(end.closed));
    all.push_back(std::move(one));
  }
  const VectorXd strains = strained(solution.refined);
  for (const BodyModel& body : model.bodies) {
    PrimalAndDuals fields{body.mesh, body.element, body.material, {of_body(body, strains)}};
    fields.displacements[0] += body.unknowns.held;
    for (const DualSolution& z : duals)
      fields.displacements.push_back(of_body(body, z.displacement));
    const SmoothStress smooth = [&] {
      const Ledger::Phase recovery(ledger, "recovery");
      return recovered(fields);
    }();
    const Ledger::Phase weighing(ledger, "weighing");
    const Eigen::MatrixXd products =
        error_products(fields, smooth, away_from_ends(ends, model, body));
    const Eigen::MatrixXd first = anisotropic_indicator(fields, smooth);
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k].share.emplace_back(products.col(static_cast<Index>(k)));
      all[k].first_direction.emplace_back(first.col(static_cast<Index>(k)));
      all[k].parts.interior += all[k].share.back().sum();
      all[k].of_sides.emplace_back();
    }
    const auto b = static_cast<std::size_t>(&body - model.bodies.data());
    const ContactOnNodes contact(model, body);
    std::vector<WholeField> whole = {
        {solution.displacements[b], contact.pressures(solution.contact.force)}};
    for (const DualSolution& z : duals)
      whole.push_back({of_body(body, z.displacement + z.rigid), contact.pressures(z.force)});
    for (const OutlineShare& side : outline_shares(body, smooth, contact, whole, goals))
      for (std::size_t k = 0; k < all.size(); ++k) {
        const double amount = side.amount(static_cast<Index>(k));
        all[k].of_sides.back().push_back({side.side, amount});
        all[k].parts.outline += amount;
      }
  }
  for (Estimate& one : all) one.error = one.is_signed ? one.parts.sum() : one.parts.norm();
  return all;
}

Estimate estimate(const Model& model, const Condensed& condensed, const Solution& solution,
                  const Goal& goal, Ledger& ledger) {
  return std::move(estimates(model, condensed, solution, {goal}, ledger).front());
}

std::vector<BudgetLine> error_budget(const Estimate& estimate, const ComparedWith& compared) {
  const auto difference = [&](const std::optional<double>& other) {
    return other ? std::optional<double>(*other - estimate.value) : std::nullopt;
  };
  const ErrorParts& p = estimate.parts;
  return {
      {"algebraic", estimate.algebraic,
       "what the residuals of the certified solution can do at most"},
      {"gap", p.gap + p.quadrature_error, "between the nodes of the contact: finer sides there"},
      {"element", p.interior + p.free_boundary,
       "stresses inside the bodies and the end of the contact: finer cells, or better ones"},
      {"outline", p.outline,
       "what sides of cells cut off curved outlines, or add: shorter sides, or quadratic cells"},
      {"domain", difference(compared.domain), "where the bodies were cut off: a larger domain"},
      {"model", difference(compared.model),
       "what the scene leaves out, such as large movements or the third dimension"}};
}

}  // namespace signorini
