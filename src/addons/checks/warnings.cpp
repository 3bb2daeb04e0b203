#include "addons/checks/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "addons/checks/loose_nodes.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/along_boundary.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

using Notes = std::vector<std::string>;

std::string place(const Eigen::RowVector2d& x) { return text('(', x.x(), ", ", x.y(), ')'); }

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
    notes.push_back(
        text("body '", mesh.name, "': ", hangs - loose.begin(),
             " nodes coincide with others that they are not joined to; the first is node ",
             first.node, " at ", place(mesh.nodes.row(first.node)), ", beside node ", first.other,
             ". The body can open there: unless a crack is meant, let the cells share "
             "these nodes (in Gmsh: Coherence Mesh)"));
  }
  if (hangs != loose.end()) {
    const std::vector<Index> ends = mesh.side_nodes(hangs->side);
    notes.push_back(
        text("body '", mesh.name, "': ", loose.end() - hangs,
             " nodes hang on the side of a cell that does not have them; the first is node ",
             hangs->node, " at ", place(mesh.nodes.row(hangs->node)), ", between the nodes ",
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
  integrate_boundary(mesh, load.boundary, [&](const BoundaryPoint& at) {
    const Vector2d position = at.point.position();
    sum.add(at.point - first,
            at.weight * at.tangent.norm() * depth.part(position.x()) * load.traction(position));
  });
  return sum;
}

bool is_closed(const Mesh& mesh, const std::string& name) {
  const std::vector<CellSide>& sides = boundary(mesh, name);
  return mesh.side_nodes(sides.front()).front() == mesh.side_nodes(sides.back()).back();
}

void note_edge_load(const Mesh& mesh, const EdgeLoad& load, const Depth& depth, Notes& notes) {
  const std::string what = text("load on '", load.boundary, "' of '", mesh.name, "'");
  const Resultant sum = load.traction ? resultant(mesh, load, depth) : Resultant{};
  constexpr double cancelled = 1e-6;
  if (load.pressure == 0 && sum.all_forces == 0)
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

/// The most of something, and where it is.
struct Most {
  double value = 0;
  const BodyModel* body = nullptr;
  Index cell = -1;

  void see(double other, const BodyModel& its_body, Index its_cell) {
    if (other > value) *this = {other, &its_body, its_cell};
  }
};

/// Mean of the displacement gradient over a cell, as if its sides were and stayed straight.
Eigen::Matrix2d mean_gradient(const Mesh& mesh, const NodeArray& displacements, Index cell) {
  const int corners = mesh.corners(cell);
  const auto corner = [&](int k) { return mesh.cells(cell, k < corners ? k : 0); };
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
  double twice_area = 0;
  for (int k = 1; k < corners; ++k) {
    const Eigen::RowVector2d chord = mesh.nodes.row(corner(k + 1)) - mesh.nodes.row(corner(k - 1));
    const Eigen::RowVector2d arm = mesh.nodes.row(corner(k)) - mesh.nodes.row(corner(0));
    const Eigen::RowVector2d moved = displacements.row(corner(k)) - displacements.row(corner(0));
    const Eigen::RowVector2d across(chord.y(), -chord.x());
    gradient += moved.transpose() * across;
    twice_area += arm.dot(across) / 2;
  }
  return gradient / twice_area;
}

/// Strain around the axis of a body of revolution, in the middle of a cell.
double hoop_strain(const Mesh& mesh, const NodeArray& displacements, Index cell) {
  double radius = 0;
  double opening = 0;
  for (int k = 0; k < mesh.corners(cell); ++k) {
    radius += mesh.nodes(mesh.cells(cell, k), 0);
    opening += displacements(mesh.cells(cell, k), 0);
  }
  return opening / radius;
}

/// Largest strain and rotation [rad] of the cells.
std::pair<Most, Most> deformation(const Model& model, const Solution& solution) {
  Most strain;
  Most rotation;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    if (body.material.base.law != nullptr) continue;
    for (Index cell = 0; cell < body.mesh.n_cells(); ++cell) {
      const Eigen::Matrix2d G = mean_gradient(body.mesh, solution.displacements[b], cell);
      const double half = (G(0, 0) - G(1, 1)) / 2;
      const double shear = (G(0, 1) + G(1, 0)) / 2;
      strain.see(std::abs(G(0, 0) + G(1, 1)) / 2 + std::sqrt(half * half + shear * shear), body,
                 cell);
      rotation.see(std::abs(G(1, 0) - G(0, 1)) / 2, body, cell);
      if (is_axial(body))
        strain.see(std::abs(hoop_strain(body.mesh, solution.displacements[b], cell)), body, cell);
    }
  }
  return {strain, rotation};
}

/// Young's modulus as far as its material takes strains for small.
double small_modulus(const Material& material) {
  return material.law == nullptr ? material.youngs_modulus : std::numeric_limits<double>::infinity();
}

/// That of the softest cell around every node of all bodies.
Eigen::VectorXd softest_around(const std::vector<BodyModel>& bodies) {
  Eigen::VectorXd softest(count_nodes(bodies));
  for (const BodyModel& body : bodies) {
    const MaterialField& material = body.material;
    auto own = softest.segment(body.first_node, body.mesh.n_nodes());
    own.setConstant(material.others.empty() ? small_modulus(material.base)
                                            : std::numeric_limits<double>::infinity());
    for (Index cell = 0; cell < static_cast<Index>(material.number_of.size()); ++cell) {
      const double modulus = small_modulus(material.of(cell));
      for (Index k = 0; k < body.mesh.cell_size(cell); ++k) {
        double& at_node = own(body.mesh.cells(cell, k));
        at_node = std::min(at_node, modulus);
      }
    }
  }
  return softest;
}

/// Largest contact pressure over Young's modulus of the softer side, and its pair.
std::pair<double, Index> largest_pressure(const Model& model, const Eigen::VectorXd& pressure) {
  std::pair<double, Index> most = {0, -1};
  if (pressure.size() == 0) return most;
  const Eigen::VectorXd softest = softest_around(model.bodies);
  for (Index pair = 0; pair < pressure.size(); ++pair) {
    double modulus = std::numeric_limits<double>::infinity();
    for (NodalRows::InnerIterator it(model.pairs.opening, pair); it; ++it)
      modulus = std::min(modulus, softest(it.col() / 2));
    most = std::max(most, std::pair(pressure(pair) / modulus, pair));
  }
  return most;
}

/// What is too large, in words; empty if nothing is.
std::string exceeded(const Model& model, const Solution& solution, const SmallLimits& limits) {
  const auto [strain, rotation] = deformation(model, solution);
  const auto [pressure, pair] = largest_pressure(model, solution.pressure);
  const auto where = [](const Most& most) {
    const Mesh& mesh = most.body->mesh;
    return text(" in cell ", most.cell, " of '", mesh.name, "' at ",
                place(mesh.nodes.row(mesh.cells(most.cell, 0))));
  };
  std::string list;
  if (strain.value > limits.strain)
    list += text(", strain ", 100 * strain.value, " %", where(strain));
  if (const double degrees = rotation.value * 180 / pi; degrees > limits.rotation)
    list += text(", rotation ", degrees, " degrees", where(rotation));
  if (pressure > limits.pressure)
    list += text(", contact pressure ", pressure, " of Young's modulus at ",
                 place(model.pairs.position.row(pair)));
  if (list.empty()) return list;
  const bool absurd = strain.value > 1 || pressure > 1;
  return text("linear elasticity takes deformations for small, but here they are not: ",
              list.substr(2), ". ",
              absurd ? "So much comes of units mostly: compare those of lengths, loads and Young's "
                       "modulus"
                     : "The numbers are those of the linear problem, but a body would do something "
                       "else: give it a law of finite strain (law = \"neo_hooke\", with [[steps]]), "
                       "take a smaller load, or the numbers for a first guess");
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

std::vector<std::string> solution_warnings(const Model& model, const Solution& solution,
                                           const SmallLimits& limits) {
  Notes notes;
  const Eigen::VectorXd& force = solution.contact.force;
  if (force.size() > 0 && force.maxCoeff() <= 0) {
    Index nearest = 0;
    const double gap = solution.contact.gap.minCoeff(&nearest);
    notes.push_back(
        text("no pair carries a force, contact changes nothing: the smallest gap left is ", gap,
             ", at ", place(model.pairs.position.row(nearest)),
             ". If the sides should press on each other, check the gap and the direction "
             "of the load"));
  }
  notes.push_back(exceeded(model, solution, limits));
  if (notes.back().empty()) notes.pop_back();
  return notes;
}

}  // namespace signorini
