#include "addons/estimate/goal.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "addons/estimate/contact_edges.hpp"
#include "addons/estimate/profile.hpp"
#include "closed_form/hertz_fit.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/places.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;

/// A goal that is a sum of displacements of the nodes of one body.
struct NodeSum {
  std::size_t body;
  std::vector<Index> nodes;
  VectorXd share;
};

NodeSum nodes_of(const Model& model, const Displacement& goal, const std::string& name) {
  require_input(goal.boundary.empty() != !goal.point.has_value(), "goal '", name,
                "': a displacement is that of a boundary or of a point; give one of them, not ",
                goal.boundary.empty() ? "none" : "both");
  const std::size_t body = body_index(model.bodies, {goal.boundary, goal.body});
  const BodyModel& own = model.bodies[body];
  if (!goal.point) {
    VectorXd share = boundary_weights(own.mesh, goal.boundary, depth_of(own.material));
    if (!(share.sum() > 0)) share = boundary_weights(own.mesh, goal.boundary, {});  // on the axis
    return {body, boundary_nodes(own.mesh, goal.boundary), share / share.sum()};
  }
  const EdgePlace place = place_on_edge(own.mesh, *goal.point);
  for (const PointForce& force : own.loads.points)
    require_input(
        force.point != *goal.point || force.force(static_cast<int>(goal.axis)) == 0, "goal '", name,
        "': a point force acts at this very point of body '", own.mesh.name,
        "', where the displacement grows without bound as the mesh is refined; ask for another "
        "point, or spread the force");
  return {body, place.nodes, place.share.head(static_cast<Index>(place.nodes.size()))};
}

/// How the unknowns of a model share in such a sum.
VectorXd shares_of_unknowns(const Model& model, const Displacement& goal, const std::string& name) {
  const NodeSum sum = nodes_of(model, goal, name);
  const BodyModel& own = model.bodies[sum.body];
  VectorXd share = VectorXd::Zero(model.unknowns.count);
  for (std::size_t k = 0; k < sum.nodes.size(); ++k) {
    const Index unknown = own.unknowns.number(sum.nodes[k], static_cast<int>(goal.axis));
    if (unknown >= 0) share(own.first_unknown + unknown) += sum.share(static_cast<Index>(k));
  }
  return share;
}

double peak_of(const Profile& read, double inner = fitted_part) {
  return fit_hertz(read.line.x, read.pressure, inner, read.line.footprint).peak_pressure;
}

std::vector<double> gradient_of_peak(const Profile& read) {
  return peak_pressure_gradient(read.line.x, read.pressure, fitted_part, read.line.footprint);
}

double pressure_at(const HertzFit& fit, double x) {
  return fit.peak_pressure * std::sqrt(std::max(0.0, 1 - std::pow(x / fit.half_width, 2)));
}

/// The mean of an ellipse of pressure that the force on a node of straight sides tells.
double mean_around(const ContactLine& line, std::size_t node, const HertzFit& fit) {
  const std::vector<double>& x = line.x;
  double sum = 0, weight = 0;
  const auto side = [&](std::size_t other) {
    const double way = x[other] - x[node];
    for (const GaussPoint& gauss : gauss_line(16)) {
      const double t = (1 + gauss.xi) / 2;
      const double ring = line.footprint == Footprint::Circle ? x[node] + t * way : 1;
      const double part = gauss.weight * std::abs(way) * (1 - t) * ring;
      sum += part * pressure_at(fit, x[node] + t * way);
      weight += part;
    }
  };
  if (node > 0) side(node - 1);
  if (node + 1 < x.size()) side(node + 1);
  return sum / weight;
}

/// No ellipse of pressure is wider than where it presses, whose end a mesh knows to an edge: than the second nodes beyond
/// the outermost that press.
void require_closed_to(const Profile& read, double half_width, const Goal& goal) {
  const std::vector<double>& x = read.line.x;
  double reach = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t beside = k - std::min<std::size_t>(k, 2); beside < std::min(k + 3, x.size());
         ++beside)
      if (read.force[beside] > 0) reach = std::max(reach, std::abs(x[k]));
  require_input(half_width <= reach, "goal '", goal.name,
                "': an ellipse of these forces has the half-width ", half_width,
                ", and contact reaches only ", reach,
                " from its middle: it does not press as Hertz's does; ask for its force or for a "
                "displacement");
}

/// Runs a reading of Hertz's contact, whose own errors blame its caller.
template <typename Read>
auto readable(const Goal& goal, Read&& read) {
  try {
    return read();
  } catch (const std::invalid_argument& error) {
    throw ProblemError(text("goal '", goal.name, "': ", error.what()));
  }
}

