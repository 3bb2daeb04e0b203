#include "signorini/estimate/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/estimate/contact_edges.hpp"
#include "signorini/estimate/directions.hpp"
#include "signorini/estimate/dual.hpp"
#include "signorini/estimate/error_products.hpp"
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

/// A place where contact ends: a closed pair, and the open one beside it.
struct End {
  Index closed, open;
  double force;  // that the open one would carry
  double gap;    // that the closed one would have
};

std::vector<End> ends_of(const std::vector<ContactEdge>& edges, const Solution& solution,
                         const Dual& dual) {
  const std::vector<Index>& active = solution.contact.active;
  const auto closed = [&](Index pair) {
    return std::binary_search(active.begin(), active.end(), pair);
  };
  std::vector<End> ends;
  for (const ContactEdge& edge : edges) {
    if (closed(edge.from) == closed(edge.to)) continue;
    End end{edge.from, edge.to, 0, 0};
    if (!closed(edge.from)) std::swap(end.closed, end.open);
    end.force = dual.force_to_close(end.open);
    end.gap = dual.gap_without(end.closed);
    if (std::isfinite(end.force) && std::isfinite(end.gap)) ends.push_back(end);
  }
  return ends;
}

/// V of one end.
double vertex(const End& end, double per_force, double per_gap) {
  const double out = per_force * end.force, in = -per_gap * end.gap;
  const double bend = (out + in) / 2, slope = (out - in) / 2;
  if (bend == 0) return 0;
  const double offset = slope / (2 * bend);
  return -bend * std::min(1.0, offset * offset);
}

}  // namespace

std::vector<Estimate> estimates(const Model& model, const Condensed& condensed,
                                const Solution& solution, const std::vector<Goal>& goals,
                                Ledger& ledger) {
  const Ledger::Phase phase(ledger, "estimate");
  pose(model.path.times.empty(),
       "estimate: the model has load steps, whose errors add up along the path; only that of a "
       "scene solved in one step is "
       "estimated: leave the path out, or compare with a finer mesh");
  const Dual dual(model, condensed, solution);
  for (std::size_t pair = 0; pair < model.pairs.node.size(); ++pair)
    pose(model.pairs.node[pair] >= 0, "estimate: the pairs of ",
         model.contacts[model.contact_of[pair]],
         " are Gauss points with forces of their own, whose error is not estimated; use the gap "
         "operator mortar or node_to_segment");
  const QuadraticProgramme& programme = model.programme;
  const Residuals residuals(programme, solution.refined);
  const std::vector<ContactEdge> edges = contact_edges(model);
  const std::vector<End> ends = dual.slides() ? std::vector<End>() : ends_of(edges, solution, dual);
  std::vector<Estimate> all;
  std::vector<DualSolution> duals;
  for (const Goal& goal : goals) {
    Estimate one{goal.name, value(model, solution, goal), {}, 0, true, 0, {}, {}};
    one.is_signed = std::holds_alternative<ContactForce>(goal.quantity) ||
                    std::holds_alternative<Displacement>(goal.quantity);
    const GoalGradient change = gradient(model, solution, goal);
    duals.push_back(dual.solve(change, ledger));
    const DualSolution& z = duals.back();
    one.algebraic = residuals.change(z);
    one.parts.gap = gap_between_nodes(model, edges, z.force);
    one.parts.reading = overlooked(model, solution, goal);
    VectorXd per_force = -(programme.A * (z.displacement + z.rigid));
    if (change.force.size() > 0) per_force += change.force;
    for (const End& end : ends)
      one.parts.free_boundary += vertex(end, per_force(end.open), z.force(end.closed));
    all.push_back(std::move(one));
  }
  const VectorXd strains = strained(solution.refined);
  for (const BodyModel& body : model.bodies) {
    Fields fields{body.mesh, body.element, body.material, {of_body(body, strains)}};
    fields.displacements[0] += body.unknowns.held;
    for (const DualSolution& z : duals)
      fields.displacements.push_back(of_body(body, z.displacement));
    const SmoothStress smooth = [&] {
      const Ledger::Phase recovery(ledger, "recovery");
      return recovered(fields);
    }();
    const Ledger::Phase weighing(ledger, "weighing");
    const Eigen::MatrixXd products = error_products(fields, smooth);
    const Eigen::MatrixXd first = share_of_first_direction(fields, smooth);
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k].share.emplace_back(products.col(static_cast<Index>(k)));
      all[k].first_direction.emplace_back(first.col(static_cast<Index>(k)));
      all[k].parts.interior += all[k].share.back().sum();
    }
  }
  for (Estimate& one : all) {
    const ErrorParts& p = one.parts;
    one.error = one.is_signed ? p.interior + p.gap + p.reading + p.free_boundary
                              : std::abs(p.interior) + std::abs(p.gap) + std::abs(p.reading) +
                                    std::abs(p.free_boundary);
  }
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
  return {{"algebraic", estimate.algebraic,
           "what the residuals of the certified solution can do at most"},
          {"gap", p.gap + p.reading, "between the nodes of the contact: finer sides there"},
          {"element", p.interior + p.free_boundary,
           "stresses inside the bodies and the end of the contact: finer cells, or better ones"},
          {"domain", difference(compared.domain), "where the bodies were cut off: a larger domain"},
          {"model", difference(compared.model),
           "what the scene leaves out, such as large movements or the third dimension"}};
}

}  // namespace signorini
