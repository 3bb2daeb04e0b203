// Friction and cohesion: two effects that share the slip rows.
#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini::effect {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// One of the two numbers of the law.
using Constant = double Friction::*;

double value(const ContactSpec& contact, Constant constant) {
  return contact.friction ? (*contact.friction).*constant : 0;
}

bool any_has(const Scene& scene, Constant constant) {
  return std::any_of(scene.contacts.begin(), scene.contacts.end(),
                     [=](const ContactSpec& contact) { return value(contact, constant) != 0; });
}

/// Whether supports leave a pair free to slide: friction between two supports could be anything, so it is none
/// and all of it counts as theirs.
bool can_slide(const Gaps& gaps, Index pair) {
  return gaps.initial_slip(pair) != 0 || gaps.T.row(pair).norm() > 0;
}

/// Whether a pair is that of a node on a line of symmetry which a side crosses squarely, but for what its own half of the
/// mesh makes of the normal: there sliding to one side is sliding to the other, so there is none.
bool on_line_of_symmetry(const Scene& scene, const Plan& draft, Index pair) {
  constexpr double least_corner =
      pi / 8;  // a side and its image that turn by more meet in a corner
  const Index node = draft.gaps.pairs.node[static_cast<std::size_t>(pair)];
  if (node < 0) return false;
  const std::size_t b = body_of_node(draft.bodies, node);
  const BodyModel& body = draft.bodies[b];
  const Index own = node - body.first_node;
  const Eigen::Vector2d normal = draft.gaps.pairs.normal.row(pair).transpose().normalized();
  const auto& supports = scene.bodies[b].supports;
  return std::any_of(supports.begin(), supports.end(), [&](const Support& support) {
    if (!support.normal_only) return false;
    const std::vector<Index> line = boundary_nodes(body.mesh, support.boundary);
    if (std::find(line.begin(), line.end(), own) == line.end()) return false;
    const Index across = body.unknowns.number(own, 0) < 0 ? 0 : 1;
    return std::abs(normal(across)) < std::sin(least_corner);
  });
}

/// Notes contacts whose friction acts on no pair.
void note_idle_friction(const Scene& scene, Plan& draft) {
  std::vector<bool> has_pairs(scene.contacts.size()), slides(scene.contacts.size());
  for (const std::size_t contact : draft.contact_of) has_pairs[contact] = true;
  for (const Index pair : draft.law.pair)
    slides[draft.contact_of[static_cast<std::size_t>(pair)]] = true;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k)
    if (has_friction(scene.contacts[k]) && has_pairs[k] && !slides[k])
      draft.notes.push_back(describe(draft.bodies, scene.contacts[k]) +
                            ": friction does nothing, because supports hold every pair along the "
                            "tangent");
}

/// What the laws of the contacts make of their two numbers, for every frictional pair.
void take_bounds(const Scene& scene, Plan& draft) {
  FrictionLaw& law = draft.law;
  law.coefficient = law.cohesion = VectorXd::Zero(static_cast<Index>(law.pair.size()));
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    const ContactSpec& contact = scene.contacts[c];
    if (!has_friction(contact)) continue;
    try {
      const FrictionLawMember& member = find_friction_law(contact.friction->law);
      for (Index k = 0; k < law.coefficient.size(); ++k) {
        const Index pair = law.pair[static_cast<std::size_t>(k)];
        if (draft.contact_of[static_cast<std::size_t>(pair)] != c) continue;
        const FrictionBound bound = member.bound(*contact.friction, draft.gaps.pairs.weight(pair));
        law.coefficient(k) = bound.slope;
        law.cohesion(k) = bound.offset;
      }
    } catch (const ProblemError& error) {
      throw ProblemError(
          text("friction of the ", describe(draft.bodies, contact), ": ", error.what()));
    }
  }
}

/// Slips that friction and cohesion share: of the pairs that can slide and whose own contact has friction.
void take_slips(const Scene& scene, Plan& draft) {
  FrictionLaw& law = draft.law;
  if (!law.pair.empty()) return;
  for (std::size_t pair = 0; pair < draft.contact_of.size(); ++pair)
    if (has_friction(scene.contacts[draft.contact_of[pair]]) &&
        can_slide(draft.gaps, static_cast<Index>(pair)) &&
        !on_line_of_symmetry(scene, draft, static_cast<Index>(pair)))
      law.pair.push_back(static_cast<Index>(pair));
  if (law.pair.empty()) return;
  require_input(scene.solver.friction != Takes::No, "solver '", scene.solver.name,
                "' takes no friction: take the default, '", Scene().solver.name, "'");
  take_bounds(scene, draft);
  draft.on.push_back(text("slips of ", law.pair.size(), " pairs"));
}

/// What is said of a law that is not the usual one.
std::string law_in_words(const Friction& friction) {
  if (friction.law == Friction().law) return "";
  return text(", law '", friction.law, "': ", find_friction_law(friction.law).summary);
}

/// Says what a constant is in every contact.
void declare_law(const Scene& scene, Plan& draft, Constant constant, const std::string& name) {
  for (const ContactSpec& contact : scene.contacts) {
    const double given = value(contact, constant);
    const std::string what = text(name, " of the ", describe(draft.bodies, contact));
    require_input(std::isfinite(given) && given >= 0, what, " must be a number >= 0, got ", given);
    if (given > 0) draft.on.push_back(text(what, ": ", given, law_in_words(*contact.friction)));
  }
  take_slips(scene, draft);
}

/// Friction and cohesion share the rows: the first of the two adds them.
void add_slips(Model& model) {
  VectorXd& g = model.programme.initial_gap;
  if (model.law.pair.empty() || g.size() > model.pairs.weight.size()) return;
  model.programme.A = below(model.programme.A, -selected_rows(model.gaps.T, model.law.pair));
  g.conservativeResize(model.programme.A.rows());
  g.tail(model.law.coefficient.size()) = model.gaps.initial_slip(model.law.pair);
}

}  // namespace

Effect friction() {
  return {"friction",
          [](const Scene& scene, const Plan& /*draft*/) {
            return any_has(scene, &Friction::coefficient);
          },
          [](const Scene& scene, Plan& draft) {
            declare_law(scene, draft, &Friction::coefficient, "friction coefficient");
            note_idle_friction(scene, draft);
          },
          add_slips};
}

Effect cohesion() {
  return {
      "cohesion",
      [](const Scene& scene, const Plan& /*draft*/) { return any_has(scene, &Friction::cohesion); },
      [](const Scene& scene, Plan& draft) {
        declare_law(scene, draft, &Friction::cohesion, "cohesion");
        if (!any_has(scene, &Friction::coefficient)) note_idle_friction(scene, draft);
      },
      add_slips};
}

}  // namespace signorini::effect
