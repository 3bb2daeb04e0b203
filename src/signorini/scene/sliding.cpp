#include "signorini/scene/sliding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "signorini/closing/closing.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/programme/rigid_modes.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/follow.hpp"
#include "signorini/solvers/solvers.hpp"
#include "signorini/solvers/springs.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Rows along the tangents (n_y, -n_x) of rows along normals n.
NodalRows turned(const NodalRows& opening) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index row = 0; row < opening.rows(); ++row)
    for (NodalRows::InnerIterator it(opening, row); it; ++it) {
      const bool along_x = it.col() % 2 == 0;
      entries.emplace_back(static_cast<int>(row),
                           static_cast<int>(along_x ? it.col() + 1 : it.col() - 1),
                           along_x ? -it.value() : it.value());
    }
  NodalRows rows(opening.rows(), opening.cols());
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

VectorXd all_displacements(const Model& model, const std::vector<NodeArray>& displacements) {
  VectorXd all(2 * count_nodes(model.bodies));
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    all.segment(2 * model.bodies[b].first_node, displacements[b].size()) =
        Eigen::Map<const VectorXd>(displacements[b].data(), displacements[b].size());
  return all;
}

/// A force that changes by this much is noted: half of 5 %, because one step of Newton's method may foresee half of a
/// change only.
constexpr double known_well = 0.025;

/// A share of the edge that makes a note if as large a share of the forces acts on other nodes, though their sum may be
/// right.
constexpr double much = 0.25;

/// How far the pairs of a contact have slid, and what that makes of its force.
std::string in_words(const Model& model, const Slid& one) {
  std::string words = "its pairs are those of the meshes as they are";
  if (one.pair >= 0) {
    const auto at = model.pairs.position.row(one.pair);
    words += text(", but the one at (", at(0), ", ", at(1), ") has slid by ", one.slip, ", ",
                  one.slip / one.edge, " of its edge");
  }
  words += ". Where the bodies have moved to, ";
  if (!one.lost.empty()) return words + "there are none: " + one.lost;
  if (!one.new_force) return words + "no forces are found that balance the loads";
  words += text("the force on the source would be about (", one.new_force->x(), ", ",
                one.new_force->y(), ") in the place of (", one.force.x(), ", ", one.force.y(), ')');
  return std::isfinite(one.elsewhere)
             ? words + text(", ", 100 * one.elsewhere, " % of it on other nodes")
             : words;
}

/// What pairs do to the nodes.
struct Forces {
  VectorXd normal;  // of all pairs
  VectorXd shear;   // of all pairs, 0 where they cannot rub
};

Forces forces_of(const ContactState& contact) {
  Forces forces{contact.force, VectorXd::Zero(contact.force.size())};
  for (std::size_t k = 0; k < contact.rubbing.size(); ++k)
    forces.shear(contact.rubbing[k]) = contact.friction(static_cast<Index>(k));
  return forces;
}

/// On all nodes. \param only  a contact, of the pairs of which \param contact_of  says the number; -1: all
VectorXd nodal(const NodalRows& opening, const Forces& forces) {
  return opening.transpose() * forces.normal + turned(opening).transpose() * forces.shear;
}

Forces of_contact(Forces forces, const std::vector<std::size_t>& contact_of, std::size_t contact) {
  for (std::size_t pair = 0; pair < contact_of.size(); ++pair)
    if (contact_of[pair] != contact)
      forces.normal(static_cast<Index>(pair)) = forces.shear(static_cast<Index>(pair)) = 0;
  return forces;
}

/// Of forces on all nodes those on the unknowns.
VectorXd on_unknowns(const Model& model, const VectorXd& forces) {
  VectorXd load = VectorXd::Zero(model.unknowns.count);
  for (const BodyModel& body : model.bodies) {
    const NodeArray own =
        Eigen::Map<const NodeArray>(forces.data() + 2 * body.first_node, body.mesh.n_nodes(), 2);
    add_nodal_forces(body, own, load);
  }
  return load;
}

std::vector<Index> numbers(Index first, Index count) {
  std::vector<Index> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), first);
  return all;
}

/// What supports give all nodes.
VectorXd held(const Model& model) {
  const NodeArray& held = model.unknowns.held;
  return Eigen::Map<const VectorXd>(held.data(), held.size());
}

/// The columns of rows of all nodes that belong to unknowns.
NodalRows free_columns(const Model& model, const NodalRows& rows) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index row = 0; row < rows.rows(); ++row)
    for (NodalRows::InnerIterator it(rows, row); it; ++it)
      if (const Index unknown = model.unknowns.number(it.col() / 2, it.col() % 2); unknown >= 0)
        entries.emplace_back(static_cast<int>(row), static_cast<int>(unknown), it.value());
  NodalRows free(rows.rows(), model.unknowns.count);
  free.setFromTriplets(entries.begin(), entries.end());
  return free;
}

