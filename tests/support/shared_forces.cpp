#include "support/shared_forces.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <set>

#include "meshes/split.hpp"
#include "signorini/core/errors.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "support/random_bodies.hpp"

namespace signorini_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;

class Drawing {
 public:
  explicit Drawing(std::uint64_t seed) : draw_(seed) { scene_.bodies.clear(); }
  Scene drawn(std::string& text);

 private:
  [[nodiscard]] Vector2d turned(const Vector2d& v) const {
    return {cos_ * v.x() - sin_ * v.y(), sin_ * v.x() + cos_ * v.y()};
  }
  [[nodiscard]] Vector2d placed(const Vector2d& x) const { return length_ * turned(x); }
  Obstacle wall(const Vector2d& point, const Vector2d& normal) {
    return half_plane(placed(point), turned(normal));
  }
  Body& add_block(const std::string& name, const Vector2d& corner, double lean);
  void press(Body& body, bool beside);
  void hold(Body& body);
  void rub(ContactSpec& contact);
  /// Names the first sides of a boundary NAME_a, the others NAME_b.
  void split_side(Body& body, const std::string& name);
  void corner(bool with_body);
  void shared_node();
  void gauss();
  void two();

  Draws draw_;
  Scene scene_;
  double cos_ = 1;
  double sin_ = 0;
  double length_ = 1;
  double stress_ = 1;
  Vector2d size_ = {1.0, 1.0};
};

Body& Drawing::add_block(const std::string& name, const Vector2d& corner, double lean) {
  const int nx = draw_.whole(1, 6), ny = draw_.whole(1, 3);
  const int kind = draw_.whole(0, 3);
  const MeshOrder order = kind % 2 == 0 ? MeshOrder::Linear : MeshOrder::Quadratic;
  size_ = {draw_.sixteenths(8, 48), draw_.sixteenths(8, 32)};
  draw_.say("; '", name, "' of ", size_.transpose(), " in ", nx, " x ", ny, " kind ", kind,
            " leans ", lean);
  Mesh mesh = block(name, corner, size_, nx, ny, order);
  if (kind >= 2) mesh = split(mesh);
  Body body;
  body.mesh = mapped(mesh, [&](const Vector2d& x) -> Vector2d {
    return placed({x.x() + lean * (x.y() - corner.y()), x.y()});
  });
  body.material = {1000 * stress_ * draw_.decade(-1, 1), draw_.pick({0.0, 0.3, 0.4}),
                   PlaneState::Strain, 1};
  scene_.bodies.push_back(std::move(body));
  return scene_.bodies.back();
}

void Drawing::press(Body& body, bool beside) {
  const double pressure = stress_ * draw_.sixteenths(4, 32);
  const Vector2d drag =
      draw_.chance(8) ? Vector2d(pressure * turned({draw_.sixteenths(-8, 8), 0})) : Vector2d(0, 0);
  body.loads.edges = {{"top", pressure, {}}};
  if (!drag.isZero(0)) body.loads.edges[0].traction = [drag](const Vector2d&) { return drag; };
  if (beside) body.loads.edges.push_back({"right", stress_ * draw_.sixteenths(4, 32), {}});
  draw_.say(", pressure ", pressure, ", drag ", drag.transpose());
}

void Drawing::hold(Body& body) {
  const bool straight = sin_ == 0;
  if (straight && draw_.chance(4))
    body.supports = {prescribed("right", Axis::X, -length_ * 1e-3 * draw_.whole(0, 2))};
  if (straight && draw_.chance(4))
    body.supports.push_back(prescribed("top", Axis::Y, -length_ * 1e-3 * draw_.whole(1, 3)));
}

void Drawing::rub(ContactSpec& contact) {
  const double mu = draw_.pick({0.0, 0.1, 0.3, 0.3, 0.7, 1.0, 2.0});
  if (mu > 0) contact.friction = Friction{mu, 0};
  draw_.say("; friction ", mu);
}

void Drawing::split_side(Body& body, const std::string& name) {
  const std::vector<CellSide> sides = boundary(body.mesh, name);
  const std::size_t n = sides.size();
  const std::size_t first =
      n < 2 ? n : static_cast<std::size_t>(draw_.whole(1, static_cast<int>(n) - 1));
  const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(first);
  body.mesh.boundaries[name + "_a"].assign(sides.begin(), middle);
  if (first < n) body.mesh.boundaries[name + "_b"].assign(middle, sides.end());
}

