// Partial slip of a cylinder along a path: pressed, pushed to Q = 0.6 mu P, and back to -0.6 mu P.
#include <cmath>

#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "closed_form/cattaneo.hpp"
#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "meshes/hertz_meshes.hpp"
#include "meshes/reshape.hpp"

using namespace signorini;
using Eigen::Index;

namespace {

constexpr double mu = 0.3;
constexpr double radius = 50;
constexpr double modulus = 4000;
constexpr double ratio = 0.35;

Mesh whole(const Mesh& half) {
  return joined(half, "axis", mirrored(half, MirrorLine::Upright), "axis");
}

/// A half cylinder that is pressed down by `depth`, then pushed by Q = push(t) along a plane of its own material.
Scene pushed(Index cells, double depth, const History& push, const std::vector<double>& times) {
  HertzMeshSpec spec;
  spec.core = 0.95;
  spec.disc_cells = spec.plate_cells = cells;
  spec.disc_rows = spec.plate_rows = 3 * cells / 4;
  spec.disc_layers = 30;
  spec.plate_layers = 31;
  const HertzMeshes halves = make_hertz_meshes(spec);
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = whole(halves.disc);
  scene.bodies[1].mesh = whole(halves.plate);
  for (Body& body : scene.bodies) body.material = {modulus, ratio, PlaneState::Strain, 1};
  Support down = prescribed("middle", Axis::Y, -depth);
  down.history = "press";
  scene.bodies[0].supports = {down};
  scene.bodies[0].loads.edges = {
      {"middle", 0, [](const Eigen::Vector2d&) { return Eigen::Vector2d(0.5 / radius, 0); }}};
  scene.bodies[0].loads.edges[0].history = push.name;
  scene.bodies[1].supports = {fixed("base")};
  scene.contacts = {
      {{"rim", scene.bodies[0].mesh.name}, Side{"surface", scene.bodies[1].mesh.name}}};
  scene.contacts[0].friction = Friction{mu, 0};
  scene.path = Path{times, {{"press", {0, 1}, {0, 1}}, push}};
  return scene;
}

struct PartialSlipPath {
  double stick;              ///< half-width of what sticks at Q = 0.6 mu P, over the exact one
  double growing;            ///< rms of the traction there, over mu q0
  double back[3];            ///< the same at 0, -0.3 and -0.6 mu P on the way back
  double without_memory[3];  ///< and of the same loads in one step
  double resultant;          ///< worst miss of the sum of tractions
  double nodes;
  Index most_solves = 0;
};

double rms(const Model& model, const Step& step, const PartialSlip& slip, double turned,
           double force) {
  double sum = 0;
  double length = 0;
  for (Index k = 0; k < model.pairs.weight.size(); ++k) {
    const double x = model.pairs.position(k, 0);
    if (std::abs(x) > slip.half_width) continue;
    const double exact =
        turned > 0 ? slip_traction_back(slip, turned, force, x) : slip_traction(slip, force, x);
    // What the push does to the disc, friction resists.
    const double found = -step.solution.contact.friction(k) / model.pairs.weight(k);
    sum += model.pairs.weight(k) * std::pow(found - exact, 2);
    length += model.pairs.weight(k);
  }
  return std::sqrt(sum / length) / (mu * slip.peak_pressure);
}

/// Half-width c of the part that sticks, read from all of it: what friction has left there to its bound is
/// \f$ \mu q_0 \sqrt{c^2 - x^2} / b \f$.
double stuck_half_width(const Model& model, const Step& step, const PartialSlip& slip) {
  const ContactState& contact = step.solution.contact;
  double sum = 0;
  double length = 0;
  for (Index k = 0; k < model.pairs.weight.size(); ++k) {
    if (contact.contact_status[static_cast<std::size_t>(k)] != ContactStatus::Stick) continue;
    const double weight = model.pairs.weight(k);
    const double left = (mu * contact.force(k) - std::abs(contact.friction(k))) / weight;
    const double x = model.pairs.position(k, 0);
    sum += weight * (x * x + std::pow(slip.half_width * left / (mu * slip.peak_pressure), 2));
    length += weight;
  }
  return std::sqrt(sum / length);
}

PartialSlipPath run(Index cells, double depth) {
  const History none{"push", {1}, {0}};
  PartialSlip slip{};
  double P = 0;
  PathEnd end = solve_steps(pushed(cells, depth, none, {1}), [&](const Model&, const Step& step) {
    P = step.solution.contact.force.sum();
  });
  REQUIRE(end.status == SolveStatus::Solved);
  const double plane = plane_strain_modulus(modulus, ratio);
  const LineContact contact{radius, contact_modulus(plane, plane), P};
  slip = {hertz_half_width(contact), hertz_peak_pressure(contact), mu};
  const double Q = 0.6 * mu * P;
  const History push{"push", {1, 2, 4}, {0, Q, -Q}};
  std::vector<double> times = equal_steps(24, 4);
  times.erase(times.begin(), times.begin() + 5);  // pressed in one step
  PartialSlipPath result{};
  const auto error_at = [&](const Model& model, const Step& step, double* back) {
    const double time = step.state.time;
    for (int k = 0; k < 3; ++k)
      if (time == 3 + 0.5 * k) back[k] = rms(model, step, slip, Q, push.at(time));
  };
  const Scene scene = pushed(cells, depth, push, times);
  end = solve_steps(scene, [&](const Model& model, const Step& step) {
    const double time = step.state.time;
    const double now = push.at(time);
    result.resultant =
        std::max(result.resultant, std::abs(step.solution.contact.friction.sum() + now) / (mu * P));
    if (time > 1)
      result.most_solves =
          std::max(result.most_solves, Index(step.solution.ledger.counted("refinement", "solves")));
    if (time == 2) {
      result.growing = rms(model, step, slip, 0, now);
      result.stick = stuck_half_width(model, step, slip) / stick_half_width(slip, now);
    }
    error_at(model, step, result.back);
    result.nodes = double(model.bodies[0].mesh.n_nodes() + model.bodies[1].mesh.n_nodes());
  });
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  for (int k = 0; k < 3; ++k)  // slip in total: friction knows the present load only
    static_cast<void>(solve_steps(pushed(cells, depth, push, {3 + 0.5 * k}),
                                  [&](const Model& model, const Step& step) {
                                    error_at(model, step, result.without_memory);
                                  }));
  return result;
}

}  // namespace

TEST_CASE("Cattaneo and Mindlin along a path: growth, return, and what forgetting would miss",
          "[steps][friction][closed-form]") {
  const PartialSlipPath path = run(32, 0.03);
  CAPTURE(path.nodes, path.stick, path.growing, path.resultant, path.most_solves);
  CAPTURE(path.back[0], path.back[1], path.back[2]);
  CAPTURE(path.without_memory[0], path.without_memory[1], path.without_memory[2]);
  CHECK(path.resultant <= 1e-11);
  CHECK(path.stick == Approx(1).margin(0.003));
  CHECK(path.growing <= 0.012);
  for (const double error : path.back) CHECK(error <= 0.05);
  for (int k = 0; k < 2; ++k) CHECK(path.without_memory[k] >= 0.1);
  CHECK(path.without_memory[2] <= 0.05);  // at -0.6 mu P all that the way there did is slid over
  CHECK(path.most_solves <= 4);
}