/// The condensed problem where the bodies have moved to, linearised there but for the compliance of the pairs that there
/// were. Pairs that face nothing there are far open; those that overlap and were none come behind the others.
/// \param there  the pairs \param u  all displacements \param opens  gaps there less the linear ones [length]
/// \param more   what their forces do more on the unknowns there [force]
ContactProblem moved_problem(const Model& model, const Condensed& condensed,
                             const MovedPairs& there, const VectorXd& u, const VectorXd& opens,
                             const VectorXd& more) {
  const Index pairs = opens.size();
  const Index fresh = there.fresh_gap.size();
  ContactProblem problem = condensed.problem;
  const VectorXd response = condensed.factor.solve(more);
  const VectorXd closes = model.programme.A * response;
  const double far = u.cwiseAbs().maxCoeff() + problem.free_gap.cwiseAbs().maxCoeff();
  problem.free_gap += opens.array().isInf().select(far, opens) - closes.head(pairs);
  problem.free_slip -= closes.tail(problem.free_slip.size());
  if (!model.modes.empty()) problem.resultant -= mode_shapes(model.modes).transpose() * more;
  if (fresh == 0) return problem;
  const NodalRows rows = -free_columns(model, there.fresh);  // as in A
  const Index slips = problem.free_slip.size();
  QuadraticProgramme with;
  with.load = model.programme.load;
  with.A = below(below(selected_rows(model.programme.A, numbers(0, pairs)), rows),
                 selected_rows(model.programme.A, numbers(pairs, slips)));
  Ledger unseen;
  problem.compliance = condensed.factor.compliance(with.A, unseen);
  VectorXd gap(pairs + fresh);
  gap << problem.free_gap, there.fresh_gap - there.fresh * u + there.fresh * held(model) -
                               rows * (condensed.free_displacement + response);
  problem.free_gap = gap;
  const VectorXd resultant = problem.resultant;
  if (!model.modes.empty()) add_rigid_modes(with, mode_shapes(model.modes), problem);
  problem.resultant = resultant;
  return problem;
}

/// What the pairs carry there; look at the status first.
ContactState solved_there(const ContactProblem& problem, const ContactState& contact) {
  SolverOptions options;
  options.start = all_motions(contact);
  options.start.resize(static_cast<std::size_t>(problem.free_gap.size()), Motion::Open);
  const Solver& solver =
      problem.law.pair.empty() ? find_solver(Scene().solver) : friction_solvers().front();
  return solve(problem, solver, options);
}

/// Sum of the forces on the body that the first pair of a contact is on.
Vector2d resultant(const Model& model, Index pair, const VectorXd& forces) {
  const Index node = NodalRows::InnerIterator(model.pairs.opening, pair).col() / 2;
  const std::size_t b = body_of_node(model.bodies, node);
  const Eigen::Map<const NodeArray> all(forces.data(), forces.size() / 2, 2);
  return all.middleRows(model.bodies[b].first_node, model.bodies[b].mesh.n_nodes())
      .colwise()
      .sum()
      .transpose();
}

/// By how much gaps are larger there than the linear ones. A node stands for half of the edges beside it: one that has
/// slid past the end of a target by a small part of them still presses on that.
/// \param linear  by how much the gaps of the solution have opened [length]
VectorXd opened(const MovedPairs& there, const VectorXd& linear, const VectorXd& slip) {
  VectorXd opens = there.opens - linear;
  for (Index pair = 0; pair < opens.size(); ++pair)
    if (std::isinf(opens(pair)) && std::abs(slip(pair)) < known_well * there.edge(pair))
      opens(pair) = 0;
  return opens;
}

/// What is smaller than this share of the largest force says nothing.
constexpr double nothing = 1e-6;

/// Finds in each contact the pair that carries a force and slid farthest in edges.
void find_farthest(const VectorXd& slip, const VectorXd& edge, const VectorXd& force,
                   const std::vector<std::size_t>& contact_of, std::vector<Slid>& all) {
  const double most = force.maxCoeff();
  for (Index pair = 0; pair < force.size(); ++pair) {
    Slid& one = all[contact_of[static_cast<std::size_t>(pair)]];
    const double far = std::abs(slip(pair));
    if (force(pair) <= nothing * most) continue;
    if (one.pair >= 0 && far * one.edge <= one.slip * edge(pair)) continue;
    one.pair = pair;
    one.slip = far;
    one.edge = edge(pair);
  }
}

