// # Where a law ends
//
// Whether a material is stable is asked of a plane wave. It moves planes of the normal n along a direction a, by
// little, and meets the resistance
// \f[ a \cdot Q(n)\,a, \qquad Q_{ik}(n) = n_J A_{iJkL} n_L, \qquad A = \frac{\partial P}{\partial F}. \f]
// If that is positive for all of them, the law is *strongly elliptic*. If it is negative for one, a thin band of the material gives way
// with nobody pressing, and nothing in the equations says how thin: on a mesh it is a cell, so finer meshes give other answers.
//
// St Venant and Kirchhoff's law loses it in compression. Pressed to the stretch s between walls that hold its sides it has the stress
// \f$ (\lambda + 2\mu)(s^2 - 1)/2 \f$, which is a load of the planes that it presses on. Planes that lie askew give way first: at
// \f$ s = 2 - \sqrt 2 = 0.586 \f$ without lateral strain, at 0.706 for \f$ \nu = 0.3 \f$ and at 0.906 for 0.45.

#include "addons/motion/law_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/cells.hpp"

namespace signorini {

using Eigen::Index;

double least_wave_stiffness(const StressResponse& response) {
  // Between two of them lie 6 degrees: of a least value in the middle the cosine of 3 degrees is missed, .1 %.
  static const std::array<Eigen::Vector2d, 32> directions = [] {
    std::array<Eigen::Vector2d, 32> all;
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k] = {std::cos(pi * static_cast<double>(k) / 32), std::sin(pi * static_cast<double>(k) / 32)};
    return all;
  }();
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& n : directions) {
    const auto along = [&](Index i, Index j) { return n.dot(response.tangent.block<2, 2>(2 * i, 2 * j) * n); };
    const double mean = (along(0, 0) + along(1, 1)) / 2;
    const double half = (along(0, 0) - along(1, 1)) / 2;
    const double askew = along(0, 1);
    if (mean - std::abs(half) - std::abs(askew) < least)  // else it is not the least, and needs no root
      least = std::min(least, mean - std::hypot(half, askew));
  }
  return least;
}

std::vector<std::string> notes_on_laws(const Model& model, const Solution& solution) {
  std::vector<std::string> notes;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    if (body.material.base.law == nullptr) continue;  // and so no layer has a law, see finite_strain()
    Index lost = 0;
    std::string where;
    std::string name;  // of the law of the first of them
    visit_cells(body.mesh, body.element, body.material, [&](const Cell& cell) {
      const StrainLaw* law = cell.material.law;
      if (law->stability == nullptr) return;
      if (law->stability(cell, less_shift(cell, solution.displacements[b])) >= 0) return;
      if (lost++ > 0) return;
      name = law->name;
      where = text("cell ", cell.number, ", at (", cell.body.middle.x(), ", ", cell.body.middle.y(), ") before it moved");
    });
    if (lost > 0)
      notes.push_back(text("body '", body.mesh.name, "': its law ", name,
                           " has lost its strong ellipticity in ", lost, lost == 1 ? " cell" : " cells", ", as in ", where,
                           ": thin bands give way there by themselves, and finer meshes give other answers; press it less, "
                           "or take neo_hooke"));
  }
  return notes;
}

}  // namespace signorini
