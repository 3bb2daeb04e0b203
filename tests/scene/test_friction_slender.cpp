// Slender strips on a rough plane: their displacements depend on the last digits of the forces.
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/scene.hpp"

using Eigen::Index;
using namespace signorini;

namespace {

Scene strip(double length, double coefficient, Index cells, const char* element) {
  Scene scene;
  BlockSpec block;
  block.size = {length, 1};
  block.cells_x = cells;
  block.cells_y = 2;
  if (std::string(element) == "q8") block.order = MeshOrder::Quadratic;
  Body& body = scene.bodies[0];
  body.mesh = make_block(block);
  body.element = element;
  body.material = {1, 0.3, PlaneState::Stress, 1};
  body.supports = {fixed("left")};
  body.loads.edges = {{"top", 1e-3, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{coefficient, 0};
  return scene;
}

struct Run {
  Model model;
  Solution solution;
};

Run solved_strip(const Scene& scene) {
  Ledger ledger;
  Run run;
  run.model = build(scene, ledger);
  run.solution = solve(run.model, condense(run.model, ledger), ledger);
  return run;
}

}  // namespace

TEST_CASE("pairs that stick do not slip, however slender the body", "[friction][hard]") {
  for (const double length : {50.0, 300.0, 1000.0})
    for (const double coefficient : {0.3, 5.0})
      for (const Index cells : {6, 40})
        for (const char* element : {"q4_incompatible", "q8"}) {
          const Solution solution =
              solved_strip(strip(length, coefficient, cells, element)).solution;
          CAPTURE(length, coefficient, cells, element, solution.contact.reason);
          REQUIRE(solution.contact.report.status == SolveStatus::Solved);
          CHECK(solution.certificate.worst() <= 1e-13);
          const double most = solution.displacements[0].cwiseAbs().maxCoeff();
          const ContactState& state = solution.contact;
          for (std::size_t k = 0; k < state.contact_status.size(); ++k)
            if (state.contact_status[k] == ContactStatus::Stick) {
              REQUIRE(std::abs(state.slip(static_cast<Index>(k))) <= 1e-15 * most);
              REQUIRE(std::abs(state.gap(state.frictional_pairs[k])) <= 1e-15 * most);
            }
        }
}

TEST_CASE("the certificate sees a slip that nothing resists, and a force beyond its bound",
          "[friction][certificate]") {
  const Run run = solved_strip(strip(5, 0.2, 12, "q4_incompatible"));
  const ContactState& state = run.solution.contact;
  REQUIRE(run.solution.contact.report.status == SolveStatus::Solved);
  const Index pairs = state.force.size();
  Index sticks = -1;
  Index slides = -1;
  for (Index pair = 0; pair < pairs; ++pair) {
    if (state.contact_status[static_cast<std::size_t>(pair)] == ContactStatus::Stick) sticks = pair;
    if (friction_sign(state.contact_status[static_cast<std::size_t>(pair)]) != 0) slides = pair;
  }
  REQUIRE((sticks >= 0 && slides >= 0));
  const auto figures = [&](const PrimalDual& claim) {
    return certify(run.model.programme, claim, run.model.law);
  };
  REQUIRE(figures(run.solution.refined).holds());
  const Index unknown = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator(
                            run.model.programme.A, pairs + sticks)
                            .col();
  PrimalDual moved = run.solution.refined;
  moved.displacement(unknown) += 1e-9 * run.solution.refined.displacement.cwiseAbs().maxCoeff();
  CHECK(figures(moved).sliding > 1e-10);
  PrimalDual pushed = run.solution.refined;
  pushed.force(pairs + slides) *= 1.001;
  CHECK(figures(pushed).cone > 1e-10);
  CHECK(figures(pushed).equilibrium > 1e-10);
  FrictionLaw rougher = run.model.law;
  rougher.coefficient *= 1.001;  // a slip that is not resisted as much as it could be
  CHECK(certify(run.model.programme, run.solution.refined, rougher).sliding > 1e-10);
}
