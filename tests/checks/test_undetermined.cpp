// Forces that a solution leaves open, against closed forms and against the vertices of the polyhedron.
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "addons/checks/elimination.hpp"
#include "addons/checks/polyhedron.hpp"
#include "addons/checks/undetermined.hpp"
#include "addons/files/problem_file.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/friction.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A node in closed pairs: columns of the effect are normals, then tangents of the frictional ones.
Carried node(const MatrixXd& effect, const FrictionLaw& law, const VectorXd& force) {
  const Index pairs = force.size() - static_cast<Index>(law.pair.size());
  return {effect.sparseView(),
          law,
          force,
          VectorXd::Zero(force.size()),
          VectorXd::Zero(force.size()),
          std::vector<ContactStatus>(static_cast<std::size_t>(pairs), ContactStatus::Stick)};
}

/// Least and largest of each force over all vertices: every choice of as many met bounds as there are exchanges.
MatrixXd ends_of_vertices(const Carried& carried, const MatrixXd& exchanges) {
  const Index pairs = static_cast<Index>(carried.statuses.size());
  const Index k = exchanges.cols();
  MatrixXd G(3 * pairs, k);
  VectorXd h(3 * pairs);
  for (Index i = 0; i < pairs; ++i) {
    const double mu = carried.law.coefficient(i);
    G.row(3 * i) = exchanges.row(i);
    h(3 * i) = carried.force(i);
    for (const int side : {1, 2}) {
      const double sign = side == 1 ? 1 : -1;
      G.row(3 * i + side) = mu * exchanges.row(i) - sign * exchanges.row(pairs + i);
      h(3 * i + side) = mu * carried.force(i) - sign * carried.force(pairs + i);
    }
  }
  REQUIRE(k == 2);
  MatrixXd ends(carried.force.size(), 2);
  ends.col(0).setConstant(infinite);
  ends.col(1).setConstant(-infinite);
  for (Index a = 0; a < h.size(); ++a)
    for (Index b = 0; b < a; ++b) {
      const Eigen::Matrix2d met = G(std::vector<Index>{a, b}, Eigen::all);
      if (std::abs(met.determinant()) < 1e-9) continue;
      const Vector2d y = met.inverse() * -Vector2d(h(a), h(b));
      if ((G * y + h).minCoeff() < -1e-12) continue;
      const VectorXd force = carried.force + exchanges * y;
      ends.col(0) = ends.col(0).cwiseMin(force);
      ends.col(1) = ends.col(1).cwiseMax(force);
    }
  return ends;
}

}  // namespace

TEST_CASE("a linear function goes to the vertices of a polyhedron, or to infinity",
          "[active_set]") {
  // y1 >= -1, y2 >= -2, y1 + y2 <= 3
  const MatrixXd G = (MatrixXd(3, 2) << 1, 0, 0, 1, -1, -1).finished();
  Polyhedron triangle(G, Vector3d(1, 2, 3));
  for (const auto& [c, low, high] : {std::tuple(Vector2d(1, 0), -1.0, 5.0),
                                     {Vector2d(0, 1), -2.0, 4.0},
                                     {Vector2d(1, 1), -3.0, 3.0},
                                     {Vector2d(1, -1), -5.0, 7.0},
                                     {Vector2d(0, 0), 0.0, 0.0}}) {
    const auto [least, most] = triangle.range(c);
    CHECK(least == Approx(low).epsilon(1e-15).margin(1e-15));
    CHECK(most == Approx(high).epsilon(1e-15).margin(1e-15));
  }
  Polyhedron wedge(G.topRows(2), Vector2d(1, 2));
  CHECK(wedge.range(Vector2d(1, 1)) == std::pair(-3.0, infinite));
  CHECK(wedge.range(Vector2d(1, -1)) == std::pair(-infinite, infinite));
  Polyhedron strip((MatrixXd(2, 2) << 1, 1, -1, -1).finished(),
                   Vector2d(1, 1));  // with a line in it
  CHECK(strip.range(Vector2d(2, 2)) == std::pair(-2.0, 2.0));
  CHECK(strip.range(Vector2d(1, 0)) == std::pair(-infinite, infinite));
  Polyhedron corner(G.topRows(2), Vector2d(0, 0));  // no way back from the point itself
  CHECK(corner.range(Vector2d(1, 0)) == std::pair(0.0, infinite));
}