/// Finds the contacts of which a row or a gap is another where the bodies have moved to.
/// \param turn  N there less N \param opens  gaps there less the linear ones [length]
void find_moving(const Model& model, const VectorXd& u, const NodalRows& turn,
                 const VectorXd& opens, const MovedPairs& there, std::vector<Slid>& all) {
  const double rounding = gap_rounding(model.pairs) + 16 * epsilon * u.cwiseAbs().maxCoeff();
  for (Index pair = 0; pair < opens.size(); ++pair)
    if (std::abs(opens(pair)) > rounding || turn.row(pair).norm() > 16 * epsilon)
      all[model.contact_of[static_cast<std::size_t>(pair)]].moves = true;
  for (const std::size_t contact : there.fresh_contact) all[contact].moves = true;
}

/// Compares what a contact does to the nodes with what it would do.
/// \param none  up to which sum its forces are none [force]
void compare(const VectorXd& before, const VectorXd& after, double new_normal, double none,
             Slid& one) {
  const double most = std::max(one.normal, new_normal);
  if (most > none) {
    one.change = std::max((*one.new_force - one.force).norm(), std::abs(new_normal - one.normal)) /
                 one.normal;
    one.elsewhere = (after - before).lpNorm<1>() / (2 * before.lpNorm<1>());
  }
  one.normal = most;
}

}  // namespace

VectorXd slips(const Model& model, const std::vector<NodeArray>& displacements) {
  return turned(model.pairs.opening) * all_displacements(model, displacements);
}

std::vector<Slid> slid(const Model& model, const Condensed& condensed, const Solution& solution) {
  std::vector<Slid> all(model.contacts.size());
  const VectorXd u = all_displacements(model, solution.displacements);
  const MovedPairs there =
      model.follow(model, Eigen::Map<const NodeArray>(u.data(), u.size() / 2, 2));
  const NodalRows turn = there.opening - model.pairs.opening;
  const VectorXd slip = slips(model, solution.displacements);
  const VectorXd opens = opened(there, model.pairs.opening * u, slip);
  find_moving(model, u, turn, opens, there, all);
  if (std::none_of(all.begin(), all.end(), [](const Slid& one) { return one.moves; })) return all;
  const Forces old = forces_of(solution.contact);
  find_farthest(slip, there.edge, old.normal, model.contact_of, all);
  const VectorXd more = on_unknowns(model, nodal(turn, old));
  const ContactState now =
      solved_there(moved_problem(model, condensed, there, u, opens, more), solution.contact);
  const bool solved = now.report.status == Status::Solved;
  const Forces forces = forces_of(now);
  const NodalRows rows = below(there.opening, there.fresh);
  std::vector<std::size_t> contact_of = model.contact_of;
  contact_of.insert(contact_of.end(), there.fresh_contact.begin(), there.fresh_contact.end());
  const double none = nothing * std::max(old.normal.sum(), solved ? forces.normal.sum() : 0);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto found = std::find(model.contact_of.begin(), model.contact_of.end(), k);
    if (found == model.contact_of.end()) continue;
    const Index first = found - model.contact_of.begin();
    Slid& one = all[k];
    one.lost = there.lost[k];
    const Forces before = of_contact(old, model.contact_of, k);
    const VectorXd on_nodes = nodal(model.pairs.opening, before);
    one.normal = before.normal.sum();
    one.force = resultant(model, first, on_nodes);
    if (solved) {
      const Forces after = of_contact(forces, contact_of, k);
      const VectorXd new_on_nodes = nodal(rows, after);
      one.new_force = resultant(model, first, new_on_nodes);
      compare(on_nodes, new_on_nodes, after.normal.sum(), none, one);
    } else {
      // Only a proof that nothing balances the loads is a change.
      if (now.report.status == Status::Infeasible)
        one.change = std::numeric_limits<double>::infinity();
      one.elsewhere = 0.5;
    }
  }
  return all;
}

void judge_sliding(const Model& model, const Condensed& condensed,
                   const std::function<VectorXd()>& no_forces, Solution& solution) {
  if (!model.follow || solution.contact.force.size() == 0) return;
  const std::vector<Slid> all = slid(model, condensed, solution);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Slid& one = all[k];
    const bool past = one.moves && one.slip > one.edge && one.elsewhere > known_well;
    const bool aside = one.moves && one.slip > much * one.edge && one.elsewhere > much;
    if (!past && !aside && one.change <= known_well) continue;
    if (one.normal <= no_forces().maxCoeff()) continue;
    const std::string words = text("contact ", model.contacts[k], ": ", in_words(model, one));
    if (!past || model.small_sliding[k]) {
      solution.notes.push_back(text(
          words, ". Take smaller movements, or move the meshes near to where they come to stand"));
      continue;
    }
    solution.contact.report.status = Status::Slid;
    solution.contact.reason =
        text(words,
             ". Move the meshes near to where they come to stand, or, if the force may act where "
             "it does, set small_sliding = true in this contact");
    return;
  }
}

}  // namespace signorini