/// The force of an ellipse of pressure on the line of a contact, which a half-model ends in the middle [force].
double force_of(const HertzFit& ellipse, const Model& model, const Profile& read) {
  const double b = ellipse.half_width;
  if (read.line.footprint == Footprint::Circle) return 2 * pi / 3 * ellipse.peak_pressure * b * b;
  const auto area_to = [&](double x) {
    const double part = std::clamp(x / b, -1.0, 1.0);
    return b / 2 * (part * std::sqrt(1 - part * part) + std::asin(part));
  };
  const std::vector<double>& x = read.line.x;
  const auto nearest = std::min_element(
      x.begin(), x.end(), [](double a, double c) { return std::abs(a) < std::abs(c); });
  const Index pair = read.line.pair[at(nearest - x.begin())];
  const double depth = depth_of(source_of(model, pair).material).at(model.pairs.position(pair, 0));
  return ellipse.peak_pressure * depth * (area_to(x.back()) - area_to(x.front()));
}

/// How far the half-width by the moment of the forces is from that of an ellipse of the fitted peak that bears their sum.
double error_of_width(const Model& model, const Profile& read, double half_width) {
  const double borne = std::accumulate(read.force.begin(), read.force.end(), 0.0);
  const double part = borne / force_of({peak_of(read), half_width}, model, read) - 1;
  return half_width * std::abs(part) / (read.line.footprint == Footprint::Circle ? 2 : 1);
}

void require_numbers(const Solution& solution, const Goal& goal) {
  require_input(solution.contact.report.status == SolveStatus::Solved, "goal '", goal.name,
                "': the problem is not solved: ", to_string(solution.contact.report.status));
}

/// The forces of one contact.
struct Resultant {
  Vector2d sum = Vector2d::Zero();
  VectorXd along;  ///< of all rows of A: what a force of one adds in the direction of the sum
};

Resultant resultant(const Model& model, const Solution& solution, const ContactForce& goal,
                    const std::string& name) {
  const ContactState& contact = solution.contact;
  const Index pairs = contact.force.size();
  NodeArray direction = NodeArray::Zero(model.programme.A.rows(), 2);
  for (const Index pair : pairs_of(model, goal.contact))
    direction.row(pair) = model.pairs.normal.row(pair);
  for (std::size_t k = 0; k < contact.frictional_pairs.size(); ++k) {
    const auto n = direction.row(contact.frictional_pairs[k]);
    direction.row(pairs + static_cast<Index>(k)) << n.y(), -n.x();
  }
  if (is_axial(model.bodies.front())) direction.col(0).setZero();
  const VectorXd force = all_forces(contact);
  const Vector2d sum = direction.transpose() * force;
  const double size = sum.norm();
  require_input(size > std::sqrt(epsilon) * force.lpNorm<1>(), "goal '", name,
                "': the forces of the contact balance each other, their resultant is ", size,
                "; ask for its normal_force");
  return {sum, direction * (sum / size)};
}

double share_at(const NormalForce& goal, const Model& model, Index pair) {
  return goal.share ? goal.share(model.pairs.position.row(pair).transpose()) : 1;
}

}  // namespace

double value(const Model& model, const Solution& solution, const Goal& goal) {
  require_numbers(solution, goal);
  if (const auto* force = std::get_if<ContactForce>(&goal.quantity))
    return resultant(model, solution, *force, goal.name).sum.norm();
  if (const auto* force = std::get_if<NormalForce>(&goal.quantity)) {
    double sum = 0;
    for (const Index pair : pairs_of(model, force->contact))
      sum += share_at(*force, model, pair) * solution.contact.force(pair);
    return sum;
  }
  if (const auto* moved = std::get_if<Displacement>(&goal.quantity)) {
    const NodeSum sum = nodes_of(model, *moved, goal.name);
    const NodeArray& u = solution.displacements[sum.body];
    double mean = 0;
    for (std::size_t k = 0; k < sum.nodes.size(); ++k)
      mean += sum.share(static_cast<Index>(k)) * u(sum.nodes[k], static_cast<int>(moved->axis));
    return mean;
  }
  return readable(goal, [&] {
    if (const auto* peak = std::get_if<PeakPressure>(&goal.quantity)) {
      const Profile read = profile(model, solution, peak->contact, peak->middle);
      return peak_of(read);
    }
    const auto& width = std::get<HalfWidth>(goal.quantity);
    const Profile read = profile(model, solution, width.contact, width.middle);
    const double half_width =
        half_width_of_forces(read.line.x, read.force, read.trace, read.line.footprint);
    require_closed_to(read, half_width, goal);
    return half_width;
  });
}