TEST_CASE("elimination finds every combination of columns that is nothing", "[active_set]") {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Index rows = random.whole(1, 12), columns = random.whole(1, 14);
    const Index rank = random.whole(0, static_cast<int>(std::min(rows, columns)));
    MatrixXd left(rows, rank), right(rank, columns);
    for (double& x : left.reshaped()) x = random.uniform(-1, 1);
    for (double& x : right.reshaped()) x = random.uniform(-1, 1);
    const MatrixXd A = left * right;
    std::vector<SparseEntries> entries(static_cast<std::size_t>(columns));
    for (Index j = 0; j < columns; ++j)
      for (Index i = 0; i < rows; ++i)
        entries[static_cast<std::size_t>(j)].emplace_back(i, A(i, j));
    const std::vector<SparseEntries> all = null_combinations(entries, rows, 1e-12);
    CAPTURE(trial, rows, columns, rank);
    REQUIRE(static_cast<Index>(all.size()) == columns - rank);
    for (const SparseEntries& combination : all) {
      VectorXd y = VectorXd::Zero(columns);
      for (const auto& [column, factor] : combination) y(column) = factor;
      CHECK(y.cwiseAbs().maxCoeff() == Approx(1).epsilon(1e-15));
      CHECK((A * y).norm() <= 1e-12);
    }
  }
}

TEST_CASE("of many full columns those that depend on others are found, and no more",
          "[active_set]") {
  Random random(4);
  const Index n = 160;
  for (const bool repeats : {false, true}) {
    std::vector<SparseEntries> entries(static_cast<std::size_t>(n));
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i)
        entries[static_cast<std::size_t>(j)].emplace_back(i, random.uniform(-1, 1));
    if (repeats) entries[70] = entries[12];
    const std::vector<SparseEntries> all = null_combinations(entries, n, 1e-12);
    REQUIRE(all.size() == (repeats ? 1 : 0));
    if (!repeats) continue;
    REQUIRE(all[0].size() == 2);
    CHECK(all[0][0].first + all[0][1].first == 82);
    CHECK(all[0][0].second + all[0][1].second == Approx(0).margin(1e-12));
  }
}

// A chain: each column has two rows, and shares one of them with the next. Three that close a ring depend on each other.
TEST_CASE("of columns with few entries those that close a ring are found", "[active_set]") {
  const Index n = 400;
  for (const bool ring : {false, true}) {
    std::vector<SparseEntries> entries;
    for (Index j = 0; j + 1 < n; ++j) entries.push_back({{j, 1}, {j + 1, -1}});
    if (ring) entries.push_back({{100, 1}, {103, -1}});
    const std::vector<SparseEntries> all = null_combinations(entries, n, 1e-12);
    REQUIRE(all.size() == (ring ? 1 : 0));
    if (!ring) continue;
    CHECK(all[0].size() == 4);
    for (const auto& [column, factor] : all[0]) {
      CHECK((column == n - 1 || (column >= 100 && column <= 102)));
      CHECK(std::abs(factor) == Approx(1).epsilon(1e-9));
    }
  }
}

TEST_CASE("of parts that have no row in common one that depends is found among many that do not",
          "[active_set]") {
  Random random(6);
  for (int trial = 0; trial < 60; ++trial) {
    const Index parts = random.whole(1, 20);
    const Index repeats = trial % 3 == 0 ? -1 : random.whole(0, static_cast<int>(parts) - 1);
    std::vector<SparseEntries> entries;
    for (Index part = 0; part < parts; ++part)
      for (Index k = 0, width = part == repeats ? 3 : random.whole(1, 2); k < width; ++k) {
        entries.emplace_back();
        for (Index i = 0; i < 2; ++i)  // the rows of a part lie apart, too
          entries.back().emplace_back(parts * i + part, random.uniform(-1, 1));
      }
    const std::vector<SparseEntries> all = null_combinations(entries, 2 * parts, 1e-12);
    CAPTURE(trial, parts, repeats);
    REQUIRE(all.size() == (repeats >= 0 ? 1 : 0));
    if (repeats < 0) continue;
    REQUIRE(all[0].size() == 3);
    double sum = 0;
    for (const auto& [column, factor] : all[0]) {
      CHECK(entries[static_cast<std::size_t>(column)][0].first == repeats);
      sum += factor * entries[static_cast<std::size_t>(column)][0].second;
    }
    CHECK(std::abs(sum) <= 1e-14);  // three terms below 1: a few roundings of each
  }
}

