// Whether a solution is one for which linear elasticity can be meant.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "addons/checks/point_supports.hpp"
#include "addons/checks/warnings.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;

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
  return material.law == nullptr ? material.youngs_modulus
                                 : std::numeric_limits<double>::infinity();
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
                in_brackets(mesh.nodes.row(mesh.cells(most.cell, 0))));
  };
  std::string list;
  if (strain.value > limits.strain)
    list += text(", strain ", 100 * strain.value, " %", where(strain));
  if (const double degrees = rotation.value * 180 / pi; degrees > limits.rotation)
    list += text(", rotation ", degrees, " degrees", where(rotation));
  if (pressure > limits.pressure)
    list += text(", contact pressure ", pressure, " of Young's modulus at ",
                 in_brackets(model.pairs.position.row(pair)));
  if (list.empty()) return list;
  const bool absurd = strain.value > 1 || pressure > 1;
  if (model.loop)
    return text("strains of bodies without a law are taken for small, but here they are not: ",
                list.substr(2),
                ". Give their materials a law of finite strain, as law = \"neo_hooke\"");
  const bool at_points = absurd && !point_supports(model, solution).empty();
  return text(
      "linear elasticity takes deformations for small, but here they are not: ", list.substr(2),
      ". ",
      at_points ? "So much comes of what bears a force without an area, as another note says"
      : absurd  ? "So much comes of units mostly: compare those of lengths, loads and Young's "
                  "modulus"
                : "The numbers are those of the linear problem, but a body would do something "
                  "else: give it a law of finite strain (law = \"neo_hooke\", with [[steps]]), "
                  "take a smaller load, or the numbers for a first guess");
}

}  // namespace

std::vector<std::string> solution_warnings(const Model& model, const Solution& solution,
                                           const SmallLimits& limits) {
  std::vector<std::string> notes;
  const Eigen::VectorXd& force = solution.contact.force;
  if (force.size() > 0 && force.maxCoeff() <= 0) {
    Index nearest = 0;
    const double gap = solution.contact.gap.minCoeff(&nearest);
    notes.push_back(
        text("no pair carries a force, contact changes nothing: the smallest gap left is ", gap,
             ", at ", in_brackets(model.pairs.position.row(nearest)),
             ". If the sides should press on each other, check the gap and the direction "
             "of the load"));
  }
  notes.push_back(exceeded(model, solution, limits));
  if (notes.back().empty()) notes.pop_back();
  return notes;
}

}  // namespace signorini
