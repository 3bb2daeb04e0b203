#include <Eigen/SparseCholesky>
#include <cmath>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "support/refined.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// A programme with what its caller has to know about its floating bodies.
struct Floating {
  QuadraticProgramme programme;
  MatrixXd modes;               ///< null vectors of K
  std::vector<Index> grounded;  ///< one unknown per mode
};

/// K_g^-1, and what a floating body makes of it.
struct Solved {
  ContactProblem problem;
  ContactState state;
  Refined refined;
};

/// \param ground  its springs, as a share of the largest entry of K
/// \param share   of the contact forces that refinement begins with
Solved solved(const Floating& body, double ground = 1, double share = 1) {
  Eigen::SparseMatrix<double> K = body.programme.stiffness;
  const double spring = ground * VectorXd(K.diagonal()).maxCoeff();
  for (const Index i : body.grounded) K.coeffRef(i, i) += spring;
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor(K);
  const MatrixXd A = body.programme.A;
  const MatrixXd half = A * factor.solve(MatrixXd(A.transpose()));
  const MatrixXd G = 0.5 * (half + half.transpose());
  const VectorXd u0 = factor.solve(body.programme.load);
  Solved result;
  result.problem = {G, body.programme.initial_gap - A * u0};
  add_rigid_modes(body.programme, body.modes, result.problem);
  result.state = solve_with_proofs(result.problem, find_solver("primal_dual_active_set"));
  result.refined = refined(
      body.programme, [&](const VectorXd& f) { return VectorXd(factor.solve(f)); }, G,
      {u0, {}, share * result.state.force}, result.state.active(), body.modes);
  return result;
}

/// A beam of two equal halves without mass: three nodes that move up and down, and only bending,
/// u_1 - 2 u_2 + u_3, strains it. Supports under both ends at the depth 1 and 2, the weight w on node 2.
Floating beam(double w) {
  Floating body;
  const Vector3d bending(1, -2, 1);
  body.programme.stiffness = MatrixXd(3 * bending * bending.transpose()).sparseView();
  body.programme.load = Vector3d(0, -w, 0);
  body.programme.A = (MatrixXd(2, 3) << -1, 0, 0, 0, 0, -1).finished().sparseView();
  body.programme.initial_gap = Vector2d(1, 2);
  body.modes = (MatrixXd(3, 2) << 1, -1, 1, 0, 1, 1).finished();
  body.grounded = {0, 2};
  return body;
}

/// The two lattices of trusses below: the lower one is held and has the stiffness 1, the upper one floats,
/// `stiff` times as stiff, at the height `lift` above it.
constexpr Index columns = 6;
constexpr Index rows = 4;
Index node(Index body, Index row, Index column) { return (body * rows + row) * columns + column; }

void add_truss(MatrixXd& K, const MatrixXd& X, Index i, Index j, double stiffness) {
  const Vector2d along = (X.row(j) - X.row(i)).transpose();
  const Eigen::Matrix2d part = stiffness / std::pow(along.norm(), 3) * along * along.transpose();
  for (const Index a : {i, j})
    for (const Index b : {i, j}) K.block<2, 2>(2 * a, 2 * b) += a == b ? part : -part;
}