void Drawing::corner(bool with_body) {
  const double lean = draw_.pick({0.0, 0.0, 0.25, -0.25});
  const double gap = draw_.pick({0.0, 0.0, 0.0, 1e-3, -1e-3});
  draw_.say("corner, gap ", gap);
  if (with_body) {
    Body& lower = add_block("lower", {-0.5, -3}, 0);
    lower.mesh = mapped(lower.mesh, [&](const Vector2d& x) -> Vector2d {
      return x + placed({0, 3 - size_.y()});  // its top at y = 0
    });
    lower.supports = {fixed("bottom")};
  }
  Body& body = add_block("upper", {0, 0}, lean);
  press(body, true);
  hold(body);
  ContactSpec floor{{"bottom", "upper"}, wall({0, 0}, {0, 1})};
  if (with_body) {
    floor.target = Side{"top", "lower"};
    floor.gap_operator = draw_.pick<const char*>({"mortar", "node_to_segment", "gauss_points"});
    if (floor.gap_operator == "gauss_points") floor.points = draw_.whole(1, 4);
    draw_.say("; ", floor.gap_operator, ' ', floor.points);
  }
  rub(floor);
  ContactSpec side{{"left", "upper"}, wall({-gap, 0}, Vector2d(1, -lean).normalized())};
  rub(side);
  scene_.contacts = {floor, side};
}

void Drawing::shared_node() {
  draw_.say("one side in two contacts");
  Body& body = add_block("upper", {0, 0}, 0);
  press(body, false);
  hold(body);
  split_side(body, "bottom");
  const Obstacle floor = wall({0, 0}, {0, 1});
  for (const char* part : {"bottom_a", "bottom_b"}) {
    if (body.mesh.boundaries.count(part) == 0) continue;
    ContactSpec contact{{part, "upper"}, floor};
    rub(contact);
    scene_.contacts.push_back(contact);
  }
}

void Drawing::gauss() {
  draw_.say("Gauss points");
  two();
  ContactSpec& contact = scene_.contacts[0];
  contact.gap_operator = "gauss_points";
  contact.points = draw_.whole(1, 5);
  draw_.say("; points ", contact.points);
}

void Drawing::two() {
  Body& lower = add_block("lower", {0, -2}, 0);
  lower.mesh = mapped(lower.mesh, [&](const Vector2d& x) -> Vector2d {
    return x + placed({0, 2 - size_.y()});
  });
  lower.supports = {fixed("bottom")};
  Body& upper = add_block("upper", {0, 0}, 0);
  press(upper, false);
  hold(upper);
  ContactSpec contact{{"bottom", "upper"}, Side{"top", "lower"}};
  rub(contact);
  contact.gap_operator = draw_.pick<const char*>({"mortar", "node_to_segment"});
  scene_.contacts = {contact};
}

Scene Drawing::drawn(std::string& text) {
  length_ = draw_.decade(-6, 6);
  stress_ = draw_.decade(-6, 6);
  if (!draw_.chance(6)) {
    const double angle = draw_.sixteenths(1, 100);
    cos_ = std::cos(angle);
    sin_ = std::sin(angle);
  }
  draw_.say("unit ", length_, ", stress ", stress_, ", sine ", sin_, ": ");
  const int kind = draw_.whole(0, 6);
  scene_.bodies.reserve(2);
  if (kind <= 1) corner(false);
  if (kind == 2) corner(true);
  if (kind == 3) shared_node();
  if (kind == 4 || kind == 5) gauss();
  if (kind == 6) two();
  text = draw_.text;
  return scene_;
}

/// The least |C w - b| with w >= 0, by Lawson and Hanson's active set.
double distance_from_cone(const MatrixXd& C, const VectorXd& b) {
  const Index n = C.cols();
  VectorXd w = VectorXd::Zero(n);
  std::vector<Index> used;
  for (Index step = 0; step < 3 * n + 10; ++step) {
    const VectorXd gain = C.transpose() * (b - C * w);
    Index next = -1;
    for (Index i = 0; i < n; ++i)
      if (std::find(used.begin(), used.end(), i) == used.end() && gain(i) > 1e-11 * b.norm() &&
          (next < 0 || gain(i) > gain(next)))
        next = i;
    if (next < 0) break;
    used.push_back(next);
    while (!used.empty()) {
      const VectorXd best = C(Eigen::all, used).completeOrthogonalDecomposition().solve(b);
      if (best.minCoeff() > 0) {
        w.setZero();
        w(used) = best;
        break;
      }
      double part = 1;
      for (std::size_t k = 0; k < used.size(); ++k)
        if (const double end = best(static_cast<Index>(k)); end <= 0)
          part = std::min(part, w(used[k]) / (w(used[k]) - end));
      std::vector<Index> kept;
      for (std::size_t k = 0; k < used.size(); ++k) {
        double& now = w(used[k]);
        now += part * (best(static_cast<Index>(k)) - now);
        if (now > 1e-14)
          kept.push_back(used[k]);
        else
          now = 0;
      }
      used = kept;
    }
  }
  return (C * w - b).norm();
}

}  // namespace

Scene shared_force_scene(std::uint64_t seed, std::string& text) {
  return Drawing(seed).drawn(text);
}