double terms_of(const Model& model, const Solution& solution, const Goal& goal) {
  double sum = 0;
  if (const auto* moved = std::get_if<Displacement>(&goal.quantity)) {
    const NodeSum of = nodes_of(model, *moved, goal.name);
    for (std::size_t k = 0; k < of.nodes.size(); ++k)
      sum += std::abs(of.share(static_cast<Index>(k))) *
             solution.displacements[of.body].row(of.nodes[k]).norm();
    return sum;
  }
  const auto* force = std::get_if<NormalForce>(&goal.quantity);
  if (force == nullptr) return std::abs(value(model, solution, goal));
  for (const Index pair : pairs_of(model, force->contact))
    sum += std::abs(share_at(*force, model, pair) * solution.contact.force(pair));
  return sum;
}

GoalGradient gradient(const Model& model, const Solution& solution, const Goal& goal) {
  require_numbers(solution, goal);
  if (const auto* moved = std::get_if<Displacement>(&goal.quantity))
    return {shares_of_unknowns(model, *moved, goal.name), {}};
  if (const auto* force = std::get_if<ContactForce>(&goal.quantity))
    return {{}, resultant(model, solution, *force, goal.name).along};
  GoalGradient d{{}, VectorXd::Zero(model.programme.A.rows())};
  if (const auto* force = std::get_if<NormalForce>(&goal.quantity)) {
    for (const Index pair : pairs_of(model, force->contact))
      d.force(pair) = share_at(*force, model, pair);
    return d;
  }
  readable(goal, [&] {
    if (const auto* peak = std::get_if<PeakPressure>(&goal.quantity)) {
      const Profile read = profile(model, solution, peak->contact, peak->middle);
      const std::vector<double> change = gradient_of_peak(read);
      for (std::size_t k = 0; k < change.size(); ++k)
        d.force(read.line.pair[k]) = change[k] / model.pairs.weight(read.line.pair[k]);
    } else {
      const auto& width = std::get<HalfWidth>(goal.quantity);
      const Profile read = profile(model, solution, width.contact, width.middle);
      const std::vector<double> change =
          half_width_gradient(read.line.x, read.force, read.trace, read.line.footprint);
      d.force(read.line.pair) =
          read.nodal.transpose() *
          Eigen::Map<const VectorXd>(change.data(), static_cast<Index>(change.size()));
    }
  });
  return d;
}

double quadrature_error(const Model& model, const Solution& solution, const Goal& goal) {
  require_numbers(solution, goal);
  double sum = 0;
  if (const auto* force = std::get_if<NormalForce>(&goal.quantity)) {
    if (!force->share) return 0;
    const std::vector<Index> pairs = pairs_of(model, force->contact);
    for (const ContactEdge& edge : contact_edges(model)) {
      if (!edge.straight || !std::binary_search(pairs.begin(), pairs.end(), edge.from)) continue;
      const double first = share_at(*force, model, edge.from);
      const double last = share_at(*force, model, edge.to);
      const Vector2d from = model.pairs.position.row(edge.from).transpose();
      const Vector2d to = model.pairs.position.row(edge.to).transpose();
      for (const GaussPoint& gauss : gauss_line(16)) {
        const double t = (1 + gauss.xi) / 2;
        const double pressure =
            (1 - t) * solution.pressure(edge.from) + t * solution.pressure(edge.to);
        const double beyond = force->share(from + t * (to - from)) - (1 - t) * first - t * last;
        sum += gauss.weight / 2 * edge.length * edge.depth * pressure * beyond;
      }
    }
  } else if (const auto* peak = std::get_if<PeakPressure>(&goal.quantity)) {
    const Profile read = profile(model, solution, peak->contact, peak->middle);
    if (read.trace == Trace::Quadratic) return 0;
    return readable(goal, [&] {
      const std::vector<double>& x = read.line.x;
      const HertzFit fit = fit_hertz(x, read.pressure, fitted_part, read.line.footprint);
      const std::vector<double> change = gradient_of_peak(read);
      for (std::size_t k = 0; k < x.size(); ++k)
        if (change[k] != 0)
          sum -= change[k] * (mean_around(read.line, k, fit) - pressure_at(fit, x[k]));
      return sum;
    });
  }
  return sum;
}

double model_error(const Model& model, const Solution& solution, const Goal& goal) {
  require_numbers(solution, goal);
  if (const auto* width = std::get_if<HalfWidth>(&goal.quantity)) {
    const double all = value(model, solution, goal);
    try {
      const Profile read = profile(model, solution, width->contact, width->middle);
      return std::min(all, error_of_width(model, read, all));
    } catch (const std::invalid_argument&) {
      return all;
    }
  }
  const auto* peak = std::get_if<PeakPressure>(&goal.quantity);
  if (peak == nullptr) return 0;
  const Profile read = profile(model, solution, peak->contact, peak->middle);
  const double all = readable(goal, [&] { return peak_of(read); });
  try {
    return std::abs(peak_of(read, fitted_part / 2) - all);
  } catch (const std::invalid_argument&) {
    return all;
  }
}

}  // namespace signorini
