// How two sides fit before anything moves: adjusted gaps, and after them interference. The lengths are those of the meshes, so
// this comes before supports move anything: each effect hands a function to the effect contact, which has the pairs.
#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/effects/fit.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/plane.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// One of the two lengths.
using Fit = std::optional<double> ContactSpec::*;

bool any_has(const Scene& scene, Fit length) {
  return std::any_of(scene.contacts.begin(), scene.contacts.end(), [=](const ContactSpec& contact) {
    return (contact.*length).value_or(0) != 0;
  });
}

double area(const Mesh& mesh) {
  double twice = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int k = 2; k < mesh.corners(cell); ++k) {
      const Vector2d origin = mesh.nodes.row(mesh.cells(cell, 0)).transpose();
      const Vector2d a = mesh.nodes.row(mesh.cells(cell, k - 1)).transpose() - origin;
      const Vector2d b = mesh.nodes.row(mesh.cells(cell, k)).transpose() - origin;
      twice += std::abs(cross(a, b));
    }
  return twice / 2;
}

double thickness(const std::vector<BodyModel>& bodies, const Side& side) {
  const Surface there = surface(bodies, side);
  double length = 0;
  for (const SideCurve& curve : side_curves(there.mesh, there.boundary))
    length += (curve.point(1) - curve.point(-1)).norm();
  return area(there.mesh) / length;
}

void declare_fit(const Scene& scene, Plan& draft, Fit length, const std::string& name,
                 FitSides fit) {
  for (const ContactSpec& contact : scene.contacts) {
    const double given = (contact.*length).value_or(0);
    const std::string what = text(name, " of the ", describe(draft.bodies, contact));
    require_input(std::isfinite(given) && given >= 0, what, " must be a length >= 0, got ", given);
    if (given <= 0) continue;
    draft.on.push_back(text(what, ": ", given));
    std::string warning = fit_warning(contact, draft.bodies, name, given);
    if (!warning.empty()) draft.notes.push_back(std::move(warning));
  }
  draft.fits.push_back(fit);
}

std::string adjust(const ContactSpec& contact, Pairs& pairs) {
  const double small = contact.adjust.value_or(0);
  if (small == 0) return "";
  const Eigen::ArrayXd gap = pairs.initial_gap;
  pairs.initial_gap = (gap.abs() <= small).select(0, gap);
  const Eigen::ArrayXd moved = (gap - pairs.initial_gap.array()).abs();
  return text(", ", (moved > 0).count(), " of them adjusted by up to ",
              moved.size() > 0 ? moved.maxCoeff() : 0);
}

std::string press(const ContactSpec& contact, Pairs& pairs) {
  const double closer = contact.interference.value_or(0);
  if (closer == 0) return "";
  for (Index k = 0; k < pairs.initial_gap.size(); ++k)
    pairs.initial_gap(k) -= interference_at(contact, pairs.position.row(k).transpose());
  return text(contact.interference_share ? ", closer by up to " : ", all closer by ", closer);
}

}  // namespace

std::string fit_warning(const ContactSpec& contact, const std::vector<BodyModel>& bodies,
                        const std::string& name, double length) {
  double thin = thickness(bodies, contact.source);
  if (const Side* target = std::get_if<Side>(&contact.target))
    thin = std::min(thin, thickness(bodies, *target));
  if (length <= thin) return "";
  return text(name, " of the ", describe(bodies, contact), ": ", length,
              " is more than the thinner body is thick there, ", thin,
              ". Such a length is small beside the body: compare its unit with that of the mesh");
}

namespace effect {

Effect adjusted_gaps() {
  return {"adjusted gaps",
          [](const Scene& scene, const Plan& /*draft*/) {
            return any_has(scene, &ContactSpec::adjust);
          },
          [](const Scene& scene, Plan& draft) {
            declare_fit(scene, draft, &ContactSpec::adjust, "adjusted gaps", adjust);
          },
          nullptr};
}

Effect interference() {
  return {"interference",
          [](const Scene& scene, const Plan& /*draft*/) {
            return any_has(scene, &ContactSpec::interference);
          },
          [](const Scene& scene, Plan& draft) {
            declare_fit(scene, draft, &ContactSpec::interference, "interference", press);
          },
          nullptr};
}

}  // namespace effect
}  // namespace signorini
