#include "addons/checks/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "addons/checks/loose_nodes.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/along_boundary.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

using Notes = std::vector<std::string>;

/// Nodes of a body that two of its own boundaries have, which may touch each other.
std::set<Index> touching_itself(const Scene& scene, const Mesh& mesh) {
  const auto own = [&](const Side& side) {
    return side.body == mesh.name || (side.body.empty() && scene.bodies.size() == 1);
  };
  std::set<Index> nodes;
  for (const ContactSpec& contact : scene.contacts) {
    const Side* target = std::get_if<Side>(&contact.target);
    if (target == nullptr || !own(contact.source) || !own(*target)) continue;
    for (const Side* side : {&contact.source, target})
      for (const Index node : boundary_nodes(mesh, side->boundary)) nodes.insert(node);
  }
  return nodes;
}

void note_pieces(const Mesh& mesh, const std::vector<MeshPiece>& pieces, Notes& notes) {
  if (pieces.size() < 2) return;
  std::string list;
  for (std::size_t k = 0; k < std::min<std::size_t>(3, pieces.size()); ++k)
    list += (k == 0 ? "" : ", ") + in_words(mesh, pieces[k]);
  notes.push_back(text("body '", mesh.name, "' consists of ", pieces.size(),
                       " loose pieces that have no node in common: ", list,
                       pieces.size() > 3 ? ", ..." : "",
                       ". No force passes between them but by contact; if they are one body, let "
                       "them share the nodes where they meet"));
}

void note_loose_nodes(const Scene& scene, const Mesh& mesh, Notes& notes) {
  std::vector<LooseNode> loose = loose_nodes(mesh);
  if (loose.empty()) return;
  const std::set<Index> meant = touching_itself(scene, mesh);
  loose.erase(std::remove_if(loose.begin(), loose.end(),
                             [&](const LooseNode& one) {
                               const Index other =
                                   one.other >= 0 ? one.other : mesh.side_nodes(one.side).front();
                               return meant.count(one.node) > 0 && meant.count(other) > 0;
                             }),
              loose.end());
  const auto hangs = std::stable_partition(loose.begin(), loose.end(),
                                           [](const LooseNode& one) { return one.other >= 0; });
  if (hangs != loose.begin()) {
    const LooseNode& first = loose.front();
    notes.push_back(text(
        "body '", mesh.name, "': ", hangs - loose.begin(),
        " nodes coincide with others that they are not joined to; the first is node ", first.node,
        " at ", in_brackets(mesh.nodes.row(first.node)), ", beside node ", first.other,
        ". The body can open there: unless a crack is meant, let the cells share "
        "these nodes (in Gmsh: Coherence Mesh)"));
  }
  if (hangs != loose.end()) {
    const std::vector<Index> ends = mesh.side_nodes(hangs->side);
    notes.push_back(
        text("body '", mesh.name, "': ", loose.end() - hangs,
             " nodes hang on the side of a cell that does not have them; the first is node ",
             hangs->node, " at ", in_brackets(mesh.nodes.row(hangs->node)), ", between the nodes ",
             ends.front(), " and ", ends.back(), " of cell ", hangs->side.cell,
             ". The body can open or overlap itself there: unless a crack is meant, let "
             "the cells on both sides have the same nodes"));
  }
}

/// What a traction along a boundary adds up to, about its first node, per thickness, in axial symmetry per angle.
Resultant resultant(const Mesh& mesh, const EdgeLoad& load, const Depth& depth) {
  const AnchoredPoint first(
      mesh.nodes.row(boundary_nodes(mesh, load.boundary).front()).transpose());
  Resultant sum;
  integrate_boundary(
      mesh, load.boundary,
      [&](const BoundaryPoint& at) {
        const Vector2d position = at.point.position();
        sum.add(at.point - first,
                at.weight * at.tangent.norm() * depth.part(position.x()) * load.traction(position));
      },
      load.rule);
  return sum;
}

bool is_closed(const Mesh& mesh, const std::string& name) {
  const std::vector<CellSide>& sides = boundary(mesh, name);
  return mesh.side_nodes(sides.front()).front() == mesh.side_nodes(sides.back()).back();
}

/// Whether a boundary has no area: in axial symmetry what lies on the axis.
bool has_no_area(const Mesh& mesh, const std::string& name, const Depth& depth) {
  if (!depth.axial) return false;
  const std::vector<Index> nodes = boundary_nodes(mesh, name);
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](Index node) { return mesh.nodes(node, 0) == 0; });
}

void note_edge_load(const Mesh& mesh, const EdgeLoad& load, const Depth& depth, Notes& notes) {
  const std::string what = text("load on '", load.boundary, "' of '", mesh.name, "'");
  const Resultant sum = load.traction ? resultant(mesh, load, depth) : Resultant{};
  constexpr double cancelled = 1e-6;
  if (has_no_area(mesh, load.boundary, depth))
    notes.push_back(what + " does nothing: it lies on the axis, and has no area");
  else if (load.pressure == 0 && sum.all_forces == 0)
    notes.push_back(what + " is zero everywhere and does nothing");
  else if (sum.all_forces > 0 && sum.force.norm() <= cancelled * sum.all_forces &&
           std::abs(sum.moment) <= cancelled * sum.all_moments && !is_closed(mesh, load.boundary))
    notes.push_back(what +
                    ": the traction adds up to no force and no moment. If it should push the body, "
                    "check its signs");
}

bool is_zero(const VectorField& field, const NodeArray& nodes) {
  for (Index node = 0; node < nodes.rows(); ++node)
    if (!field(nodes.row(node).transpose()).isZero(0)) return false;
  return true;
}

}  // namespace

std::vector<std::string> mesh_warnings(const Scene& scene, const BodyModel& body) {
  Notes notes;
  note_pieces(body.mesh, body.pieces, notes);
  note_loose_nodes(scene, body.mesh, notes);
  return notes;
}

std::vector<std::string> load_warnings(const Body& body) {
  Notes notes;
  for (const EdgeLoad& load : body.loads.edges)
    note_edge_load(body.mesh, load, depth_of(body.material), notes);
  const double modulus = body.material.youngs_modulus;
  for (const EdgeLoad& load : body.loads.edges)
    if (std::abs(load.pressure) > SmallLimits().pressure * modulus)
      notes.push_back(
          text("load on '", load.boundary, "' of '", body.mesh.name, "': the pressure ",
               load.pressure, " is ", std::abs(load.pressure) / modulus,
               " times Young's modulus, more than a body bears: check the units of both"));
  if (body.loads.body_force && is_zero(body.loads.body_force, body.mesh.nodes))
    notes.push_back("body force on '" + body.mesh.name + "' is zero everywhere and does nothing");
  return notes;
}

}  // namespace signorini
