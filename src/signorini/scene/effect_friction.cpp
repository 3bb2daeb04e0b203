// # Friction and cohesion as effects
//
// Friction gives a closed pair a second row, for its slip, and a second force \f$ \tau \f$
// along the tangent, within
// \f[ |\tau| \le \mu\lambda + c\,w, \f]
// with the weight w of the pair. With \f$ \mu = 0.3 \f$, \f$ \lambda = 10 \f$, \f$ c = 2 \f$
// and \f$ w = 0.5 \f$ the pair holds up to 4. The slip is \f$ s_0 + Tu \f$ and stands in A
// as \f$ -T \f$, below all gaps.
//
// Friction and cohesion are two effects, because a scene may have either one alone, and the
// plan tells each. They share the rows: the first that is present makes them, the second
// finds them there.
//
// Most of this file decides which pairs get no slip row. A row that nothing can move would
// let its force be anything.

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini::effect {
namespace {

using Eigen::Index, Eigen::VectorXd;

// One of the two numbers of the law. What the effects do with it is the same for both, so it
// is an argument.
using Constant = double Friction::*;

double value(const ContactSpec& contact, Constant constant) {
  return contact.friction ? (*contact.friction).*constant : 0;
}

// A contact without friction has zeros, and zeros are no effect. So a scene with a
// coefficient of 0 has the same unknowns as one without friction.
bool any_has(const Scene& scene, Constant constant) {
  return std::any_of(scene.contacts.begin(), scene.contacts.end(),
                     [=](const ContactSpec& contact) { return value(contact, constant) != 0; });
}

// Whether supports leave a pair free to slide, or make it slide in some load step. Friction
// between two supports could be anything. So it is taken for none, and all of the force counts
// as theirs.
//
// Where bodies have moved to, rows must not come and go with supports that stop and start.
//
// Two sides of which one is dragged by one history and the other one by another may stand still
// against each other where both are 1, and slide before and behind. So slips are looked at in all
// steps.
std::vector<char> can_slide(const Scene& scene, const Plan& draft) {
  const NodalRows& rows = draft.gaps.pairs.sliding;
  std::vector<char> slides;
  for (Index pair = 0; pair < rows.rows(); ++pair)
    slides.push_back(draft.standing ? rows.row(pair).nonZeros() > 0
                                    : draft.gaps.T.row(pair).norm() > 0);
  if (draft.standing || std::count(slides.begin(), slides.end(), 0) == 0) return slides;
  const double rounding = 16 * std::max(epsilon, direction_rounding(draft.bodies));
  each_given(scene, draft, [&](const NodeArray& held, std::optional<double> /*time*/) {
    const VectorXd given = held.reshaped<Eigen::RowMajor>();
    const VectorXd slip = rows * given;
    const double least = rounding * largest(rows.cwiseAbs() * given.cwiseAbs());
    for (Index pair = 0; pair < slip.size(); ++pair)
      if (std::abs(slip(pair)) > least) slides[at(pair)] = 1;
  });
  return slides;
}

// Whether the node of a pair is on a line of symmetry that its side crosses at a right
// angle. There it cannot slide: sliding to one side would be sliding to the other. But the
// mesh is one half, and the normal of a node is the mean of the sides of this half alone.
// Sides that turn by 10 degrees each tilt it by 5, so that its tangent has a small free
// component. Such a slip is an error of the mesh and gets no row. At more than 22.5 degrees
// the side and its image meet in a corner, and the slip is real. The axis of a body of revolution
// is such a line.
bool on_line_of_symmetry(const Scene& scene, const Plan& draft, Index pair) {
  constexpr double least_corner =
      pi / 8;  // a side and its image that turn by more meet in a corner
  const Index node = draft.gaps.pairs.node[at(pair)];
  if (node < 0) return false;
  const std::size_t b = body_of_node(draft.bodies, node);
  const BodyModel& body = draft.bodies[b];
  const Index own = node - body.first_node;
  const Eigen::Vector2d normal = draft.gaps.pairs.normal.row(pair).transpose().normalized();
  const auto crosses = [&](Index axis) { return std::abs(normal(axis)) < std::sin(least_corner); };
  const auto& x = body.mesh.nodes.col(0);
  if (is_axial(body) && crosses(0) && x(own) <= 1e3 * epsilon * x.maxCoeff()) return true;
  const auto& supports = scene.bodies[b].supports;
  return std::any_of(supports.begin(), supports.end(), [&](const Support& support) {
    if (!support.normal_only) return false;
    const std::vector<Index> line = boundary_nodes(body.mesh, support.boundary);
    return std::find(line.begin(), line.end(), own) != line.end() &&
           crosses(body.unknowns.number(own, 0) < 0 ? 0 : 1);
  });
}

// Notes contacts whose friction acts on no pair. It is no error, but the user may believe
// that friction was computed. A contact that has no pairs at all has a note of its own.
void note_idle_friction(const Scene& scene, Plan& draft) {
  std::vector<bool> has_pairs(scene.contacts.size()), slides(scene.contacts.size());
  for (const std::size_t contact : draft.contact_of) has_pairs[contact] = true;
  for (const Index pair : draft.law.pair) slides[draft.contact_of[at(pair)]] = true;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k)
    if (has_friction(scene.contacts[k]) && has_pairs[k] && !slides[k])
      draft.notes.push_back(describe(draft.bodies, scene.contacts[k]) +
                            ": friction does nothing, because supports hold every pair along the "
                            "tangent");
}

// The law of each contact makes a slope and an offset of its two numbers and the weight of
// the pair. Cohesion is a force per area, so only here, where weights are known, it becomes
// a force.
void take_bounds(const Scene& scene, Plan& draft) {
  FrictionLaw& law = draft.law;
  law.coefficient = law.cohesion = VectorXd::Zero(static_cast<Index>(law.pair.size()));
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    const ContactSpec& contact = scene.contacts[c];
    if (!has_friction(contact)) continue;
    try {
      const FrictionLawMember& member = find_friction_law(contact.friction->law);
      for (Index k = 0; k < law.coefficient.size(); ++k) {
        const Index pair = law.pair[at(k)];
        if (draft.contact_of[at(pair)] != c) continue;
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

// Slips that friction and cohesion share: of the pairs that can slide and whose own contact
// has friction. A solver that takes no friction is refused here, before anything is
// assembled.
void take_slips(const Scene& scene, Plan& draft) {
  FrictionLaw& law = draft.law;
  if (!law.pair.empty()) return;
  const std::vector<char> slides = can_slide(scene, draft);
  for (std::size_t pair = 0; pair < draft.contact_of.size(); ++pair)
    if (has_friction(scene.contacts[draft.contact_of[pair]]) && slides[pair] &&
        !on_line_of_symmetry(scene, draft, static_cast<Index>(pair)))
      law.pair.push_back(static_cast<Index>(pair));
  if (law.pair.empty()) return;
  require_input(scene.solver.friction != Takes::No, "solver '", scene.solver.name,
                "' takes no friction: take the default, '", Scene().solver.name, "'");
  take_bounds(scene, draft);
  draft.on.push_back(text("slips of ", law.pair.size(), " pairs"));
}

// The usual law needs no words. Any other one is named in the plan, with its summary from
// the table of laws.
std::string law_in_words(const Friction& friction) {
  if (friction.law == Friction().law) return "";
  return text(", law '", friction.law, "': ", find_friction_law(friction.law).summary);
}

// Every contact has its own constants, and the plan has a line for each. A negative
// coefficient would drive the sliding instead of slowing it.
void declare_law(const Scene& scene, Plan& draft, Constant constant, const std::string& name) {
  for (const ContactSpec& contact : scene.contacts) {
    const double given = value(contact, constant);
    const std::string what = text(name, " of the ", describe(draft.bodies, contact));
    require_input(std::isfinite(given) && given >= 0, what, " must be a number >= 0, got ", given);
    if (given > 0) draft.on.push_back(text(what, ": ", given, law_in_words(*contact.friction)));
  }
  take_slips(scene, draft);
}

// The first of the two effects adds the rows. The second sees that g is longer than the list
// of pairs, and returns. The minus sign makes a slip of what every row of A gives,
// \f$ g - Au \f$.
void add_slips(Model& model) {
  VectorXd& g = model.programme.initial_gap;
  if (model.law.pair.empty() || g.size() > model.pairs.weight.size()) return;
  model.programme.A = below(model.programme.A, -selected_rows(model.gaps.T, model.law.pair));
  g.conservativeResize(model.programme.A.rows());
  g.tail(model.law.coefficient.size()) = model.gaps.initial_slip(model.law.pair);
}

}  // namespace

// Both effects end with the note on idle friction. It must be written once, so cohesion
// writes it only if no contact has a coefficient.
Effect friction() {
  return {"friction",
          [](const Scene& scene, const Plan& /*draft*/) {
            return any_has(scene, &Friction::coefficient);
          },
          [](const Scene& scene, Plan& draft) {
            declare_law(scene, draft, &Friction::coefficient, "friction coefficient");
            note_idle_friction(scene, draft);
          },
          add_slips, true};
}

Effect cohesion() {
  return {
      "cohesion",
      [](const Scene& scene, const Plan& /*draft*/) { return any_has(scene, &Friction::cohesion); },
      [](const Scene& scene, Plan& draft) {
        declare_law(scene, draft, &Friction::cohesion, "cohesion");
        if (!any_has(scene, &Friction::coefficient)) note_idle_friction(scene, draft);
      },
      add_slips, true};
}

}  // namespace signorini::effect