Floating lattices(double stiff, double lift) {
  MatrixXd X(2 * rows * columns, 2);
  for (Index b = 0; b < 2; ++b)
    for (Index r = 0; r < rows; ++r)
      for (Index c = 0; c < columns; ++c)
        X.row(node(b, r, c)) << (b == 0 ? 0.7 : 0.73) * double(c),
            0.9 * double(r) + (b == 0 ? 0 : 2.7 + lift + 0.01 * double((c - 2) * (c - 2)));
  MatrixXd K = MatrixXd::Zero(X.size(), X.size());
  for (Index b = 0; b < 2; ++b)
    for (Index r = 0; r < rows; ++r)
      for (Index c = 0; c < columns; ++c) {
        const double k = 1.37 * (b == 0 ? 1 : stiff);
        if (c + 1 < columns) add_truss(K, X, node(b, r, c), node(b, r, c + 1), k);
        if (r + 1 < rows) add_truss(K, X, node(b, r, c), node(b, r + 1, c), k);
        if (r + 1 == rows || c + 1 == columns) continue;
        add_truss(K, X, node(b, r, c), node(b, r + 1, c + 1), k);
        add_truss(K, X, node(b, r, c + 1), node(b, r + 1, c), k);
      }
  const Index held = 2 * columns;  // the lowest row does not move
  const Index n = X.size() - held;
  Floating body;
  MatrixXd A = MatrixXd::Zero(columns, n);
  body.programme.stiffness = MatrixXd(K.bottomRightCorner(n, n)).sparseView();
  body.programme.load = VectorXd::Zero(n);
  body.programme.initial_gap.resize(columns);
  for (Index c = 0; c < columns; ++c) {  // from a node of the upper body down to an edge below
    const Index edge = std::min(c, columns - 2);
    const double part = std::min(1.0, X(node(1, 0, c), 0) / 0.7 - double(edge));
    A(c, 2 * node(1, 0, c) + 1 - held) = -1;
    A(c, 2 * node(0, rows - 1, edge) + 1 - held) = 1 - part;
    A(c, 2 * node(0, rows - 1, edge + 1) + 1 - held) = part;
    body.programme.initial_gap(c) = X(node(1, 0, c), 1) - 2.7;
    body.programme.load(2 * node(1, rows - 1, c) + 1 - held) = -0.02 - 0.002 * double(c);
  }
  body.programme.A = A.sparseView();
  body.modes = MatrixXd::Zero(n, 3);
  for (Index i = node(1, 0, 0); i < X.rows(); ++i) {
    body.modes.row(2 * i - held) << 1, 0, 4 + lift - X(i, 1);
    body.modes.row(2 * i + 1 - held) << 0, 1, X(i, 0) - 2;
  }
  body.grounded = {2 * node(1, 0, 0) - held, 2 * node(1, 0, 0) + 1 - held,
                   2 * node(1, 0, columns - 1) + 1 - held};
  return body;
}

}  // namespace

TEST_CASE("a beam pressed on two supports by its weight: signs of R and r",
          "[rigid][closed-form]") {
  const Solved beam_solved = solved(beam(6));
  CHECK(beam_solved.problem.rigid == (MatrixXd(2, 2) << 1, -1, 1, 1).finished());  // up opens both
  CHECK(beam_solved.problem.resultant == Vector2d(6, 0));  // forces add up to the weight
  REQUIRE(beam_solved.refined.confirmed);
  const PrimalDual& solution = beam_solved.refined.solution;
  CHECK((solution.force - Vector2d(3, 3)).norm() <= 1e-15);
  // The ends rest at -1 and -2; 3 (u_1 - 2 u_2 + u_3) = 3 is the force that bends each end up.
  CHECK((solution.displacement - Vector3d(-1, -2, -2)).norm() <= 1e-15);
  CHECK(certify(beam(6).programme, solution).worst() <= 1e-15);
}

TEST_CASE("a stiff body that floats above a soft one: the certificate is rounding", "[rigid]") {
  for (const double stiff : {1.0, 1e3, 1e6, 1e9, 1e12})
    for (const double lift : {0.0, 0.1, 10.0, 1000.0}) {
      const Floating body = lattices(stiff, lift);
      const Solved now = solved(body);
      CAPTURE(stiff, lift, now.refined.solves);
      REQUIRE(now.refined.confirmed);
      CHECK(now.refined.solves <= 7);
      CHECK(certify(body.programme, now.refined.solution).worst() <= 1e-14);
      const double weight = -body.programme.load.sum();
      CHECK(now.refined.solution.force.sum() == Approx(weight).epsilon(1e-15).margin(0));
    }
}

TEST_CASE("a way that a body went and came back is no strain of it", "[rigid]") {
  // Forces that do not balance the load send it far away on a soft ground. K, whose entries are rounded, would strain it
  // there, so all of u must solve the equations, not only the part of it that strains.
  for (const double ground : {1.0, 1e-4, 1e-8}) {
    const Floating body = lattices(1e3, 0.1);
    const Solved now = solved(body, ground, 2);
    CAPTURE(ground);
    REQUIRE(now.refined.confirmed);
    PrimalDual whole = now.refined.solution;
    CHECK(certify(body.programme, whole).worst() <= 1e-14);
    whole.rigid.resize(0);
    const VectorXd terms = body.programme.stiffness.cwiseAbs() * whole.displacement.cwiseAbs();
    const double left = equilibrium_residual(body.programme, whole).cwiseAbs().maxCoeff();
    CHECK(left / (epsilon * terms.maxCoeff()) <= 2);
  }
}

