// Linear relations between displacements, with = or up to a number, and sides that move as rigid bodies.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/places.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// A term with its nodes among those of all bodies.
struct Placed {
  const RelationTerm* term;
  std::vector<Index> nodes;
};

Vector2d place_of(const Plan& draft, Index node) {
  const BodyModel& body = draft.bodies[body_of_node(draft.bodies, node)];
  return body.mesh.nodes.row(node - body.first_node).transpose();
}

std::string side_in_words(const Side& side) { return text('\'', side.boundary, "' of '", side.body, '\''); }

std::vector<Index> nodes_of(const Side& side, const std::optional<Vector2d>& only_at,
                            const Plan& draft) {
  const BodyModel& body = draft.bodies[body_index(draft.bodies, side)];
  std::vector<Index> nodes = nodes_at(body.mesh, side.boundary, only_at, "relation");
  for (Index& node : nodes) node += body.first_node;
  return nodes;
}

/// Puts the nodes of whole sides into the order along the first of them, and refuses sides that a shift does not take there.
void match(const std::string& what, std::vector<Placed>& all, const Plan& draft) {
  const auto whole = [](const Placed& one) { return !one.term->only_at; };
  const auto first = std::find_if(all.begin(), all.end(), whole);
  if (first == all.end()) return;
  const Vector2d along = place_of(draft, first->nodes.back()) - place_of(draft, first->nodes.front());
  for (Placed& one : all)
    if (whole(one))
      std::stable_sort(one.nodes.begin(), one.nodes.end(), [&](Index a, Index b) {
        return along.dot(place_of(draft, a) - place_of(draft, b)) < 0;
      });
  for (const Placed& one : all) {
    if (!whole(one)) continue;
    require_input(one.nodes.size() == first->nodes.size(), what, ": ", side_in_words(one.term->side), " has ",
                  one.nodes.size(), " nodes and ", side_in_words(first->term->side), " has ",
                  first->nodes.size(), ": a relation takes one node of each; a [[tie]] takes any mesh");
    const Vector2d shift = place_of(draft, one.nodes.front()) - place_of(draft, first->nodes.front());
    for (std::size_t k = 0; k < one.nodes.size(); ++k) {
      const Vector2d off = place_of(draft, one.nodes[k]) - place_of(draft, first->nodes[k]) - shift;
      require_input(off.norm() <= 1e-6 * along.norm(), what, ": the node of ",
                    side_in_words(one.term->side), " at ", in_brackets(place_of(draft, one.nodes[k])),
                    " has no partner on ", side_in_words(first->term->side), ", it is ", off.norm(),
                    " off: a shift must take the nodes of one side to those of the other");
    }
  }
}

void add_to(std::map<Index, double>& terms, Index node, const Vector2d& along) {
  for (const int axis : {0, 1})
    if (along(axis) != 0) terms[2 * node + axis] += along(axis);
}

Equation equation_of(const std::map<Index, double>& terms, double right) {
  Equation row;
  row.terms.assign(terms.begin(), terms.end());
  row.right = right;
  row.rounding = 64 * epsilon * std::abs(right);
  return row;
}

void check_relation(const Relation& relation, const std::string& what) {
  require_input(!relation.terms.empty(), what, ": it needs one term or more");
  require_input(std::isfinite(relation.right), what, ": right must be finite, got ", relation.right);
  for (const RelationTerm& term : relation.terms)
    require_input(term.along.allFinite() && std::isfinite(term.times) &&
                      (term.times * term.along).norm() > 0,
                  what, ": a term must have a direction and a factor that are not 0, got ",
                  in_brackets(term.along), " times ", term.times);
  const double stiffness = relation.stiffness.value_or(1);
  require_input(std::isfinite(stiffness) && stiffness > 0, what,
                ": a stiffness must be a number > 0, got ", stiffness);
  require_input(!relation.stiffness || relation.holds == Holds::Equal, what, ": stiffness = ", stiffness,
                " is of a spring that pulls and presses, and at_most and at_least let go: leave stiffness out, "
                "or write right in their place");
  require_input(relation.history.empty() || relation.holds == Holds::Equal, what, ": it follows the history '",
                relation.history, "', and a bound that at_most or at_least gives stays where it is: leave the history "
                "out, or make the bound a contact whose interference follows it");
}