std::vector<Index> movable_forces(const Model& model, const Solution& solution) {
  const ContactState& state = solution.contact;
  const VectorXd& force = solution.refined.force;
  const Index pairs = state.gap.size();
  const MatrixXd A = model.programme.A;
  const double small_force = 1e-9 * force.cwiseAbs().maxCoeff();
  double length = 0;
  for (const BodyModel& body : model.bodies)
    length = std::max(length, body.mesh.nodes.cwiseAbs().maxCoeff());
  const std::vector<ContactStatus> statuses = state.contact_status;
  std::vector<VectorXd> columns, changes;  // on unknowns; of all rows
  std::vector<VectorXd> bounds;            // gradients of those that are met
  const auto unit = [&](Index row) { return VectorXd::Unit(force.size(), row); };
  for (Index i = 0; i < pairs; ++i) {
    if (statuses[static_cast<std::size_t>(i)] == ContactStatus::Open &&
        state.gap(i) > 1e-11 * length)
      continue;
    const auto found = std::find(model.law.pair.begin(), model.law.pair.end(), i);
    const Index k = found == model.law.pair.end() ? -1 : found - model.law.pair.begin();
    if (force(i) <= small_force) bounds.push_back(unit(i));
    if (k < 0) {
      changes.push_back(unit(i));
      continue;
    }
    const double mu = model.law.coefficient(k);
    const double slip = state.slip(k);
    if (std::abs(slip) > 1e-11 * length) {
      changes.push_back(unit(i) - (slip > 0 ? mu : -mu) * unit(pairs + k));
      continue;
    }
    changes.push_back(unit(i));
    changes.push_back(unit(pairs + k));
    for (const double side : {1.0, -1.0})
      if (mu * force(i) - side * force(pairs + k) <= small_force)
        bounds.push_back(mu * unit(i) - side * unit(pairs + k));
  }
  if (changes.empty()) return {};
  MatrixXd changed(force.size(), static_cast<Index>(changes.size()));
  for (std::size_t j = 0; j < changes.size(); ++j) changed.col(static_cast<Index>(j)) = changes[j];
  const Eigen::JacobiSVD<MatrixXd> svd(A.transpose() * changed, Eigen::ComputeFullV);
  const VectorXd values = svd.singularValues();
  const Index rank = (values.array() > 1e-9 * values(0)).count();
  const MatrixXd free = changed * svd.matrixV().rightCols(changed.cols() - rank);
  MatrixXd met(free.cols(), static_cast<Index>(bounds.size()));
  for (std::size_t j = 0; j < bounds.size(); ++j)
    met.col(static_cast<Index>(j)) = free.transpose() * bounds[j];
  std::vector<Index> rows;
  for (Index row = 0; row < force.size(); ++row) {
    const VectorXd way = free.row(row).transpose();
    if (way.size() == 0 || way.norm() < 1e-8) continue;
    for (const double sign : {1.0, -1.0})
      if (distance_from_cone(met, sign * way) > 1e-6 * way.norm()) {
        rows.push_back(row);
        break;
      }
  }
  return rows;
}

namespace {

/// The pairs of some rows.
std::set<Index> pairs_of(const Model& model, const std::vector<Index>& rows) {
  const Index pairs = static_cast<Index>(model.contact_of.size());
  std::set<Index> all;
  for (const Index row : rows)
    all.insert(row < pairs ? row : model.law.pair[static_cast<std::size_t>(row - pairs)]);
  return all;
}

void compare(std::uint64_t seed, SharedForceCounts& counts) {
  std::string words;
  const Scene scene = shared_force_scene(seed, words);
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Solution solution = solve(model, condense(model, ledger), ledger);
  if (solution.contact.report.status != SolveStatus::Solved) {
    ++counts.unsolved;
    return;
  }
  ++counts.solved;
  const double least = 1e-6 * solution.refined.force.cwiseAbs().maxCoeff();
  std::vector<Index> rows;
  for (const SharedForces& group : solution.shared)
    for (const ForceRange& range : group.forces)
      if (range.high - range.low > least) rows.push_back(range.row);
  const std::set<Index> named = pairs_of(model, rows);
  const std::set<Index> movable = pairs_of(model, movable_forces(model, solution));
  const bool noted = std::any_of(
      solution.notes.begin(), solution.notes.end(),
      [](const std::string& note) { return note.find("are not determined (") != note.npos; });
  counts.open += movable.empty() ? 0 : 1;
  counts.missed += !movable.empty() && !noted ? 1 : 0;
  counts.in_vain += movable.empty() && noted ? 1 : 0;
  counts.pairs += static_cast<int>(movable.size());
  for (const Index pair : movable) counts.pairs_missed += static_cast<int>(1 - named.count(pair));
  for (const Index pair : named) counts.pairs_in_vain += static_cast<int>(1 - movable.count(pair));
  if (named != movable || noted == movable.empty())
    counts.wrong.push_back(text(seed, noted ? " noted, " : " not noted, ", named.size(), " named, ",
                                movable.size(), " movable: ", words));
}

}  // namespace

SharedForceCounts compare_shared_forces(std::uint64_t first, int count) {
  SharedForceCounts counts;
  for (std::uint64_t seed = first; counts.solved < count; ++seed) try {
      compare(seed, counts);
    } catch (const ProblemError&) {
      ++counts.unsolved;
    }
  return counts;
}

}  // namespace signorini_test
