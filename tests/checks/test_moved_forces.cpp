// Forces where bodies have moved a little: of many candidates only those that may close there are condensed once more.
#include "addons/checks/moved_forces.hpp"

#include <algorithm>
#include <limits>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/scene/scene.hpp"
#include "signorini/scene/ways.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

/// A strip of square cells, bent upwards to the right, whose upper side is moved down onto a plane.
Scene strip() {
  constexpr Index cells = 400;
  constexpr double length = 200;
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = mapped(block("strip", {0, 0}, {length, 1}, cells, 2), [=](const Vector2d& x) {
    return Vector2d(x.x(), x.y() + 0.4 * x.x() * x.x() / (length * length) * (1 - x.y()));
  });
  body.material = {1, 0.3, PlaneState::Strain, 1};
  body.supports = {symmetric("left"), prescribed("top", Axis::Y, -1e-3)};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

/// A factor that remembers the most rows whose compliance it was asked for.
Factor watched(const Factor& factor, Index& most) {
  return {[factor](const Eigen::Ref<const VectorXd>& load) { return factor.solve(load); },
          [factor, &most](const Factor::Rows& rows, Ledger& ledger) {
            most = std::max(most, rows.rows());
            return factor.compliance(rows, ledger);
          },
          {factor.size(), factor.nonzeros(), factor.operations(), factor.solve_operations()}};
}

}  // namespace

TEST_CASE("where bodies moved a little, forces of many candidates take the rows of few", "[sliding][working_set]") {
  Ledger ledger;
  const Model model = build(strip(), ledger);
  Condensed few = condense_as_needed(model, ledger);
  REQUIRE_FALSE(is_complete(few));
  const Condensed all = condense(model, ledger);
  const Solution solution = solve(model, all, Ledger());
  const VectorXd u = all_displacements(model, solution.displacements);
  VectorXd opens = VectorXd::LinSpaced(model.programme.A.rows(), -2e-4, 2e-4);
  opens(1) = std::numeric_limits<double>::infinity();  // it faces nothing there
  Index most = 0;
  few.factor = watched(few.factor, most);
  const ContactState by_few = forces_nearby(model, few, u, opens, solution.contact);
  const ContactState by_all = forces_nearby(model, all, u, opens, solution.contact);
  REQUIRE(by_few.report.status == SolveStatus::Solved);
  REQUIRE(by_all.report.status == SolveStatus::Solved);
  CHECK(by_few.active() == by_all.active());
  CHECK(by_few.active() != solution.contact.active());
  CHECK(by_few.force(1) == 0);
  CHECK((by_few.force - by_all.force).norm() <= 1e-12 * by_all.force.norm());
  CHECK(most > 0);
  CHECK(most < model.programme.A.rows() / 4);
}
