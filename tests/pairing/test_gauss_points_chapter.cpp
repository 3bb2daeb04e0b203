// What chapter 10 says of pressures that are not determined.
#include "../chapters/ch10_gauss_points/closed_points.hpp"
#include "../chapters/ch10_gauss_points/interfaces.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"

using namespace ch10;

TEST_CASE(
    "where pressures of Gauss points are free, certified answers share the forces of the nodes",
    "[gap_operators][hertz][LinEtAl-37]") {
  const SolvedScene first = solved(hertz(16, {"gauss_points", 3}), "disc");
  const ClosedPoints closed = closed_points(first);
  REQUIRE(closed.free.cols() > 0);
  const NodeArray nodal = contact_forces(first.model, first.solution);
  int found = 0;
  for (const char* name : {"quasi_active_set", "goldfarb_idnani", "lemke", "fischer_burmeister"}) {
    const Solution other = solve(first.model, first.condensed, find_solver(name), {});
    if (other.contact.report.status != SolveStatus::Solved)
      continue;  // some give up on a singular G
    CAPTURE(name);
    CHECK((contact_forces(first.model, other) - nodal).norm() < 1e-9 * nodal.norm());
    ++found;
  }
  CHECK(found >= 2);
}

TEST_CASE("a pressure that no node feels changes no force of a node", "[gap_operators][exact]") {
  const SolvedScene run = solved(blocks(8, 8, {"gauss_points", 3}), "blocks");
  const ClosedPoints closed = closed_points(run);
  REQUIRE(closed.rank == 9);
  REQUIRE(closed.free.cols() == 24 - 9);
  Eigen::VectorXd felt = Eigen::VectorXd::Zero(run.model.unknowns.count);
  Eigen::VectorXd all = felt;
  for (Eigen::Index k = 0; k < closed.root.size(); ++k) {
    const Eigen::VectorXd row = run.model.programme.A.row(closed.points[k]).transpose();
    felt += row * (closed.root(k) * closed.free(k, 0));
    all += row * (closed.root(k) * closed.root(k));
  }
  CHECK(felt.norm() < 1e-7 * all.norm());  // the rank is cut at 1e-12 of squares
}
