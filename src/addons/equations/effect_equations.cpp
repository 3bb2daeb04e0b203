// Bonds: equations between displacements, which hold whatever the forces are.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/equations/register.hpp"
#include "addons/equations/take_equations.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/checks.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// What slides along a side stays on it as the meshes have it. \param what  the bond, as messages have it
void check_slides(const Scene& scene, const std::string& what) {
  require_input(!bodies_move(scene), what,
                " slides along sides as the meshes have them, and bodies of this scene move: "
                "let it hold its sides together, make it a contact, or leave out moves and law");
}

/// Displacements that are equal on both sides of a gap leave the gap as it is, and it would have to turn with the bodies.
void check_gap(const Scene& scene, const Bond& bond) {
  require_input(bond.apart == 0 || !any_law(scene), bond.what, ": its sides are up to ", bond.apart,
                " apart, and a body of this scene has a law of finite strain: the gap would keep its direction while bodies "
                "turn. Take closes = true, meshes that match, or quadratic ones along a curve that are closer");
}

/// Equations between displacements hold wherever bodies go. Springs with fixed directions and rigid sides take turns to be small.
void check_turns(const Scene& scene, const std::string& what) {
  require_input(!any_law(scene), what,
                " is made for small turns, and a body of this scene has a law of finite strain: "
                "leave it out, or the law");
}

/// What may not pass a number is a pair of the meshes, and pairs are found anew where bodies have moved to.
void check_stays(const Scene& scene, const Relation& relation, const std::string& what) {
  require_input(relation.holds == Holds::Equal || !bodies_move(scene), what,
                ": at_most and at_least are made for small displacements, and bodies of this scene move: "
                "make it an equation or a contact, or leave out moves and law");
}

const Bond& bond_of(const Equations& all, Index row) {
  for (const Bond& bond : all.bonds)
    if (at(row) < bond.end) return bond;
  return all.bonds.back();
}

/// What messages call an equation.
std::string equation_in_words(const Equations& all, Index row, const Plan& draft) {
  const Index node = all.rows[at(row)].terms.front().first / 2;
  const BodyModel& body = draft.bodies[body_of_node(draft.bodies, node)];
  const Eigen::RowVector2d x = body.mesh.nodes.row(node - body.first_node);
  return text(bond_of(all, row).what, " at ", in_brackets(x), " of '", body.mesh.name, '\'');
}

/// Those that repeat others: supports may say all of an equation, as on a line of symmetry that two bodies share.
void note_repeated(const Equations& all, const NodalRows& free, Plan& draft) {
  std::vector<Index> twice;
  for (const Index row : all.solved.repeated)
    if (NodalRows::InnerIterator(free, row)) twice.push_back(row);
  if (!twice.empty())
    draft.notes.push_back(text(twice.size(), " of ", all.held.size(),
                               twice.size() == 1
                                   ? " equations says what others say, and is left out: "
                                   : " equations say what others say, and are left out; the first: ",
                               equation_in_words(all, twice.front(), draft)));
}

/// Notes bonds without a row that could move: they bear nothing, and nothing else would show it.
void note_held(const Equations& all, const NodalRows& free, Plan& draft) {
  for (const Bond& bond : all.bonds) {
    bool moves = bond.end == bond.first && bond.left_out.empty();
    for (std::size_t k = bond.first; k < bond.end; ++k) moves = moves || NodalRows::InnerIterator(free, static_cast<Index>(k));
    if (!moves) draft.notes.push_back(bond.what + ": supports hold all of its nodes, so that it does nothing");
  }
}

/// Supports that hold a node of a tie and the node of the other side that lies at the same place must move both alike: no force closes
/// what they open.
void check_left_out(const Plan& draft, const Bond& bond, const VectorXd& given, const std::string& when) {
  const auto place_of = [&](Index component) -> Eigen::RowVector2d {
    const BodyModel& body = draft.bodies[body_of_node(draft.bodies, component / 2)];
    return body.mesh.nodes.row(component / 2 - body.first_node);
  };
  const double here = gap_rounding(bond.pairs);
  const double rounding = 64 * epsilon * largest(given);
  for (const Equation& row : bond.left_out)
    for (const auto& [component, value] : row.terms) {
      const double apart = std::abs(given(row.own) - given(component));
      const bool alike = component % 2 == row.own % 2 &&
                         draft.unknowns.number(component / 2, component % 2) < 0 &&
                         (place_of(component) - place_of(row.own)).norm() <= here;
      require_input(!alike || apart <= rounding, bond.what, ": at ", in_brackets(place_of(row.own)),
                    " supports hold both sides, and move them apart by ", apart, when,
                    ". Let them move alike, or hold one side only");
    }
}