TEST_CASE("two pairs of one node share what presses it", "[active_set][closed-form]") {
  // Both walls push along x: the sum of 3 is given. A wall on the other side takes what the first gives more.
  const MatrixXd same = (MatrixXd(2, 2) << 1, 1, 0, 0).finished();
  std::vector<SharedForces> groups = undetermined_forces(node(same, {}, Vector2d(1, 2)));
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].pairs == std::vector<Index>{0, 1});
  REQUIRE(groups[0].forces.size() == 2);
  for (const ForceRange& range : groups[0].forces) {
    CHECK(range.low == 0);
    CHECK(range.high == Approx(3).epsilon(1e-15));
  }
  const MatrixXd opposite = (MatrixXd(2, 2) << 1, -1, 0, 0).finished();
  groups = undetermined_forces(node(opposite, {}, Vector2d(3, 1)));
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].forces[0].low == Approx(2).epsilon(1e-15));
  CHECK(groups[0].forces[1].low == 0);
  CHECK(groups[0].width() == infinite);
  groups = undetermined_forces(node(same, {}, Vector2d(1, 2)), 0);  // without an operation
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].width() == infinite);
  for (const ForceRange& range : groups[0].forces) CHECK(std::isnan(range.low + range.high));
  const MatrixXd thrice = (MatrixXd(2, 3) << 1, 1, 1, 0, 0, 0).finished();
  groups = undetermined_forces(node(thrice, {}, Vector3d(1, 2, 3)));
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].exchanges.cols() == 2);
  REQUIRE(groups[0].forces.size() == 3);
  for (const ForceRange& range : groups[0].forces) CHECK(range.high == Approx(6).epsilon(1e-15));
  const MatrixXd twice = (MatrixXd(2, 4) << 1, 1, 0, 0, 0, 0, 1, 1).finished();
  groups = undetermined_forces(node(twice, {}, Vector4d(1, 2, 3, 4)));
  REQUIRE(groups.size() == 2);  // the one with the widest range first
  CHECK(groups[0].pairs == std::vector<Index>{2, 3});
  CHECK(groups[0].width() == Approx(7).epsilon(1e-15));
  CHECK(groups[1].width() == Approx(3).epsilon(1e-15));
  const MatrixXd apart = (MatrixXd(2, 2) << 1, 0, 0, 1).finished();
  CHECK(undetermined_forces(node(apart, {}, Vector2d(1, 2))).empty());
  Carried equation = node(same, {}, Vector2d(1, 2));
  equation.equations = 1;  // may pull
  CHECK(undetermined_forces(equation)[0].forces[0].low == -infinite);
  CHECK(undetermined_forces(equation)[0].forces[1].low == 0);
}

TEST_CASE("a gap, a slip beyond rounding or cohesion leaves no choice",
          "[active_set][closed-form]") {
  const MatrixXd same = (MatrixXd(2, 2) << 1, 1, 0, 0).finished();
  Carried carried = node(same, {}, Vector2d(3, 0));
  carried.statuses[1] = ContactStatus::Open;
  CHECK(undetermined_forces(carried).size() == 1);  // it touches
  carried.movement(1) = 1e-15;
  CHECK(undetermined_forces(carried).empty());
  carried.rounding(1) = 2e-15;
  CHECK(undetermined_forces(carried).size() == 1);

  // One pair on a floor, one at a wall: a slip at both leaves two numbers for two components.
  const MatrixXd corner = (MatrixXd(2, 4) << 0, 1, 1, 0, 1, 0, 0, 1).finished();
  const FrictionLaw law = law_of_all(Vector2d::Constant(0.5), Vector2d::Zero());
  carried = node(corner, law, (VectorXd(4) << 1, 1, 0.5, 0.5).finished());
  CHECK(undetermined_forces(carried).size() == 1);
  carried.statuses.assign(2, ContactStatus::SlipBackward);
  CHECK(undetermined_forces(carried).size() == 1);  // the slips are none
  carried.movement.tail(2).setConstant(-1);
  CHECK(undetermined_forces(carried).empty());
}

// The cones of a floor and a wall that are at right angles contain opposite forces if mu_1 mu_2 > 1.
TEST_CASE("a corner without a load holds by itself only if friction wedges it",
          "[active_set][closed-form]") {
  const MatrixXd corner = (MatrixXd(2, 4) << 0, 1, 1, 0, 1, 0, 0, 1).finished();
  for (const auto& [first, second, wedges] :
       {std::tuple(0.3, 0.3, false), {0.5, 1.99, false}, {0.5, 2.01, true}, {2.0, 2.0, true}}) {
    CAPTURE(first, second);
    const FrictionLaw law = law_of_all(Vector2d(first, second), Vector2d::Zero());
    const auto groups = undetermined_forces(node(corner, law, VectorXd::Zero(4)));
    CHECK(groups.empty() == !wedges);
    if (wedges) CHECK(groups[0].width() == infinite);
  }
}

