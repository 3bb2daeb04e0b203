#include "addons/checks/lost_digits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "addons/certified/known_forces.hpp"
#include "addons/equations/equations.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/plane.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Of the forces of a body, from where on they are no solution.
constexpr double too_much = 1e-2;

/// Forces on a body added up: their sum, and their moment about its middle over the distance of its farthest node; of a body of
/// revolution the sum along its axis only.
class Resultant {
 public:
  Resultant(const BodyModel& body, const Eigen::Vector2d& middle, double reach)
      : body_(body), middle_(middle), reach_(reach) {}
  void add(Index node, const Eigen::Vector2d& force) {
    const Eigen::Vector2d arm = body_.mesh.nodes.row(node).transpose() - middle_;
    force_ += force;
    moment_ += cross(arm, force);
  }
  [[nodiscard]] double size() const {
    return is_axial(body_) ? std::abs(force_.y()) : force_.norm() + std::abs(moment_) / reach_;
  }

 private:
  const BodyModel& body_;
  Eigen::Vector2d middle_;
  double reach_;
  Eigen::Vector2d force_ = Eigen::Vector2d::Zero();
  double moment_ = 0;
};

/// The root of the sum of all squares of K, by every 16th: as good as all for what is compared with a millionth.
double size_of(const Eigen::SparseMatrix<double>& K) {
  constexpr Index stride = 16;
  if (K.nonZeros() < stride * stride) return K.coeffs().matrix().norm();
  using Some = Eigen::Map<const VectorXd, 0, Eigen::InnerStride<stride>>;
  return std::sqrt(static_cast<double>(stride)) * Some(K.valuePtr(), K.nonZeros() / stride).norm();
}

double sum_of_norms(const NodeArray& forces) { return forces.rowwise().norm().sum(); }

/// Magnitudes of the loads on a body.
double given(const BodyModel& body) {
  return sum_of_norms(nodal_loads(body.mesh, body.element, body.material, body.loads));
}

/// Magnitudes of what contact, springs and bonds do to a body.
double pushed(const Model& model, const Solution& solution, std::size_t b) {
  const double sum = sum_of_norms(contact_forces(model, solution, b)) +
                     sum_of_norms(spring_forces(model, solution, b));
  return solution.bond_forces.empty() ? sum : sum + sum_of_norms(solution.bond_forces[b]);
}

/// What supports bear: one force for each boundary that is held as a whole, and one for each other node. Single nodes of a clamped edge
/// pull at each other, and that would hide what the edge as a whole lacks.
double borne(const BodyModel& body, const NodeArray& inside, const Resultant& none) {
  const auto held = (body.unknowns.number < 0).eval();
  std::vector<bool> seen(at(inside.rows()), false);
  double sum = 0;
  const auto add = [&](const std::vector<Index>& nodes) {
    Resultant support = none;
    for (const Index node : nodes) {
      seen[at(node)] = true;
      support.add(node, held.row(node).select(inside.row(node).array(), 0.0).matrix().transpose());
    }
    sum += support.size();
  };
  for (const auto& [name, sides] : body.mesh.boundaries) {
    const std::vector<Index> nodes = boundary_nodes(body.mesh, name);
    if (std::all_of(nodes.begin(), nodes.end(), [&](Index i) { return held.row(i).any(); }))
      add(nodes);
  }
  for (Index i = 0; i < inside.rows(); ++i)
    if (held.row(i).any() && !seen[at(i)]) add({i});
  return sum;
}

/// What is found once for all bodies of a model.
struct Whole {
  double rounding;    ///< of a sum of internal forces [force]
  NodeArray strains;  ///< displacements of all nodes without rigid motions, empty if the solution has them [length]
  double loads = 0;   ///< magnitudes of the loads on all bodies [force]

  Whole(const Model& model, const Solution& solution, double rounding_of_sums)
      : rounding(rounding_of_sums) {
    if (solution.strains.empty()) strains = expand(model.unknowns, strained(solution.refined));
    for (const BodyModel& body : model.bodies) loads += given(body);
  }
};

/// How far what strains any body goes [length].
double farthest(const Solution& solution) {
  double most = solution.strains.empty() ? largest(strained(solution.refined)) : 0;
  for (const NodeArray& own : solution.strains) most = std::max(most, own.cwiseAbs().maxCoeff());
  return most;
}

/// The share of its forces that a body as a whole lacks. Loads are data. Forces that were found count if they are more than rounding, or
/// than nothing beside all loads: where nothing pushes, all that is found is rounding, and nothing is lost.
double lost_share(const Model& model, const Solution& solution, const Whole& whole, std::size_t b) {
  const BodyModel& body = model.bodies[b];
  const NodeArray own =
      solution.strains.empty()
          ? NodeArray(whole.strains.middleRows(body.first_node, body.mesh.n_nodes()))
          : solution.strains[b];
  const NodeArray inside = internal_forces(body.mesh, body.element, body.material, own);
  const Eigen::RowVector2d middle = body.mesh.nodes.colwise().mean();
  const Resultant none(body, middle.transpose(),
                       (body.mesh.nodes.rowwise() - middle).rowwise().norm().maxCoeff());
  Resultant lost = none;
  for (Index i = 0; i < inside.rows(); ++i) lost.add(i, inside.row(i).transpose());
  const double found = pushed(model, solution, b) + borne(body, inside, none);
  const bool real =
      too_much * found > whole.rounding || (whole.loads > 0 && found > known_well * whole.loads);
  const double size = given(body) + (real ? found : 0);
  return size > 0 ? lost.size() / size : 0;
}

}  // namespace

void check_lost_digits(const Model& model, const Condensed& /*condensed*/, Solution& solution) {
  // What rounding of K does to a sum of internal forces, as errors without an order add up, and some times more.
  const QuadraticProgramme& programme = model.programme;
  const double rounding = 8 * epsilon * size_of(programme.stiffness) * farthest(solution);
  const bool bound = model.equations && std::any_of(model.equations->rows.begin(), model.equations->rows.end(),
                                                    [](const Equation& row) { return row.right != 0; });
  const bool moved = bound || !model.unknowns.held.isZero(0);  // by supports or equations, which is in p as well
  std::optional<VectorXd> contact;
  std::optional<Whole> whole;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const auto enough = [&](const VectorXd& all) {
      return rounding <=
             known_well * all.segment(body.first_unknown, body.unknowns.count).lpNorm<1>();
    };
    // Of most bodies this says that nothing can be lost, at a price that is not felt.
    if (body.material.base.law != nullptr || (!moved && enough(programme.load))) continue;
    if (!contact) contact = programme.A.transpose() * solution.refined.force;
    if (enough(*contact)) continue;
    if (!whole) whole.emplace(model, solution, rounding);
    const double share = lost_share(model, solution, *whole, b);
    if (!(share > known_well)) continue;
    const std::string words =
        text("body '", body.mesh.name, "': loads, contact and supports do not balance, by ",
             number(100 * share, "%.2g"),
             " % of them, because the stiffness of the body is rounded. It is too slender, too "
             "nearly incompressible or too soft beside another one for these cells: take fewer and "
             "larger ones along it, a Poisson ratio farther from 0.5, or a rigid obstacle in the "
             "place of the stiff one");
    if (share <= too_much) {
      solution.notes.push_back(words);
      continue;
    }
    solution.contact.report.status = SolveStatus::Breakdown;
    solution.contact.reason = words;
    return;
  }
}

}  // namespace signorini