/// How a rigid side moves, by the displacements of two of its nodes: those of the first, and that of the second across the line
/// between them.
class RigidMotion {
 public:
  RigidMotion(const std::vector<Index>& nodes, const Plan& draft)
      : draft_(draft), first_(nodes.front()), second_(nodes.front()) {
    for (const Index node : nodes)
      if ((place_of(draft, node) - origin()).norm() > line().norm()) second_ = node;
  }

  [[nodiscard]] Index first() const { return first_; }
  [[nodiscard]] Index second() const { return second_; }
  [[nodiscard]] Vector2d line() const { return place_of(draft_, second_) - origin(); }

  /// Adds a shift of a point in a direction, times a factor. \param place  of the point
  void add_shift(const Vector2d& place, const Vector2d& along, double factor,
                 std::map<Index, double>& terms) const {
    add_to(terms, first_, factor * along);
    const Vector2d arm = place - origin();
    add_turn(factor * along.dot(Vector2d(-arm.y(), arm.x())), terms);
  }

  /// Adds the turn, times a factor.
  void add_turn(double factor, std::map<Index, double>& terms) const {
    const Vector2d across = Vector2d(-line().y(), line().x()) / line().squaredNorm();
    add_to(terms, second_, factor * across);
    add_to(terms, first_, -factor * across);
  }

 private:
  [[nodiscard]] Vector2d origin() const { return place_of(draft_, first_); }

  const Plan& draft_;
  Index first_;
  Index second_;
};

/// The rows that make the nodes of a side one rigid body.
void add_rigid_rows(const std::vector<Index>& nodes, const RigidMotion& motion, const Plan& draft,
                    std::vector<Equation>& rows) {
  for (const Index node : nodes) {
    if (node == motion.first() || node == motion.second()) continue;
    for (const int axis : {0, 1}) {
      std::map<Index, double> terms;
      add_to(terms, node, Vector2d::Unit(axis));
      motion.add_shift(place_of(draft, node), Vector2d::Unit(axis), -1, terms);
      rows.push_back(equation_of(terms, 0));
      rows.back().own = 2 * node + axis;
    }
  }
  const Vector2d along = motion.line().normalized();
  std::map<Index, double> terms;
  add_to(terms, motion.second(), along);
  add_to(terms, motion.first(), -along);
  rows.push_back(equation_of(terms, 0));
}

/// The rows of the motions that are given.
void add_given(const RigidSide& rigid, const RigidMotion& motion, std::vector<Equation>& rows) {
  const auto give = [&](const std::optional<double>& given, const std::string& history, const Vector2d& along,
                        double turn) {
    if (!given) return;
    std::map<Index, double> terms;
    if (turn == 0) motion.add_shift(rigid.centre, along, 1, terms);
    motion.add_turn(turn, terms);
    rows.push_back(equation_of(terms, *given * (turn == 0 ? 1 : turn)));
    rows.back().history = history;
  };
  give(rigid.x, rigid.histories.x, {1, 0}, 0);
  give(rigid.y, rigid.histories.y, {0, 1}, 0);
  give(rigid.turn, rigid.histories.turn, {0, 0}, motion.line().norm());  // so that its equation is of lengths, too
}

/// What drives the side.
std::vector<BondLoad> loads_of(const RigidSide& rigid, const RigidMotion& motion) {
  std::vector<BondLoad> loads;
  const auto drive = [&](const Vector2d& force, double moment, const std::string& history) {
    std::map<Index, double> push;
    motion.add_shift(rigid.centre, force, 1, push);
    motion.add_turn(moment, push);
    if (push.empty() && !history.empty()) push[2 * motion.first()] = 0;  // a history that is followed, by nothing
    for (const auto& [component, value] : push) loads.push_back({component, value, history});
  };
  drive(rigid.force, 0, rigid.histories.force);
  drive({0, 0}, rigid.moment, rigid.histories.moment);
  return loads;
}