TEST_CASE("what is left of motions that cancel is a motion", "[rigid]") {
  // Entries of no common pattern: sums and products are rounded everywhere.
  MatrixXd N(20, 3);
  for (Eigen::Index node = 0; node < 10; ++node) {
    const double x = std::sin(1.0 + static_cast<double>(node)), y = std::cos(3.0 * x);
    N.row(2 * node) << 1, 0, -y;
    N.row(2 * node + 1) << 0, 1, x;
  }
  const Eigen::Vector3d far(0.3, -0.7, 1.1);
  PrimalDual u{VectorXd::Zero(20), {}, {}};
  add_rigid(u, N, far);
  add_rigid(u, N, (0x1p-40 - 1) * far);
  const VectorXd motion = N * least_norm_solution(N, u.rigid);
  CHECK(u.rigid.cwiseAbs().maxCoeff() >= 0x1p-42);
  CHECK((u.rigid - motion).cwiseAbs().maxCoeff() <= 1e-14 * u.rigid.cwiseAbs().maxCoeff());
  CHECK((u.displacement - 0x1p-40 * N * far).cwiseAbs().maxCoeff() <= 4 * epsilon);
}

TEST_CASE("a rigid part that strains a body is refused", "[rigid]") {
  const Floating body = lattices(1e6, 1);
  PrimalDual solution = solved(body).refined.solution;
  REQUIRE(certify(body.programme, solution).holds());
  solution.rigid(5) += 1e-6;
  CHECK_FALSE(certify(body.programme, solution).holds());
  solution.rigid = solution.displacement;
  CHECK_FALSE(certify(body.programme, solution).holds());
}

TEST_CASE("sets that cannot hold the body are not confirmed", "[rigid]") {
  const Floating body = beam(6);
  const MatrixXd G = MatrixXd::Identity(2, 2) + MatrixXd::Ones(2, 2);  // need not be accurate
  const auto solve_stiffness = [](const VectorXd& f) { return f; };
  const PrimalDual start{Vector3d::Zero(), {}, Vector2d::Zero()};
  const auto confirmed = [&](const MatrixXd& compliance, const std::vector<Index>& closed) {
    return refined(body.programme, solve_stiffness, compliance, start, closed, body.modes)
        .confirmed;
  };
  CHECK_FALSE(confirmed(G, {}));
  CHECK_FALSE(confirmed(G, {0}));  // would tip over
  Floating twice = body;           // the same support two times
  twice.programme.A = (MatrixXd(2, 3) << -1, 0, 0, -1, 0, 0).finished().sparseView();
  twice.programme.initial_gap = Vector2d(1, 1);
  CHECK_FALSE(
      refined(twice.programme, solve_stiffness, MatrixXd::Ones(2, 2), start, {0, 1}, twice.modes)
          .confirmed);
}

TEST_CASE("a slide along an inclined plane is free, whatever its rounding", "[rigid]") {
  // A block of one node, pressed straight on planes at all angles.
  for (int degrees = 1; degrees < 90; ++degrees) {
    const double angle = degrees * pi / 180;
    const Vector2d normal(std::sin(angle), std::cos(angle));
    QuadraticProgramme programme;
    programme.stiffness.resize(2, 2);
    programme.load = -3 * normal;
    programme.A = MatrixXd(-normal.transpose()).sparseView();
    programme.initial_gap = VectorXd::Ones(1);
    const MatrixXd modes = (MatrixXd(2, 2) << normal, Vector2d(normal(1), -normal(0))).finished();
    ContactProblem problem{MatrixXd::Ones(1, 1), VectorXd::Ones(1)};
    add_rigid_modes(programme, modes, problem);
    CAPTURE(degrees);
    CHECK(problem.rigid(0, 1) == 0);
    CHECK(problem.resultant(1) == 0);
    CHECK(problem.resultant(0) == Approx(3).epsilon(1e-15));
  }
}
