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

Marks sprung(const BodyModel& body) {
  Marks marks = Marks::Constant(body.mesh.n_nodes(), 2, false);
  for (Index k = 0; k < body.springs.cols(); ++k)
    marks(k / 2, k % 2) = body.springs.coeff(k, k) > 0;
  return marks;
}

/// Which nodes lie on the axis of a body of revolution.
std::vector<char> on_axis(const BodyModel& body) {
  std::vector<char> marks(at(body.mesh.n_nodes()), 0);
  if (is_axial(body))
    for (const Index node : axis_nodes(body.mesh)) marks[at(node)] = 1;
  return marks;
}

/// Leaves the marks that no side with an area has at all its nodes; on the axis only those along it.
Marks at_points(Marks marks, const BodyModel& body, const std::vector<char>& axis) {
  if (!marks.any()) return marks;
  const Marks all = marks;
  for (Index node = 0; node < marks.rows(); ++node)
    if (axis[at(node)] != 0) marks(node, 0) = false;
  for (const CellSide& side : outer_sides(body.mesh)) {
    const std::vector<Index> nodes = body.mesh.side_nodes(side);
    const auto on_it = [&](Index node) { return axis[at(node)] != 0; };
    if (std::all_of(nodes.begin(), nodes.end(), on_it)) continue;
    for (int c = 0; c < 2; ++c)
      if (std::all_of(nodes.begin(), nodes.end(), [&](Index node) { return all(node, c); }))
        for (const Index node : nodes) marks(node, c) = false;
  }
  return marks;
}

/// Says where marked components bear forces, and how large the largest is; empty where none is more than `nothing`.
std::string borne_at(const Marks& marks, const NodeArray& force, const BodyModel& body,
                     const std::vector<char>& axis, double nothing) {
  Index most = -1, count = 0;
  double largest = nothing, along_axis = 0;
  for (Index node = 0; node < marks.rows(); ++node) {
    const Eigen::RowVector2d own = marks.row(node).select(force.row(node).array(), 0.0);
    if (axis[at(node)] != 0) along_axis += own.y();
    if (axis[at(node)] != 0 || !(own.norm() > nothing)) continue;
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
  const double forces = model.programme.load.lpNorm<1>() + solution.contact.force.lpNorm<1>();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const std::vector<char> axis = on_axis(body);
    const auto note = [&](const Marks& all, const char* what, const char* instead,
                          auto&& forces_of) {
      const Marks marks = at_points(all, body, axis);
      if (!marks.any()) return;
      const std::string where =
          borne_at(marks, forces_of(model, solution, b), body, axis, std::sqrt(epsilon) * forces);
      if (!where.empty())
        notes.push_back(
            text(what, " of body '", body.mesh.name, "' bear", where,
                 ", where there is no area to bear it: with finer meshes the body gives way there "
                 "without bound, and no displacement is accurate; ",
                 instead, " a side beside it"));
    };
    note(body.unknowns.number < 0, "supports", "support", support_forces);
    note(sprung(body), "springs", "put them on", spring_forces);
  }
  return notes;
}

}  // namespace signorini