/// Forces along motions that are given appear in no sum: the two ends of one force are both on the side.
void note_idle(const RigidSide& rigid, const std::string& what, std::vector<std::string>& notes) {
  const auto note = [&](bool given, const char* way, double load, const char* word) {
    if (given && load != 0)
      notes.push_back(text(what, ": ", way, " is given, so that the prescribed motion takes up ", word, ", which moves nothing"));
  };
  note(rigid.x.has_value(), "x", rigid.force.x(), "a force along x");
  note(rigid.y.has_value(), "y", rigid.force.y(), "a force along y");
  note(rigid.turn.has_value(), "turn", rigid.moment, "a moment");
}

void check_rigid(const RigidSide& rigid, const std::string& what, const Plan& draft) {
  require_input(!is_axial(draft.bodies.front()), what,
                ": in axial symmetry a rigid side moves along the axis alone; prescribe that");
  for (const double given : {rigid.x.value_or(0), rigid.y.value_or(0), rigid.turn.value_or(0),
                             rigid.force.x(), rigid.force.y(), rigid.moment, rigid.centre.x(),
                             rigid.centre.y()})
    require_input(std::isfinite(given), what, ": expected finite numbers, got ", given);
}

}  // namespace

void add_relation(const Relation& relation, std::size_t number, Plan& draft, Equations& all) {
  Bond bond;
  bond.name = bond.what = text("relation ", number);
  check_relation(relation, bond.what);
  std::vector<Placed> placed;
  for (const RelationTerm& term : relation.terms)
    placed.push_back({&term, nodes_of(term.side, term.only_at, draft)});
  match(bond.what, placed, draft);
  std::size_t count = 1;
  for (const Placed& one : placed) count = std::max(count, one.nodes.size());
  std::vector<Equation> rows;
  for (std::size_t k = 0; k < count; ++k) {
    std::map<Index, double> terms;
    for (const Placed& one : placed)
      add_to(terms, one.nodes[one.term->only_at ? 0 : k], one.term->times * one.term->along);
    rows.push_back(equation_of(terms, relation.right));
    rows.back().stiffness = relation.stiffness;
    rows.back().history = relation.history;
  }
  const bool equal = relation.holds == Holds::Equal;
  draft.on.push_back(text(bond.what, " of ", relation.terms.size(),
                          relation.terms.size() == 1 ? " term: " : " terms: ", count,
                          !equal ? " pairs" : relation.stiffness ? " springs" : " equations"));
  if (!equal) return add_one_sided(relation, bond.name, rows, placed.front().nodes, draft);
  bond.nodes = placed.front().nodes;
  bond.first = all.rows.size();
  all.rows.insert(all.rows.end(), rows.begin(), rows.end());
  bond.end = all.rows.size();
  all.bonds.push_back(std::move(bond));
}

void add_rigid(const RigidSide& rigid, Plan& draft, Equations& all) {
  Bond bond;
  bond.nodes = nodes_of(rigid.side, {}, draft);
  const BodyModel& body = draft.bodies[body_index(draft.bodies, rigid.side)];
  bond.name = text("rigid ", body.mesh.name, '.', rigid.side.boundary);
  bond.what = text("rigid side '", rigid.side.boundary, "' of '", body.mesh.name, '\'');
  check_rigid(rigid, bond.what, draft);
  const RigidMotion motion(bond.nodes, draft);
  bond.first = all.rows.size();
  add_rigid_rows(bond.nodes, motion, draft, all.rows);
  add_given(rigid, motion, all.rows);
  bond.end = all.rows.size();
  bond.loads = loads_of(rigid, motion);
  note_idle(rigid, bond.what, draft.notes);
  draft.on.push_back(text(bond.what, ": ", bond.end - bond.first, " equations"));
  all.bonds.push_back(std::move(bond));
}

}  // namespace signorini
