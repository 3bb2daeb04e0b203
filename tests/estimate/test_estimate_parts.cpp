// What an estimate is made of: the ends of contact, each once, and residuals.
#include <algorithm>
#include <cmath>

#include "addons/estimate/contact_ends.hpp"
#include "addons/estimate/estimate.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "support/effectivity.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

namespace {

std::vector<Estimate> estimated(const SolvedScene& run, const std::vector<Goal>& goals) {
  Ledger ledger;
  return estimates(run.model, run.condensed, run.solution, goals, ledger);
}

}  // namespace

TEST_CASE("the free boundary of a contact with two ends is that of its half with one",
          "[estimate]") {
  // A block pressed on a hill: both ends move alike, and each counts once.
  const auto part = [](bool whole) {
    BlockSpec spec;
    spec.corner = {whole ? -2 : 0, 0};
    spec.size = {whole ? 4 : 2, 1};
    spec.cells_x = whole ? 40 : 20;
    spec.cells_y = 10;
    Scene scene;
    Body& body = scene.bodies[0];
    body.mesh = make_block(spec);
    body.element = "q4";
    body.material = {1000, 0.3, PlaneState::Strain, 1};
    body.supports = {whole ? prescribed_at("top", {0, 1}, Axis::X, 0) : symmetric("left")};
    body.loads.edges = {{"top", 3, {}}};
    const double R = 50;
    scene.contacts = {
        {{"bottom"},
         profile([=](double x) { return -x * x / (2 * R); }, [=](double x) { return -x / R; })}};
    const SolvedScene run = solved(scene, "block on a hill");
    const Dual dual(run.model, run.condensed, run.solution);
    CHECK(contact_ends(contact_edges(run.model), run.solution, dual).size() == (whole ? 2 : 1));
    return estimated(run, {{"top", Displacement{"", Axis::Y, "top"}}})[0].parts.free_boundary;
  };
  const double half = part(false);
  REQUIRE(half != 0);
  CHECK(part(true) == Approx(half).epsilon(0.01).margin(0));
}

TEST_CASE("the algebraic error of a gap that is missed is what it changes goals by",
          "[estimate][closed-form]") {
  SolvedScene run = solved(measured_cantilever().scene("q4", 20), "cantilever");
  const std::vector<Goal> goals = measured_cantilever().goals;
  const Index pair = run.solution.contact.active().front();
  run.model.programme.initial_gap(pair) += 1e-7;  // of another problem, which has its own solution
  const std::vector<Estimate> all = estimated(run, goals);
  Ledger ledger;
  const Condensed condensed = condense(run.model, ledger);
  const Solution other = solve(run.model, condensed, ledger);
  REQUIRE(other.contact.active() == run.solution.contact.active());
  for (std::size_t k = 0; k < goals.size(); ++k) {
    CAPTURE(goals[k].name);
    const double change = value(run.model, other, goals[k]) - all[k].value;
    CHECK(all[k].algebraic == Approx(std::abs(change)).epsilon(1e-5).margin(0));
  }
}

TEST_CASE("an end between two nodes of the other side is left out by what each of them bears",
          "[estimate][closed-form]") {
  HertzProblem problem;
  problem.gap_operator = "node_to_segment";
  problem.mesh.disc_cells = problem.mesh.disc_layers = problem.mesh.plate_layers = 12;
  problem.mesh.plate_cells = 15;
  problem.mesh.disc_rows = problem.mesh.plate_rows = 9;
  const SolvedScene run = solved(scene_of(problem), "Hertz");
  const Dual dual(run.model, run.condensed, run.solution);
  const std::vector<ContactEnd> ends = contact_ends(contact_edges(run.model), run.solution, dual);
  REQUIRE(ends.size() == 1);
  const double x = run.model.pairs.position(ends[0].closed, 0);
  const auto plate = std::find_if(run.model.bodies.begin(), run.model.bodies.end(),
                                  [](const BodyModel& body) { return body.mesh.name == "plate"; });
  REQUIRE(&*plate != &source_of(run.model, ends[0].closed));
  const Mesh& mesh = plate->mesh;
  double left = -1e300, right = 1e300;  // the nodes beside the end, on y = 0
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    if (mesh.nodes(node, 1) != 0) continue;
    const double at = mesh.nodes(node, 0);
    (at <= x ? left : right) = at <= x ? std::max(left, at) : std::min(right, at);
  }
  const double share = (x - left) / (right - left);  // that the right one bears
  REQUIRE((share > 0.05 && share < 0.95));
  const Eigen::VectorXd away = away_from_ends(ends, run.model, *plate);
  for (Index cell = 0; cell < away.size(); ++cell) {
    double counts = 1;
    for (Index k = 0; k < mesh.cell_size(cell); ++k) {
      const Index node = mesh.cells(cell, k);
      if (mesh.nodes(node, 1) != 0) continue;
      if (mesh.nodes(node, 0) == left) counts -= 1 - share;
      if (mesh.nodes(node, 0) == right) counts -= share;
    }
    CHECK(away(cell) == Approx(counts).margin(1e-3));  // the normals of a round disc turn a little
  }
}