/// Solves the equations for unknowns, refuses those that contradict others, and notes those that repeat them. In load steps
/// supports give other displacements at every step, and what is repeated may contradict at some of them.
void solve_rows(const Scene& scene, Plan& draft, Equations& all) {
  std::vector<Index> own;
  for (std::size_t k = 0; k < all.rows.size(); ++k) {
    const Equation& row = all.rows[k];
    own.push_back(row.own < 0 ? -1 : draft.unknowns.number(row.own / 2, row.own % 2));
    if (!row.stiffness) all.held.push_back(static_cast<Index>(k));
  }
  const NodalRows free = free_columns(all.matrix, draft.unknowns);
  bool known = false;
  each_given(scene, draft, all, [&](const NodeArray& held, const VectorXd& right, std::optional<double> time) {
    const std::string when = time ? text(" at time ", *time) : "";
    for (const Bond& bond : all.bonds)
      check_left_out(draft, bond, held.reshaped<Eigen::RowMajor>(), when);
    if (std::exchange(known, true) && all.solved.repeated.empty()) return;
    VectorXd rounding = VectorXd::Constant(free.rows(), 64 * epsilon * held.cwiseAbs().maxCoeff());
    for (Index k = 0; k < rounding.size(); ++k) rounding(k) += all.rows[at(k)].rounding;
    all.solved = eliminate(free, right, rounding, own, all.held);
    const std::vector<Index>& wrong = all.solved.contradicting;
    require_input(wrong.empty(), wrong.size(),
                  wrong.size() == 1 ? " equation contradicts" : " equations contradict", " others or supports",
                  when, ", the first: ",
                  wrong.empty() ? "" : equation_in_words(all, wrong.front(), draft), ", which differs by ", all.solved.apart,
                  " from what ",
                  all.solved.other < 0 ? "supports give" : equation_in_words(all, all.solved.other, draft) + " says",
                  ". Leave out one of those that hold the same displacement");
  });
  note_repeated(all, free, draft);
  note_held(all, free, draft);
}

/// The pairs of contacts that never lift off.
void add_two_sided(const Scene& scene, Plan& draft) {
  const Bonds& bonds = *scene.bonds;
  for (const std::size_t contact : bonds.two_sided) {
    require_input(contact < scene.contacts.size(), "bonds: the scene has no contact number ",
                  contact, ", counted from 0");
    check_slides(scene, text("sliding tie ", draft.contacts[contact]));
    draft.on.push_back(text("sliding tie ", draft.contacts[contact], ": pairs of a contact that never lift off"));
  }
  for (std::size_t pair = 0; pair < draft.contact_of.size(); ++pair)
    if (std::find(bonds.two_sided.begin(), bonds.two_sided.end(), draft.contact_of[pair]) !=
        bonds.two_sided.end())
      draft.two_sided.push_back(static_cast<Index>(pair));
}

/// Tells load steps which histories equations and what drives rigid sides follow.
void follow_histories(const Scene& scene, const Equations& all, Plan& draft) {
  for (const Bond& bond : all.bonds) {
    std::set<std::string> own;
    for (std::size_t k = bond.first; k < bond.end; ++k) own.insert(all.rows[k].history);
    for (const BondLoad& load : bond.loads) own.insert(load.history);
    own.erase("");
    require_input(own.empty() || scene.path, bond.what, " follows the history '", own.empty() ? "" : *own.begin(),
                  "', but the scene has no load steps: give it a `path`, or leave the history out");
    draft.follows.insert(draft.follows.end(), own.begin(), own.end());
  }
}

/// Lets what equations give and what drives rigid sides grow. A bound that a relation may reach stays, as gaps do.
void grow_equations(Scene& scene, const std::string& history) {
  if (!scene.bonds) return;
  Bonds bonds = *scene.bonds;
  for (Relation& relation : bonds.relations)
    if (relation.holds == Holds::Equal) relation.history = history;
  for (RigidSide& rigid : bonds.rigid) rigid.histories = {history, history, history, history, history};
  scene.bonds = std::make_shared<const Bonds>(std::move(bonds));
}

void declare_equations(const Scene& scene, Plan& draft) {
  const auto all = std::make_shared<Equations>();
  for (const Tie& tie : scene.bonds->ties) {
    add_tie(tie, draft, *all);
    if (tie.slides) check_slides(scene, all->bonds.back().what);
    if (tie.stiffness) check_turns(scene, all->bonds.back().what);
    check_gap(scene, all->bonds.back());
  }
  std::size_t number = 0;
  for (const Relation& relation : scene.bonds->relations) {
    add_relation(relation, ++number, draft, *all);
    check_stays(scene, relation, text("relation ", number));
  }
  for (const RigidSide& rigid : scene.bonds->rigid) {
    add_rigid(rigid, draft, *all);
    if (!is_axial(draft.bodies.front())) check_turns(scene, all->bonds.back().what);
  }
  follow_histories(scene, *all, draft);
  all->matrix = matrix_of(all->rows, 2 * count_nodes(draft.bodies));
  solve_rows(scene, draft, *all);
  add_two_sided(scene, draft);
  leave_out_given_pairs(scene, *all, draft);
  draft.modes = motions_left(std::move(draft.modes), free_columns(all->matrix, draft.unknowns),
                             all->solved);
  draft.equations = all;
  draft.finish = take_equations;
}

/// Pairs of relations may be all that there are. Else the effect contact has taken all pairs, and has left a matrix without rows.
void add_equations(Model& model) {
  if (model.gaps.A.rows() > 0) take_gaps(model);
  check_springs(model);
}

}  // namespace

void register_equations() {
  add_effect({"equations",
              [](const Scene& scene, const Plan& /*draft*/) {
                const Bonds* const bonds = scene.bonds.get();
                return bonds != nullptr && !(bonds->ties.empty() && bonds->two_sided.empty() &&
                                             bonds->relations.empty() && bonds->rigid.empty());
              },
              declare_equations, add_equations, false, grow_equations},
             "rigid motions");
  set_solve_around(solve_two_sided);
  add_check({"equations", nullptr, nullptr, nullptr, nullptr, check_bonds});
}

}  // namespace signorini
