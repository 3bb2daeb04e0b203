// Sides that move as rigid bodies: their equations, and what drives them.
#include <cmath>
#include <utility>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/equations/terms.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// How a rigid side moves, by the displacements of two of its nodes: those of the first, and that of the second across the line
/// between them. In axial symmetry it moves along the axis alone, as its first node does.
class RigidMotion {
 public:
  RigidMotion(const std::vector<Index>& nodes, const Plan& draft)
      : draft_(draft),
        first_(nodes.front()),
        second_(nodes.front()),
        axial_(is_axial(draft.bodies.front())) {
    for (const Index node : nodes)
      if ((place_of(draft, node) - origin()).norm() > line().norm()) second_ = node;
  }

  [[nodiscard]] Index first() const { return first_; }
  [[nodiscard]] Index second() const { return second_; }
  [[nodiscard]] Vector2d line() const { return place_of(draft_, second_) - origin(); }

  /// Adds a shift of a point in a direction, times a factor. \param place  of the point
  void add_shift(const Vector2d& place, const Vector2d& along, double factor,
                 Terms& terms) const {
    add_to(terms, first_, factor * along);
    if (axial_) return;
    const Vector2d arm = place - origin();
    add_turn(factor * along.dot(Vector2d(-arm.y(), arm.x())), terms);
  }

  /// Adds the turn, times a factor.
  void add_turn(double factor, Terms& terms) const {
    if (axial_) return;
    const Vector2d across = Vector2d(-line().y(), line().x()) / line().squaredNorm();
    add_to(terms, second_, factor * across);
    add_to(terms, first_, -factor * across);
  }

 private:
  [[nodiscard]] Vector2d origin() const { return place_of(draft_, first_); }

  const Plan& draft_;
  Index first_;
  Index second_;
  bool axial_;
};

/// The rows that make the nodes of a side one ring that keeps its radii. Where the axis or a support lets no radius change, and of the
/// first node along the axis, there is nothing to say.
void add_ring_rows(const std::vector<Index>& nodes, const RigidMotion& motion, const Plan& draft,
                   std::vector<Equation>& rows) {
  for (const Index node : nodes)
    for (const int axis : {0, 1}) {
      const bool stays = draft.unknowns.number(node, axis) < 0 && draft.unknowns.held(node, axis) == 0;
      if ((axis == 0 && stays) || (axis == 1 && node == motion.first())) continue;
      Terms terms;
      add_to(terms, node, Vector2d::Unit(axis));
      if (axis == 1) motion.add_shift(place_of(draft, node), Vector2d::Unit(axis), -1, terms);
      rows.push_back(equation_of(terms, 0));
      rows.back().own = 2 * node + axis;
    }
}

/// The rows that make the nodes of a side one rigid body.
void add_rigid_rows(const std::vector<Index>& nodes, const RigidMotion& motion, const Plan& draft,
                    std::vector<Equation>& rows) {
  for (const Index node : nodes) {
    if (node == motion.first() || node == motion.second()) continue;
    for (const int axis : {0, 1}) {
      Terms terms;
      add_to(terms, node, Vector2d::Unit(axis));
      motion.add_shift(place_of(draft, node), Vector2d::Unit(axis), -1, terms);
      rows.push_back(equation_of(terms, 0));
      rows.back().own = 2 * node + axis;
    }
  }
  const Vector2d along = motion.line().normalized();
  Terms terms;
  add_to(terms, motion.second(), along);
  add_to(terms, motion.first(), -along);
  rows.push_back(equation_of(terms, 0));
}

/// The rows of the motions that are given.
void add_given(const RigidSide& rigid, const RigidMotion& motion, std::vector<Equation>& rows) {
  const auto give = [&](const std::optional<double>& given, const std::string& history, const Vector2d& along,
                        double turn) {
    if (!given) return;
    Terms terms;
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
    Terms push;
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
  const bool tilts = rigid.x || rigid.turn || rigid.force.x() != 0 || rigid.moment != 0;
  require_input(!is_axial(draft.bodies.front()) || !tilts, what,
                ": in axial symmetry a rigid side moves along the axis alone: give y, or a force [0, F] all round, and leave "
                "x, turn, moment and a force along x out");
  for (const double given : {rigid.x.value_or(0), rigid.y.value_or(0), rigid.turn.value_or(0),
                             rigid.force.x(), rigid.force.y(), rigid.moment, rigid.centre.x(),
                             rigid.centre.y()})
    require_input(std::isfinite(given), what, ": expected finite numbers, got ", given);
}

}  // namespace

void add_rigid(const RigidSide& rigid, Plan& draft, Equations& all) {
  Bond bond;
  bond.nodes = nodes_of(rigid.side, {}, draft);
  const BodyModel& body = draft.bodies[body_index(draft.bodies, rigid.side)];
  bond.name = text("rigid ", body.mesh.name, '.', rigid.side.boundary);
  bond.what = text("rigid side '", rigid.side.boundary, "' of '", body.mesh.name, '\'');
  check_rigid(rigid, bond.what, draft);
  const RigidMotion motion(bond.nodes, draft);
  bond.first = all.rows.size();
  (is_axial(draft.bodies.front()) ? add_ring_rows : add_rigid_rows)(bond.nodes, motion, draft, all.rows);
  add_given(rigid, motion, all.rows);
  bond.end = all.rows.size();
  bond.loads = loads_of(rigid, motion);
  note_idle(rigid, bond.what, draft.notes);
  draft.on.push_back(text(bond.what, ": ", bond.end - bond.first, " equations"));
  all.bonds.push_back(std::move(bond));
}

}  // namespace signorini
