// The problems that the estimator is measured on, on any mesh and with any element, and what comes out.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "addons/estimate/estimate.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/scene/readings.hpp"
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
  std::vector<Eigen::Index> cells = {};  ///< of four meshes, rising
  Eigen::Index fine = 0;                 ///< of the mesh that is taken for the truth
  double friction = 0;                   ///< coefficient of Coulomb's law
};

/// The cantilever of chapter 6. Goals: force, deflection.
inline Measured measured_cantilever() {
  using namespace signorini;
  return {"cantilever",
          {{"force", NormalForce{}}, {"deflection", Displacement{"", Axis::Y, "", {{26, 5}}}}},
          [](const std::string& element, Eigen::Index cells) {
            return cantilever(element, cells, std::max<Eigen::Index>(cells / 10, 3));
          },
          {30, 50, 100, 200},
          500};
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
          },
          {12, 16, 24, 32},
          64};
}

/// The same cylinder, pushed down by its middle. Goal: the force that this takes.
inline Measured measured_push() {
  using namespace signorini;
  return {"push",
          {{"force", NormalForce{}}},
          [](const std::string& element, Eigen::Index cells) {
            Scene scene = measured_hertz().scene(element, cells);
            scene.bodies[0].loads.edges.clear();
            scene.bodies[0].supports.push_back(prescribed("middle", Axis::Y, -0.06));
            return scene;
          },
          {12, 16, 24, 32},
          64};
}

/// The footing of chapter 13 on so many cells under its half. Goals: force within 0.8 a, fading to its edge; settlement.
inline Measured measured_footing() {
  using namespace signorini;
  const auto fading = [](const Eigen::Vector2d& x) {
    return std::clamp((footing_half - x.x()) / (0.2 * footing_half), 0.0, 1.0);
  };
  return {"footing",
          {{"force", NormalForce{"", fading}},
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
          },
          {15, 18, 24, 36},
          120};
}

/// The pin of chapter 7, reading (T), on so many cells around the half hole. Goals: pull, force across the pull.
inline Measured measured_pin() {
  using namespace signorini;
  return {"pin",
          {{"pull", Displacement{"", Axis::X, "", {{10, 0}}}},
           {"force", NormalForce{"", [](const Eigen::Vector2d& x) { return x.y() / 5; }}}},
          [](const std::string& element, Eigen::Index cells) {
            return pin_in_plate(-25, cells, cells / 2, 0.2, element);
          },
          {24, 48, 72, 96},
          216};
}

/// The same with friction after Coulomb.
inline Measured frictional_pairs(Measured problem, double coefficient) {
  problem.name += " with friction";
  problem.friction = coefficient;
  problem.scene = [smooth = problem.scene, coefficient](const std::string& element,
                                                        Eigen::Index cells) {
    signorini::Scene scene = smooth(element, cells);
    scene.contacts[0].friction = signorini::Friction{coefficient};
    return scene;
  };
  return problem;
}

/// The three of them that are measured with friction.
inline std::vector<Measured> measured_with_friction() {
  return {frictional_pairs(measured_cantilever(), 0.02), frictional_pairs(measured_footing(), 0.1),
          frictional_pairs(measured_pin(), 0.2)};
}

/// Hertz's contact on meshes that differ in fineness, in the size of the core and in whether they match: five of each
/// number of cells.
inline std::vector<signorini::HertzMeshSpec> hertz_layouts(const std::vector<Eigen::Index>& cells) {
  std::vector<signorini::HertzMeshSpec> layouts;
  for (const Eigen::Index along : cells)
    for (const double core : {1.3, 1.4, 1.5})
      for (const Eigen::Index more : {0, 3}) {
        if (core == 1.5 && more != 0) continue;
        signorini::HertzMeshSpec spec;
        spec.core = core;
        spec.disc_cells = spec.disc_layers = spec.plate_layers = along;
        spec.plate_cells = along + more;
        spec.disc_rows = spec.plate_rows = 3 * along / 4;
        layouts.push_back(spec);
      }
  return layouts;
}

/// Values of the goals by so many cells of eight nodes; half-width and peak of Hertz as in the closed form.
inline std::vector<double> truth_of(const Measured& problem, Eigen::Index cells) {
  using namespace signorini;
  const SolvedScene run = solved(problem.scene("q8", cells), problem.name);
  const LineContact theory = HertzProblem{}.theory();
  std::vector<double> truth;
  for (const Goal& goal : problem.goals)
    truth.push_back(std::holds_alternative<HalfWidth>(goal.quantity) ? hertz_half_width(theory)
                    : std::holds_alternative<PeakPressure>(goal.quantity)
                        ? hertz_peak_pressure(theory)
                        : value(run.model, run.solution, goal));
  return truth;
}

/// One goal on one mesh.
struct Measurement {
  Eigen::Index nodes;
  signorini::Estimate estimate;
  double truth;

  [[nodiscard]] double effectivity() const {
    const double error = truth - estimate.value;
    return estimate.error / (estimate.is_signed ? error : std::abs(error));
  }
  [[nodiscard]] bool good() const { return effectivity() >= 0.5 && effectivity() <= 2; }
};

inline std::vector<Measurement> measured(const signorini::Scene& scene,
                                         const std::vector<signorini::Goal>& goals,
                                         const std::vector<double>& truth) {
  using namespace signorini;
  const SolvedScene run = solved(scene, "scene");
  Ledger unused;
  const std::vector<Estimate> all =
      estimates(run.model, run.condensed, run.solution, goals, unused);
  Eigen::Index nodes = 0;
  for (const BodyModel& body : run.model.bodies) nodes += body.mesh.n_nodes();
  std::vector<Measurement> of_goals;
  for (std::size_t k = 0; k < all.size(); ++k) of_goals.push_back({nodes, all[k], truth[k]});
  return of_goals;
}

}  // namespace signorini_test
