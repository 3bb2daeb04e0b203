#include "addons/checks/sliding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "addons/checks/moved_forces.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;

/// What the pairs of one contact do to the nodes of all bodies, x and y of each [force]: of many bodies, to two of them.
using NodalForces = Eigen::SparseVector<double>;

/// Sum of forces on the nodes of a body.
Vector2d resultant(const BodyModel& body, const NodalForces& forces) {
  NodeArray own = NodeArray::Zero(body.mesh.n_nodes(), 2);
  for (NodalForces::InnerIterator it(forces); it; ++it) {
    const Index node = it.index() / 2 - body.first_node;
    if (node >= 0 && node < own.rows()) own(node, it.index() % 2) = it.value();
  }
  return sum_of_forces(body, own);
}

/// \return magnitudes of all entries, summed [force]
double size_of(const NodalForces& forces) { return forces.cwiseAbs().sum(); }

/// The pairs of each contact.
std::vector<std::vector<Index>> pairs_of(const std::vector<std::size_t>& contact_of,
                                         std::size_t contacts) {
  std::vector<std::vector<Index>> pairs(contacts);
  for (std::size_t pair = 0; pair < contact_of.size(); ++pair)
    pairs[contact_of[pair]].push_back(static_cast<Index>(pair));
  return pairs;
}

/// Forces of some pairs, and what they do.
struct ContactForces {
  double normal;
  NodalForces nodal;
};

ContactForces some_forces(const NodalRows& opening, const PairForces& forces,
                          const std::vector<Index>& pairs) {
  const PairForces own{forces.normal(pairs), forces.shear(pairs)};
  return {own.normal.sum(), on_nodes(selected_rows(opening, pairs), own)};
}

/// By how much gaps are larger there than the linear ones. A node stands for half of the edges beside it: one that has
/// slid past the end of a target by a small part of them still presses on that.
/// \param linear  by how much the gaps of the solution have opened [length]
VectorXd opened(const MovedPairs& there, const VectorXd& linear, const VectorXd& slip) {
  VectorXd opens = there.opens - linear;
  for (Index pair = 0; pair < opens.size(); ++pair)
    if (std::isinf(opens(pair)) && std::abs(slip(pair)) < noted_change * there.edge(pair))
      opens(pair) = 0;
  return opens;
}

/// Finds in each contact the pair that carries a force and slid farthest in edges.
/// \param none  up to which force a pair carries none [force]
void find_farthest(const VectorXd& slip, const VectorXd& edge, const VectorXd& force, double none,
                   const std::vector<std::size_t>& contact_of, std::vector<SlidingChange>& all) {
  for (Index pair = 0; pair < force.size(); ++pair) {
    SlidingChange& one = all[contact_of[static_cast<std::size_t>(pair)]];
    const double far = std::abs(slip(pair));
    if (force(pair) <= none) continue;
    if (one.pair >= 0 && far * one.edge <= one.slip * edge(pair)) continue;
    one.pair = pair;
    one.slip = far;
    one.edge = edge(pair);
  }
}

/// Finds the contacts of which a row or a gap is another where the bodies have moved to.
/// \param opens  gaps there less the linear ones [length]
void find_moving(const Model& model, const VectorXd& u, const VectorXd& opens,
                 const MovedPairs& there, std::vector<SlidingChange>& all) {
  const NodalRows turn = there.opening - model.pairs.opening;
  const double rounding = gap_rounding(model.pairs) + 16 * epsilon * u.cwiseAbs().maxCoeff();
  for (Index pair = 0; pair < opens.size(); ++pair)
    if (std::abs(opens(pair)) > rounding || turn.row(pair).norm() > 16 * epsilon)
      all[model.contact_of[static_cast<std::size_t>(pair)]].moves = true;
  for (const std::size_t contact : there.fresh_contact) all[contact].moves = true;
}

/// Compares what the contacts do to the nodes with what they would do.
class Comparison {
 public:
  Comparison(const Model& model, const MovedPairs& there, const ContactState& contact,
             const ContactState& now)
      : model_(model),
        there_(there),
        old_(pair_forces(contact)),
        now_(pair_forces(now)),
        status_(now.report.status),
        rows_(below(there.opening, there.fresh)),
        old_pairs_(pairs_of(model.contact_of, model.contacts.size())) {
    std::vector<std::size_t> contact_of = model.contact_of;
    contact_of.insert(contact_of.end(), there.fresh_contact.begin(), there.fresh_contact.end());
    now_pairs_ = pairs_of(contact_of, model.contacts.size());
  }

  void tell(std::size_t contact, SlidingChange& one) const {
    const BodyModel& source = model_.bodies[model_.contact_bodies[contact].source];
    const ContactForces before = some_forces(model_.pairs.opening, old_, old_pairs_[contact]);
    one.lost = there_.lost[contact];
    one.normal = before.normal;
    one.force = resultant(source, before.nodal);
    if (status_ == SolveStatus::Solved) {
      const ContactForces after = some_forces(rows_, now_, now_pairs_[contact]);
      one.new_force = resultant(source, after.nodal);
      compare(before.nodal, after.nodal, after.normal, one);
    } else {
      // Only a proof that nothing balances the loads is a change.
      if (status_ == SolveStatus::Infeasible) one.change = std::numeric_limits<double>::infinity();
      one.elsewhere = 1;
    }
  }

 private:
  static void compare(const NodalForces& before, const NodalForces& after, double new_normal,
                      SlidingChange& one) {
    const double most = std::max(one.normal, new_normal);
    if (most > 0) {
      const double turned = (*one.new_force - one.force).norm();
      one.change = std::max(turned, std::abs(new_normal - one.normal)) / one.normal;
      one.elsewhere = size_of(after - before) / (size_of(before) + size_of(after));
    }
    one.normal = most;
  }

  const Model& model_;
  const MovedPairs& there_;
  PairForces old_;
  PairForces now_;
  SolveStatus status_;
  NodalRows rows_;
  std::vector<std::vector<Index>> old_pairs_, now_pairs_;
};

}  // namespace

std::vector<SlidingChange> sliding_changes(const Model& model, const Condensed& condensed,
                                           const std::function<double()>& none,
                                           const Solution& solution) {
  std::vector<SlidingChange> all(model.contacts.size());
  const VectorXd u = all_displacements(model, solution.displacements);
  const MovedPairs there =
      follow(*model.followed, model, Eigen::Map<const NodeArray>(u.data(), u.size() / 2, 2));
  const VectorXd slip = slips(model, solution.displacements);
  const VectorXd opens = opened(there, model.pairs.opening * u, slip);
  find_moving(model, u, opens, there, all);
  if (std::none_of(all.begin(), all.end(), [](const SlidingChange& one) { return one.moves; }))
    return all;
  const ContactState& contact = solution.contact;
  find_farthest(slip, there.edge, contact.force, none(), model.contact_of, all);
  // A pair that moved by a share of its edge hands on that share of its force to other nodes, which give way otherwise.
  const bool near = there.fresh_gap.size() == 0 &&
                    std::all_of(all.begin(), all.end(), [](const SlidingChange& one) {
                      return one.slip <= noted_change * one.edge;
                    });
  const ContactState now = near ? forces_nearby(model, condensed, u, opens, contact)
                                : forces_there(model, condensed, there, u, opens, contact);
  const Comparison comparison(model, there, contact, now);
  for (const std::size_t k :
       std::set<std::size_t>(model.contact_of.begin(), model.contact_of.end()))
    comparison.tell(k, all[k]);
  return all;
}

}  // namespace signorini
