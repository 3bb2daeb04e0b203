// # Contact as an effect
//
// Contact adds one row to A and one number to g per pair that can open or close. The way of
// a pair has four stations. The operator finds it in the meshes. Fits may change its gap, as
// in a press fit. Supports take the held columns out of its row. Then it is stacked below
// the pairs of the contacts before it.
//
// For example, a node above the middle of a side with two nodes, all free along y, at the
// distance 1:
// \f[ N = (1, -\tfrac12, -\tfrac12), \qquad A = -N, \qquad g = 1. \f]
// If the side is held and moves up by 0.2, its columns disappear and
// \f$ g = 1 - 0.2 = 0.8 \f$.
//
// The order matters. A fit speaks of lengths in the meshes, so it comes before supports that
// move. And a contact whose normal points the wrong way is refused before a fit can hide it.

#include <algorithm>
#include <memory>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/checks.hpp"
#include "signorini/scene/contact_input.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/pair_up.hpp"

namespace signorini::effect {
namespace {

using Eigen::Index;

// A scene may choose a number of Gauss points for an operator that has none. That is
// harmless, and mostly a sign that the user expects something else. So it is noted. The
// operator is looked up, needed or not, so that a wrong name is an error beside a rigid
// obstacle, too, in all programs that have operators.
void check_choices(const ContactSpec& contact, Plan& draft) {
  const ContactSpec usual;
  const bool rigid = std::holds_alternative<Obstacle>(contact.target);
  GapOperator gap_operator = {};
  if (!rigid || !gap_operators().empty()) gap_operator = find_gap_operator(contact.gap_operator);
  std::string idle = rigid && contact.gap_operator != usual.gap_operator ? ", gap_operator" : "";
  if (contact.points != usual.points && (rigid || !gap_operator.takes_points)) idle += ", points";
  if (contact.quadrature != usual.quadrature && (rigid || !gap_operator.takes_quadrature))
    idle += ", quadrature";
  if (!idle.empty())
    draft.notes.push_back(text(describe(draft.bodies, contact), ": without meaning for ",
                               rigid ? "a rigid obstacle" : contact.gap_operator, ": ",
                               idle.substr(2)));
}

// Whether the gap of a contact is linear in the displacements, as above a half-plane. Then
// its pairs need not be found again after a solution.
bool stays_linear(const ContactSpec& contact) {
  const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target);
  return obstacle != nullptr && obstacle->linear;
}

// Numbers in the place of names, for all later steps. A rigid obstacle is no body: forces on
// it are not added up.
ContactBodies bodies_of(const ContactSpec& contact, const std::vector<BodyModel>& bodies) {
  const Side* target = std::get_if<Side>(&contact.target);
  return {body_index(bodies, contact.source),
          target != nullptr ? std::optional(body_index(bodies, *target)) : std::nullopt};
}

// What is asked of the input, once. In load steps pairs may be found again where the bodies have moved to;
// then nothing is new in what the user wrote.
void check_contacts(const Scene& scene, Plan& draft) {
  for (const ContactSpec& contact : scene.contacts) check_choices(contact, draft);
  check_listed_once(scene, draft.bodies);
}

void check_pairs(const ContactSpec& contact, const Pairs& found, Plan& draft) {
  check_obstacle_side(contact, draft.bodies, found);
  ask_checks(draft.notes, &Check::contact, contact, draft.bodies, found);
}

// A pair that supports hold on both sides and that overlaps cannot be mended by any contact force.
// Rounding of positions is no overlap: two sides that touch may seem to overlap in the last digits.
//
// In load steps supports move as their histories say, so this is asked of the end of every step.
// An example: a side is held at y = -0.05 times a history that rises to 2 and falls to 0.5 again.
// It stands at -0.025 in the end, and a floor at -0.07 is passed at the first step.
//
// Where bodies move, gaps depend on the way; there it is asked of the places that they come to.
void check_dropped(const Scene& scene, const ContactSpec& contact, const Pairs& found,
                   const std::vector<Index>& dropped, const Plan& draft) {
  const bool moving = draft.standing != nullptr;
  if (dropped.empty() || (bodies_move(scene) && !moving)) return;
  each_given(scene, draft, [&](const NodeArray& held, std::optional<double> time) {
    Eigen::VectorXd gaps = found.initial_gap;
    if (!moving) gaps += found.opening * held.reshaped<Eigen::RowMajor>();
    for (const Index pair : dropped) {
      const Eigen::Vector2d x = found.position.row(pair).transpose();
      const double gap = gaps(pair) + interference_to_come(scene, contact, x, time);
      require_input(gap >= -gap_rounding(found), describe(draft.bodies, contact),
                    ": the pair at (", x.x(), ", ", x.y(),
                    ") is held by supports and overlaps by ", -gap, time ? text(" at time ", *time) : "",
                    ". Move one of the two sides or release the node");
    }
  });
}

// One contact after the other is paired, checked, fitted, reduced and stacked, and says what it
// found in a line of the plan. Then the pairs have their numbers for good.
//
// Slips are asked of all contacts if one has friction, so that the matrices of the contacts
// fit below each other. A pair that supports hold on both sides is dropped by reduce(): no
// force can act between two supports. If a contact loses all pairs in this way, the user
// gets a note. `follow` keeps the gaps of the meshes, with which gaps in moved bodies will
// be compared.
void declare_contact(const Scene& scene, Plan& draft) {
  const Standing* const standing = draft.standing.get();
  if (standing == nullptr) check_contacts(scene, draft);
  draft.contacts = contact_names(draft.bodies, scene.contacts);
  const bool sliding = std::any_of(scene.contacts.begin(), scene.contacts.end(), has_friction);
  const double directions = direction_rounding(draft.bodies);
  std::vector<FollowedContact> followed;
  std::vector<Gaps> all = {draft.gaps};
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    const ContactSpec& contact = scene.contacts[k];
    const std::string what = describe(draft.bodies, contact);
    Pairs found = pair_up(contact, draft.bodies, sliding, standing);
    const Eigen::VectorXd gap = found.initial_gap;
    if (standing == nullptr) check_pairs(contact, found, draft);
    std::string fitted;
    for (const FitSides& fit : draft.fits) fitted += fit(contact, found);
    Gaps gaps = reduce(found, surface(draft.bodies, contact.source), draft.unknowns, directions);
    check_dropped(scene, contact, found, gaps.dropped, draft);
    const std::size_t pairs = gaps.pairs.node.size();
    const bool rigid = std::holds_alternative<Obstacle>(contact.target);
    draft.on.push_back(
        text(what, ": ", pairs, " candidate pairs",
             rigid ? ", no mesh and no search for the obstacle" : " by " + contact.gap_operator,
             fitted));
    if (pairs == 0)
      draft.notes.push_back(what +
                            ": no pair can open or close, supports hold both sides everywhere");
    followed.push_back({contact, gap(gaps.kept)});
    all.push_back(std::move(gaps));
    draft.small_sliding.push_back(contact.small_sliding);
    draft.contact_of.resize(draft.contact_of.size() + pairs, k);
    draft.contact_bodies.push_back(bodies_of(contact, draft.bodies));
  }
  draft.gaps = stacked(std::move(all));
  if (!std::all_of(scene.contacts.begin(), scene.contacts.end(), stays_linear))
    draft.followed = std::make_shared<const std::vector<FollowedContact>>(std::move(followed));
}

