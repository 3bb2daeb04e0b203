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

using Eigen::Index, Eigen::VectorXd;

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

void check_one_step(const Model& model) {
  require_input(!model.equations,
                "estimate: the error along bonds, whose forces are those of equations, is not "
                "estimated: leave them out, or compare with a finer mesh");
  require_input(
      model.path.times.empty(),
      "estimate: the model has load steps, whose errors add up along the path; only that of a "
      "scene solved in one step is estimated: leave the path out, or compare with a finer mesh");
}

void check_nodes_of_pairs(const Model& model) {
  for (std::size_t pair = 0; pair < model.pairs.node.size(); ++pair)
    require_input(
        model.pairs.node[pair] >= 0, "estimate: the pairs of ",
        model.contacts[model.contact_of[pair]],
        " are Gauss points with forces of their own, whose error is not estimated; use the gap "
        "operator mortar or node_to_segment");
}

bool has_sign(const Goal& goal) {
  return !std::holds_alternative<PeakPressure>(goal.quantity) &&
         !std::holds_alternative<HalfWidth>(goal.quantity);
}

ErrorParts parts_of_contact(const Model& model, const std::vector<ContactEdge>& edges,
                            const std::vector<ContactEnd>& ends, const GoalGradient& change,
                            const DualSolution& z) {
  ErrorParts parts;
  parts.gap = gap_between_nodes(model, edges, z.force);
  VectorXd per_force = -(model.programme.A * (z.displacement + z.rigid));
  if (change.force.size() > 0) per_force += change.force;
  for (const ContactEnd& end : ends)
    parts.free_boundary += free_boundary(end, per_force(end.open), z.force(end.closed));
  return parts;
}

/// What strains a body, in the solution and in every dual one.
PrimalAndDuals fields_of(const BodyModel& body, const VectorXd& strains,
                         const std::vector<DualSolution>& duals) {
  PrimalAndDuals fields{body.mesh, body.element, body.material, {of_body(body, strains)}};
  fields.displacements[0] += body.unknowns.held;
  for (const DualSolution& z : duals) fields.displacements.push_back(of_body(body, z.displacement));
  return fields;
}

SmoothStress timed_recovery(const PrimalAndDuals& fields, Ledger& ledger) {
  const Ledger::Phase phase(ledger, "recovery");
  return recovered(fields);
}

/// What moves a body, in the solution and in every dual one.
std::vector<WholeField> whole_fields(const ContactOnNodes& contact, const BodyModel& body,
                                     const NodeArray& displacement, const Solution& solution,
                                     const std::vector<DualSolution>& duals) {
  std::vector<WholeField> whole = {{displacement, contact.pressures(solution.contact.force)}};
  for (const DualSolution& z : duals)
    whole.push_back({of_body(body, z.displacement + z.rigid), contact.pressures(z.force)});
  return whole;
}

void add_interior(const PrimalAndDuals& fields, const SmoothStress& smooth, const VectorXd& counted,
                  std::vector<Estimate>& all) {
  const Eigen::MatrixXd products = error_products(fields, smooth, counted);
  const Eigen::MatrixXd first = anisotropic_indicator(fields, smooth);
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].share.emplace_back(products.col(static_cast<Index>(k)));
    all[k].first_direction.emplace_back(first.col(static_cast<Index>(k)));
    all[k].parts.interior += all[k].share.back().sum();
  }
}

void add_outline(const std::vector<OutlineShare>& sides, std::vector<Estimate>& all) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::vector<SideShare>& of_body = all[k].of_sides.emplace_back();
    for (const OutlineShare& side : sides) {
      of_body.push_back({side.side, side.amount(static_cast<Index>(k))});
      all[k].parts.outline += of_body.back().amount;
    }
  }
}

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
  check_one_step(model);
  const Dual dual(model, condensed, solution);
  check_nodes_of_pairs(model);
  const Residuals residuals(model.programme, solution.refined);
  const std::vector<ContactEdge> edges = contact_edges(model);
  const std::vector<ContactEnd> ends =
      dual.slides() ? std::vector<ContactEnd>() : contact_ends(edges, solution, dual);
  std::vector<Estimate> all(goals.size());
  std::vector<DualSolution> duals;
  for (const Goal& goal : goals) {
    Estimate& one = all[duals.size()];
    one.goal = goal.name;
    one.value = value(model, solution, goal);
    one.is_signed = has_sign(goal);
    const GoalGradient change = gradient(model, solution, goal);
    duals.push_back(dual.solve(change, ledger));
    one.algebraic = residuals.change(duals.back());
    one.parts = parts_of_contact(model, edges, ends, change, duals.back());
    one.parts.quadrature_error = quadrature_error(model, solution, goal);
  }
  const VectorXd strains = strained(solution.refined);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const PrimalAndDuals fields = fields_of(body, strains, duals);
    const SmoothStress smooth = timed_recovery(fields, ledger);
    const Ledger::Phase weighing(ledger, "weighing");
    add_interior(fields, smooth, away_from_ends(ends, model, body), all);
    const ContactOnNodes contact(model, body);
    const auto whole = whole_fields(contact, body, solution.displacements[b], solution, duals);
    add_outline(outline_shares(body, smooth, contact, whole, goals), all);
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
