/// \file
/// A cylinder on rock or on a plate, and what may be switched on besides.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "signorini/closed_form/hertz_fit.hpp"
#include "signorini/closed_form/moduli.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/mesh/hertz_meshes.hpp"
#include "signorini/report/field_csv.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {

// [data]
constexpr double R = 50;                                        // radius of the cylinder [mm]
constexpr double P = 41.76;                                     // load on all of it [N/mm]
const Material resin{4000, 0.35, PlaneState::Strain, 1, 6e-5};  // E [MPa], nu, ., 1 mm, alpha [1/K]
constexpr double specific_weight = 1.2e-5;                      // of resin [N/mm^3]
constexpr double friction = 0.3;                                // mu [-]
constexpr double warmer = 100;                                  // by so much [K]
constexpr double thin = 3;                                      // thickness of a thin plate [mm]
// [data]
/// Free expansion in plane strain, (1 + nu) alpha Delta T [-].
const double thermal = (1 + resin.poisson_ratio) * resin.expansion * warmer;
const double stiff = plane_strain_modulus(resin.youngs_modulus, resin.poisson_ratio);  // E' [MPa]

/// Right halves of both bodies. \param thickness  of the plate [mm] \return fine where they touch
inline HertzMeshes meshes(double thickness) {
  HertzMeshSpec spec;
  spec.radius = R;
  spec.plate.y() = thickness;
  spec.disc_cells = spec.plate_cells = 40;
  spec.disc_rows = spec.plate_rows = 20;
  spec.disc_layers = spec.plate_layers = 20;
  return make_hertz_meshes(spec);
}

// [rungs]
/// 1. The cylinder on rock, its middle pushed down. \param depth  by so much [mm]
inline Scene on_rock(double depth) {
  Scene scene;
  Body& disc = scene.bodies[0];
  disc.mesh = meshes(95).disc;
  disc.material = resin;
  disc.supports = {symmetric("axis"), prescribed("middle", Axis::Y, -depth)};
  scene.contacts = {{{"rim", "disc"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

/// 2. A second body: a plate in the place of the rock. \param scene  with the cylinder alone
inline Scene with_plate(Scene scene, double thickness = 95) {
  Body& plate = scene.bodies.emplace_back();
  plate.mesh = meshes(thickness).plate;
  plate.material = resin;
  plate.supports = {symmetric("axis"), fixed("base")};
  scene.contacts[0].target = Side{"surface", "plate"};
  return scene;
}

/// 3. Pressed by a load and held by contact alone. \param scene  with a pushed cylinder
inline Scene floating(Scene scene) {
  scene.bodies[0].supports = {symmetric("axis")};
  scene.bodies[0].loads.edges = {{"middle", P / (2 * R), {}}};
  return scene;
}

/// 4. Friction. \param scene  any
inline Scene with_friction(Scene scene) {
  scene.contacts[0].friction = Friction{friction, 0};
  return scene;
}

/// 5. A warm cylinder. \param scene  any
inline Scene heated(Scene scene) {
  scene.bodies[0].temperature = Temperature{warmer, {0, 0}};
  return scene;
}
// [rungs]

/// Its own weight. \param scene  any
inline Scene with_weight(Scene scene) {
  scene.bodies[0].loads.body_force = [](const Eigen::Vector2d& /*x*/) {
    return Eigen::Vector2d(0, -specific_weight);
  };
  return scene;
}

/// Largest pressure of the ellipse that fits the nodes best. \param run  solved \return [MPa]
inline double peak_pressure(const SolvedScene& run) {
  const Pairs& pairs = run.model.pairs;
  std::vector<double> x, pressure;
  for (Eigen::Index k = 0; k < pairs.weight.size(); ++k) {
    x.push_back(pairs.position(k, 0));
    pressure.push_back(run.solution.pressure(k));
  }
  return fit_hertz(x, pressure).peak_pressure;
}

/// Operations of a whole solution. \param ledger  of it \return factor, condensation and all solves
inline double work(const Ledger& ledger) {
  double sum = 0;
  for (const LedgerEntry& entry : ledger.entries())
    if (const auto found = entry.counts.find("operations"); found != entry.counts.end())
      sum += static_cast<double>(found->second);
  return sum;
}

/// Something that is seldom meant.
struct Mistake {
  std::string what;
  std::function<void(Scene&)> make;
};

/// \return mistakes to be made in the scene of the floating cylinder on a plate
// [mistakes]
inline std::vector<Mistake> mistakes() {
  return {{"friction that pulls",
           [](Scene& s) {
             s.contacts[0].friction = Friction{-0.3, 0};
           }},
          {"a body that nothing holds", [](Scene& s) { s.contacts.clear(); }},
          {"the same contact twice", [](Scene& s) { s.contacts.push_back(s.contacts[0]); }},
          {"rock on the wrong side",
           [](Scene& s) {
             s.contacts[0].target = half_plane({0, 0}, {0, -1});
           }},
          {"heat without expansion",
           [](Scene& s) {
             s = heated(std::move(s));
             s.bodies[0].material.expansion = 0;
           }},
          {"an element that locks", [](Scene& s) {
             s.bodies[0].element = "q4";
             s.bodies[0].material.poisson_ratio = 0.49;
           }}};
}
// [mistakes]

/// Figure 18.1: the two meshes, coarser, and what the plan says where. \param folder  for its data
inline void draw(const std::filesystem::path& folder, const Plan& planned) {
  HertzMeshSpec spec;
  spec.disc_cells = spec.plate_cells = spec.disc_rows = spec.plate_rows = 5;
  spec.disc_layers = spec.plate_layers = 14;
  spec.core = 4;
  const HertzMeshes coarse = make_hertz_meshes(spec);
  const auto outlines = [](const Mesh& mesh) {
    return deformed_cells_csv(mesh, NodeArray::Zero(mesh.n_nodes(), 2),
                              Eigen::VectorXd::Zero(mesh.n_cells()), 0);
  };
  write_file(folder / "fig_18_1_disc.csv", outlines(coarse.disc));
  write_file(folder / "fig_18_1_plate.csv", outlines(coarse.plate));
  Table table({"y", "from_x", "from_y", "says"});
  const auto say = [&table](const char* y, const char* x, const char* at, const std::string& what) {
    table.row({y, x, at, what});
  };
  say("56", "46", "54", "load: numbers in p");
  say("44", "40", "40", text("cylinder: ", planned.bodies[0].unknowns.count, " unknowns"));
  say("32", "36", "28", "heat: numbers in p");
  say("20", "24", "12", text("held by contact alone: ", planned.modes.size(), " amplitude"));
  say("6", "2", "0.3", text("contact: ", planned.gaps.A.rows(), " gaps"));
  say("-6", "2", "-0.3", text("friction: ", planned.law.pair.size(), " slips"));
  say("-50", "80", "-50", text("plate: ", planned.bodies[1].unknowns.count, " unknowns"));
  write_file(folder / "fig_18_1.csv", table.csv());
}

}  // namespace signorini