// Number of pairs that overlap by more than rounding. It is counted after all contacts are
// stacked, so that one line of the plan speaks of all of them. Meshes that touch have gaps like
// \f$ -10^{-17} \f$. These are no overlaps, and must not switch an effect on.
Index overlapping(const Plan& plan) {
  return (plan.gaps.pairs.initial_gap.array() < -gap_rounding(plan.gaps.pairs)).count();
}

// Notes the largest overlap that no interference asks for. An overlap in the meshes loads
// the bodies like a press fit, and is often a mistake of the meshing. Displacements that are given are none of the meshes.
void note_overlap(const Scene& scene, Plan& draft) {
  const Pairs& pairs = draft.gaps.pairs;
  const NodeArray& held = draft.unknowns.held;
  const Eigen::VectorXd gaps = pairs.initial_gap - pairs.opening * held.reshaped<Eigen::RowMajor>();
  double least = -gap_rounding(pairs);
  const ContactSpec* deepest = nullptr;
  for (std::size_t pair = 0; pair < draft.contact_of.size(); ++pair) {
    const ContactSpec& contact = scene.contacts[draft.contact_of[pair]];
    const double gap = gaps(static_cast<Index>(pair));
    if (gap >= least || contact.interference.value_or(0) != 0) continue;
    least = gap;
    deepest = &contact;
  }
  if (deepest != nullptr)
    draft.notes.push_back(text(describe(draft.bodies, *deepest), ": the two sides overlap by ",
                               -least, " before loading"));
}

}  // namespace

// Nothing is left to compute: the numbers of the plan are moved.
Effect contact() {
  return {"contact",
          [](const Scene& scene, const Plan& /*draft*/) { return !scene.contacts.empty(); },
          declare_contact, take_gaps, true};
}

// An overlap is an effect with nothing to add: g is negative there. But it loads the bodies,
// so the plan tells it. In the example, a node that begins 0.1 below the side has
// \f$ g = -0.1 \f$. It is pressed out by that much before any load acts.
Effect initial_overlap() {
  return {"initial overlap",
          [](const Scene& /*scene*/, const Plan& draft) { return overlapping(draft) > 0; },
          [](const Scene& scene, Plan& draft) {
            draft.on.push_back(text("initial overlap of ", overlapping(draft), " pairs"));
            note_overlap(scene, draft);
          },
          nullptr};
}

}  // namespace signorini::effect
