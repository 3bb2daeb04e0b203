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

/// Notes choices of a contact that nothing asks for. Looks up its gap operator, needed or not.
void check_choices(const ContactSpec& contact, Plan& draft) {
  const ContactSpec usual;
  const GapOperator& gap_operator = find_gap_operator(contact.gap_operator);
  const bool rigid = std::holds_alternative<Obstacle>(contact.target);
  std::string idle = rigid && contact.gap_operator != usual.gap_operator ? ", gap_operator" : "";
  if (contact.points != usual.points && (rigid || !gap_operator.takes_points)) idle += ", points";
  if (contact.quadrature != usual.quadrature && (rigid || !gap_operator.takes_quadrature))
    idle += ", quadrature";
  if (!idle.empty())
    draft.notes.push_back(text(describe(draft.bodies, contact), ": without meaning for ",
                               rigid ? "a rigid obstacle" : contact.gap_operator, ": ",
                               idle.substr(2)));
}

/// Whether its pairs are the same wherever the body slides.
bool stays_linear(const ContactSpec& contact) {
  const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target);
  return obstacle != nullptr && obstacle->linear;
}

ContactBodies bodies_of(const ContactSpec& contact, const std::vector<BodyModel>& bodies) {
  const Side* target = std::get_if<Side>(&contact.target);
  return {body_index(bodies, contact.source),
          target != nullptr ? std::optional(body_index(bodies, *target)) : std::nullopt};
}

void declare_contact(const Scene& scene, Plan& draft) {
  for (const ContactSpec& contact : scene.contacts) check_choices(contact, draft);
  check_listed_once(scene, draft.bodies);
  draft.contacts = contact_names(draft.bodies, scene.contacts);
  const bool sliding = std::any_of(scene.contacts.begin(), scene.contacts.end(), has_friction);
  const double directions = direction_rounding(draft.bodies);
  std::vector<FollowedContact> followed;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    const ContactSpec& contact = scene.contacts[k];
    const std::string what = describe(draft.bodies, contact);
    Pairs found = pair_up(contact, draft.bodies, sliding);
    const Eigen::VectorXd gap = found.initial_gap;
    check_obstacle_side(contact, draft.bodies, found);
    ask_checks(draft.notes, &Check::contact, contact, draft.bodies, found);
    std::string fitted;
    for (const FitSides fit : draft.fits) fitted += fit(contact, found);
    const Gaps gaps =
        reduce(found, surface(draft.bodies, contact.source), draft.unknowns, what, directions);
    const std::size_t pairs = gaps.pairs.node.size();
    const bool rigid = std::holds_alternative<Obstacle>(contact.target);
    draft.on.push_back(
        text(what, ": ", pairs, " candidate pairs",
             rigid ? ", no mesh and no search for the obstacle" : " by " + contact.gap_operator,
             fitted));
    if (pairs == 0)
      draft.notes.push_back(what +
                            ": no pair can open or close, supports hold both sides everywhere");
    draft.gaps = stacked(draft.gaps, gaps);
    followed.push_back({contact, gap(gaps.kept)});
    draft.small_sliding.push_back(contact.small_sliding);
    draft.contact_of.resize(draft.contact_of.size() + pairs, k);
    draft.contact_bodies.push_back(bodies_of(contact, draft.bodies));
  }
  if (!std::all_of(scene.contacts.begin(), scene.contacts.end(), stays_linear))
    draft.followed = std::make_shared<const std::vector<FollowedContact>>(std::move(followed));
}

/// Number of pairs that overlap by more than rounding.
Index overlapping(const Plan& plan) {
  return (plan.gaps.pairs.initial_gap.array() < -gap_rounding(plan.gaps.pairs)).count();
}

/// Notes the largest overlap that no interference asks for.
void note_overlap(const Scene& scene, Plan& draft) {
  double least = -gap_rounding(draft.gaps.pairs);
  const ContactSpec* deepest = nullptr;
  for (std::size_t pair = 0; pair < draft.contact_of.size(); ++pair) {
    const ContactSpec& contact = scene.contacts[draft.contact_of[pair]];
    const double gap = draft.gaps.pairs.initial_gap(static_cast<Index>(pair));
    if (gap >= least || contact.interference.value_or(0) != 0) continue;
    least = gap;
    deepest = &contact;
  }
  if (deepest != nullptr)
    draft.notes.push_back(text(describe(draft.bodies, *deepest), ": the two sides overlap by ",
                               -least, " before loading"));
}

}  // namespace

Effect contact() {
  return {"contact",
          [](const Scene& scene, const Plan& /*draft*/) { return !scene.contacts.empty(); },
          declare_contact,
          [](Model& model) {
            model.programme.A.swap(model.gaps.A);
            model.programme.initial_gap = model.gaps.pairs.initial_gap;
            model.pairs = std::move(model.gaps.pairs);
          }};
}

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
