// How far rounding of the gaps moves the forces, against the largest of all signs.
#include "addons/certified/certified_solve.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"

using Eigen::MatrixXd;
using Eigen::Vector4d;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// Four pairs, A = I, all closed with force 1 at places u; K is 1 but along h = (1, 1, -1, -1) / 2.
CertifiedSolution end_of(double stiff, const Vector4d& place) {
  const Vector4d h = Vector4d(1, 1, -1, -1) / 2;
  const MatrixXd one = MatrixXd::Identity(4, 4);
  const MatrixXd K = one + (stiff - 1) * h * h.transpose();
  const MatrixXd G = one + (1 / stiff - 1) * h * h.transpose();
  const QuadraticProgramme programme{K.sparseView(), K * place + Vector4d::Ones(), one.sparseView(),
                                     place};
  const VectorXd free = G * programme.load;
  const ContactProblem problem{G, place - free};
  Ledger ledger;
  return certified_solve(programme,
                         {problem, free, [&](const VectorXd& p) { return VectorXd(G * p); }}, {},
                         find_solver("primal_dual_active_set"), {}, ledger);
}

}  // namespace

// A gap g - u is known to epsilon |u| at best, and a change d of all gaps changes the forces by K d: the worst signs make
// it the largest row sum of |K| epsilon |u|. Signs in turns are at a right angle to h.
TEST_CASE("the worst rounding is found where its signs are not in turns", "[certified_solve]") {
  const double stiff = 0x1p40;
  const Vector4d place(1, 2, 3, 5);
  const CertifiedSolution end = end_of(stiff, place);
  REQUIRE(end.state.report.status == SolveStatus::Solved);
  CHECK(end.certificate.holds(1e-12));
  const double worst = (0.25 * stiff + 0.75) * epsilon * place.sum();
  CHECK(end.force_uncertainty.share > 0.5 * worst);
  CHECK(end.force_uncertainty.share < 1.001 * worst);
  CHECK(end.force_uncertainty.pair >= 0);
}

TEST_CASE("forces of pairs that differ by no pattern are known to rounding", "[certified_solve]") {
  const CertifiedSolution end = end_of(1, Vector4d(1, 2, 3, 5));
  REQUIRE(end.state.report.status == SolveStatus::Solved);
  CHECK(end.force_uncertainty.share == Approx(5 * epsilon).epsilon(1e-12));
  CHECK(end.force_uncertainty.pair == 3);
}

// Nothing is known of forces that would need more digits than there are.
TEST_CASE("no force is less known than not at all", "[certified_solve]") {
  CHECK(end_of(0x1p52, Vector4d(1, 2, 3, 5)).force_uncertainty.share == 1);
}
