// How two sides fit before anything moves: adjusted gaps and interference. What they make of the gaps is in the line
// of the contact.
#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/checks/fit_doubts.hpp"
#include "addons/effects/fit.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

/// One of the two lengths.
using Fit = std::optional<double> ContactSpec::*;

bool any_has(const Scene& scene, Fit length) {
  return std::any_of(scene.contacts.begin(), scene.contacts.end(), [=](const ContactSpec& contact) {
    return (contact.*length).value_or(0) != 0;
  });
}

void price_fit(const Scene& scene, Plan& draft, Fit length, const std::string& name) {
  for (const ContactSpec& contact : scene.contacts) {
    const double given = (contact.*length).value_or(0);
    const std::string what = text(name, " of the ", describe(draft.bodies, contact));
    pose(std::isfinite(given) && given >= 0, what, " must be a length >= 0, got ", given);
    if (given <= 0) continue;
    draft.on.push_back(text(what, ": ", given));
    std::string doubt = doubt_of_fit(contact, draft.bodies, name, given);
    if (!doubt.empty()) draft.notes.push_back(std::move(doubt));
  }
}

}  // namespace

std::string fit(const ContactSpec& contact, Pairs& pairs) {
  std::string words;
  const double small = contact.adjust.value_or(0);
  if (small != 0) {
    const Eigen::ArrayXd gap = pairs.initial_gap;
    pairs.initial_gap = (gap.abs() <= small).select(0, gap);
    const Eigen::ArrayXd moved = (gap - pairs.initial_gap.array()).abs();
    words += text(", ", (moved > 0).count(), " of them adjusted by up to ",
                  moved.size() > 0 ? moved.maxCoeff() : 0);
  }
  const double closer = contact.interference.value_or(0);
  if (closer != 0) {
    pairs.initial_gap.array() -= closer;
    words += text(", all closer by ", closer);
  }
  return words;
}

namespace effect {

Effect adjusted_gaps() {
  return {"adjusted gaps",
          [](const Scene& scene, const Plan& /*draft*/) {
            return any_has(scene, &ContactSpec::adjust);
          },
          [](const Scene& scene, Plan& draft) {
            price_fit(scene, draft, &ContactSpec::adjust, "adjusted gaps");
          },
          nullptr};
}

Effect interference() {
  return {"interference",
          [](const Scene& scene, const Plan& /*draft*/) {
            return any_has(scene, &ContactSpec::interference);
          },
          [](const Scene& scene, Plan& draft) {
            price_fit(scene, draft, &ContactSpec::interference, "interference");
          },
          nullptr};
}

}  // namespace effect
}  // namespace signorini
