#include "addons/checks/point_supports.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/joints.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Components of nodes, marked or not: `n_nodes x 2`.
using Marks = Eigen::Array<bool, Eigen::Dynamic, 2>;

/// Whether all that is held is held along named boundaries, as mostly: then nothing has to be marked.
bool held_along_boundaries(const BodyModel& body) {
  if (is_axial(body)) return false;
  const auto& number = body.unknowns.number;
  std::vector<Index> along;
  for (const auto& named : body.mesh.boundaries)
    for (const CellSide& side : named.second) {
      const Index corner = body.mesh.cells(side.cell, side.side);
      if (number(corner, 0) >= 0 && number(corner, 1) >= 0) continue;
      const std::vector<Index> nodes = body.mesh.side_nodes(side);
      for (int c = 0; c < 2; ++c)
        if (std::all_of(nodes.begin(), nodes.end(), [&](Index node) { return number(node, c) < 0; }))
          for (const Index node : nodes) along.push_back(2 * node + c);
    }
  std::sort(along.begin(), along.end());
  along.erase(std::unique(along.begin(), along.end()), along.end());
  return static_cast<Index>(along.size()) == 2 * number.rows() - body.unknowns.count;
}

Marks sprung(const BodyModel& body) {
  Marks marks = Marks::Constant(body.springs.cols() / 2, 2, false);
  for (Index k = 0; k < body.springs.cols(); ++k)
    marks(k / 2, k % 2) = body.springs.coeff(k, k) > 0;
  return marks;
}

/// Which nodes lie on the axis of a body of revolution.
struct OnAxis {
  explicit OnAxis(const BodyModel& body) {
    if (!is_axial(body)) return;
    marks.resize(at(body.mesh.n_nodes()), 0);
    for (const Index node : axis_nodes(body.mesh)) marks[at(node)] = 1;
  }
  bool operator()(Index node) const { return !marks.empty() && marks[at(node)] != 0; }

  std::vector<char> marks;  // empty: none
};

/// Leaves the marks that no side with an area has at all its nodes; on the axis only those along it.
Marks at_points(const Marks& all, const BodyModel& body, const OnAxis& axis) {
  Marks marks = all;
  for (Index node = 0; node < marks.rows(); ++node)
    if (axis(node)) marks(node, 0) = false;
  for (const CellSide& side : outer_sides(body.mesh)) {
    const std::vector<Index> nodes = body.mesh.side_nodes(side);
    if (std::all_of(nodes.begin(), nodes.end(), axis)) continue;
    for (int c = 0; c < 2; ++c)
      if (std::all_of(nodes.begin(), nodes.end(), [&](Index node) { return all(node, c); }))
        for (const Index node : nodes) marks(node, c) = false;
  }
  return marks;
}

/// Says where marked components bear forces, and how large the largest is; empty where none is more than `nothing`.
std::string borne_at(const Marks& marks, const NodeArray& force, const BodyModel& body,
                     const OnAxis& axis, double nothing) {
  Index most = -1, count = 0;
  double largest = nothing, along_axis = 0;
  for (Index node = 0; node < marks.rows(); ++node) {
    const Eigen::RowVector2d own = marks.row(node).select(force.row(node).array(), 0.0);
    if (axis(node)) along_axis += own.y();
    if (axis(node) || !(own.norm() > nothing)) continue;
    ++count;
    if (own.norm() > largest) {
      largest = own.norm();
      most = node;
    }
  }
  if (std::abs(along_axis) > nothing)
    return text(" on the axis a force of ", std::abs(along_axis), " along it");
  if (count == 0) return {};
  return text(" at the point ", in_brackets(body.mesh.nodes.row(most)), " a force of ", largest,
              count > 1 ? text(", and ", count - 1, " other points") : std::string());
}

}  // namespace

std::vector<std::string> point_supports(const Model& model, const Solution& solution) {
  std::vector<std::string> notes;
  if (model.equations) return notes;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const OnAxis axis(body);
    const auto note = [&](const Marks& all, const char* what, const char* instead,
                          auto&& forces_of) {
      if (!all.any()) return;
      const Marks marks = at_points(all, body, axis);
      if (!marks.any()) return;
      const double all_forces =
          model.programme.load.lpNorm<1>() + solution.contact.force.lpNorm<1>();
      const std::string where = borne_at(marks, forces_of(model, solution, b), body, axis,
                                         std::sqrt(epsilon) * all_forces);
      if (!where.empty())
        notes.push_back(
            text(what, " of body '", body.mesh.name, "' bear", where,
                 ", where there is no area to bear it: with finer meshes the body gives way there "
                 "without bound, and no displacement is accurate; ",
                 instead, " a side beside it"));
    };
    if (!held_along_boundaries(body))
      note(body.unknowns.number < 0, "supports", "support", support_forces);
    if (body.springs.nonZeros() > 0) note(sprung(body), "springs", "put them on", spring_forces);
  }
  return notes;
}

}  // namespace signorini