// Sticking without friction takes c at most: each wall carries what the other takes.
TEST_CASE("cohesion wedges a corner by as much as it is", "[active_set][closed-form]") {
  const MatrixXd corner = (MatrixXd(2, 4) << 0, 1, 1, 0, 1, 0, 0, 1).finished();
  const FrictionLaw law = law_of_all(Vector2d::Zero(), Vector2d(0.5, 0.25));
  const auto groups = undetermined_forces(node(corner, law, VectorXd::Zero(4)));
  REQUIRE(groups.size() == 1);
  REQUIRE(groups[0].forces.size() == 4);
  for (const ForceRange& range : groups[0].forces) {
    const double most = range.row == 1 || range.row == 2 ? 0.5 : 0.25;
    CHECK(range.low == Approx(range.row < 2 ? 0 : -most).epsilon(1e-15).margin(1e-15));
    CHECK(range.high == Approx(range.row < 2 ? most : 0).epsilon(1e-15).margin(1e-15));
  }
}

TEST_CASE("the forces of a node in two walls go as far as the vertices", "[active_set]") {
  const FiledProblem filed = std::get<std::vector<FiledProblem>>(
      read_problem(SIGNORINI_TEST_DATA "/found/friction_corner_node.txt"))[0];
  for (const char* name : {"primal_dual_active_set", "lemke"}) {
    const ContactState state = find_solver(name).solve(filed.problem, {});
    REQUIRE(state.report.status == SolveStatus::Solved);
    const Carried all = carried(filed.problem, state);
    const std::vector<SharedForces> groups = undetermined_forces(all);
    REQUIRE(groups.size() == 1);
    REQUIRE(groups[0].forces.size() == 4);
    const MatrixXd ends = ends_of_vertices(all, MatrixXd(groups[0].exchanges));
    for (const ForceRange& range : groups[0].forces) {
      CAPTURE(name, range.row);
      CHECK(range.low == Approx(ends(range.row, 0)).epsilon(1e-12).margin(1e-13));
      CHECK(range.high == Approx(ends(range.row, 1)).epsilon(1e-12).margin(1e-13));
    }
  }
}

// Closed form: both slide, and their forces sum to 1 / (2 - 0.3 * 0.3).
TEST_CASE("identical pairs that slide share one force", "[active_set][closed-form]") {
  const FiledProblem filed = std::get<std::vector<FiledProblem>>(
      read_problem(SIGNORINI_TEST_DATA "/found/friction_two_identical_pairs.txt"))[0];
  const ContactState state = friction_solvers().front().solve(filed.problem, {});
  const auto groups = undetermined_forces(carried(filed.problem, state));
  REQUIRE(groups.size() == 1);
  const double sum = 1 / (2 - 0.3 * 0.3);
  for (const ForceRange& range : groups[0].forces) {
    CHECK(range.low == Approx(range.row < 2 ? 0 : -0.3 * sum).epsilon(1e-14).margin(1e-15));
    CHECK(range.high == Approx(range.row < 2 ? sum : 0).epsilon(1e-14).margin(1e-15));
  }
}

TEST_CASE("forces are determined whatever the units of pairs, or are not", "[active_set]") {
  Random random(8);
  for (int trial = 0; trial < 100; ++trial) {
    const Index n = 1 + trial % 4;
    ContactProblem problem = random_friction(random, n, 0.5);
    const bool repeats = trial % 2 == 1;
    if (repeats) {  // the last pair a second time
      std::vector<Index> rows;
      for (Index i = 0; i < 2 * n + 2; ++i)
        rows.push_back(i < n ? i : i == n ? n - 1 : i == 2 * n + 1 ? 2 * n - 1 : i - 1);
      problem.compliance = MatrixXd(problem.compliance(rows, rows));
      problem.free_gap.conservativeResize(n + 1);
      problem.free_slip.conservativeResize(n + 1);
      problem.free_gap(n) = problem.free_gap(n - 1);
      problem.free_slip(n) = problem.free_slip(n - 1);
      VectorXd mu = VectorXd::Constant(n + 1, 0.4);
      problem.law = law_of_all(mu, VectorXd::Zero(n + 1));
    }
    for (const double unit : {1.0, 0x1p-60, 0x1p60}) {
      ContactProblem scaled = problem;
      scaled.compliance *= unit;
      const ContactState state = friction_solvers().front().solve(scaled, {});
      REQUIRE(state.report.status == SolveStatus::Solved);
      const bool pressed = repeats && state.force.tail(2).sum() > 0;
      CAPTURE(trial, unit);
      CHECK(undetermined_forces(carried(scaled, state)).size() == (pressed ? 1 : 0));
    }
  }
}
