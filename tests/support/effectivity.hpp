// The problems that the estimator is measured on, on any mesh and with any element.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "signorini/elasticity/elements.hpp"
#include "signorini/estimate/goal.hpp"
#include "support/cantilever.hpp"
#include "support/footing.hpp"
#include "support/hertz.hpp"
#include "support/pin.hpp"

namespace signorini_test {

/// A problem, what it is asked for, and meshes of so many cells along the contact.
struct Measured {
  std::string name;
  std::vector<signorini::Goal> goals;
  std::function<signorini::Scene(const std::string& element, Eigen::Index cells)> scene;
};

/// The cantilever of chapter 6. Goals: force, deflection.
inline Measured measured_cantilever() {
  using namespace signorini;
  return {"cantilever",
          {{"force", ContactForce{}}, {"deflection", Displacement{"", Axis::Y, "", {{26, 5}}}}},
          [](const std::string& element, Eigen::Index cells) {
            return cantilever(element, cells, std::max<Eigen::Index>(cells / 10, 3));
          }};
}

/// Hertz's cylinder, chapter 11, on so many cells to 1.3 half-widths. Goals: half-width, peak, sinking, approach.
inline Measured measured_hertz() {
  using namespace signorini;
  return {"Hertz",
          {{"half-width", HalfWidth{}},
           {"peak", PeakPressure{}},
           {"sinking", Displacement{"disc", Axis::Y, "", {{0, 0}}}},
           {"approach", Displacement{"disc", Axis::Y, "middle"}}},
          [](const std::string& element, Eigen::Index cells) {
            HertzMeshSpec spec;
            spec.disc_cells = spec.plate_cells = spec.disc_layers = spec.plate_layers = cells;
            spec.disc_rows = spec.plate_rows = 3 * cells / 4;
            return hertz(spec, element.c_str());
          }};
}

/// The same cylinder, pushed down by its middle. Goal: the force that this takes.
inline Measured measured_push() {
  using namespace signorini;
  return {"push", {{"force", ContactForce{}}}, [](const std::string& element, Eigen::Index cells) {
            Scene scene = measured_hertz().scene(element, cells);
            scene.bodies[0].loads.edges.clear();
            scene.bodies[0].supports.push_back(prescribed("middle", Axis::Y, -0.06));
            return scene;
          }};
}

/// The footing of chapter 13 on so many cells under its half. Goals: force within 0.8 a, fading to its edge; settlement.
inline Measured measured_footing() {
  using namespace signorini;
  const auto fading = [](const Eigen::Vector2d& x) {
    return std::clamp((footing_half - x.x()) / (0.2 * footing_half), 0.0, 1.0);
  };
  return {"footing",
          {{"force", ContactForce{"", fading}},
           {"settlement", Displacement{"soil", Axis::Y, "", {{0, 0}}}}},
          [](const std::string& element, Eigen::Index cells) {
            const Element& cell = find_element(element);
            EdgeBlockSpec soil = soil_spec(cells, 4 * cells / 3, cells, 16, 60);
            soil.order = order_of(cell);
            FootingSpec footing;
            footing.rows = cells / 3;
            Scene scene = footing_on(soil, footing);
            for (Body& body : scene.bodies) {
              body.mesh = fitting(body.mesh, cell);
              body.element = element;
            }
            return scene;
          }};
}

/// The pin of chapter 7, reading (T), on so many cells around the half hole. Goals: pull, force across the pull.
inline Measured measured_pin() {
  using namespace signorini;
  return {"pin",
          {{"pull", Displacement{"", Axis::X, "", {{10, 0}}}},
           {"force", ContactForce{"", [](const Eigen::Vector2d& x) { return x.y() / 5; }}}},
          [](const std::string& element, Eigen::Index cells) {
            return pin_in_plate(-25, cells, cells / 2, 0.2, element);
          }};
}

}  // namespace signorini_test
