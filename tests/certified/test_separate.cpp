// Systems that nothing connects are solved as if each were alone, whatever the others are like.
#include "addons/certified/certified_solve.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/random.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Springs between unknowns in random ways; the first three rows of A are gaps, then come three slips, if any.
struct Data {
  MatrixXd K;
  VectorXd p;
  MatrixXd A;
  VectorXd g;
  FrictionLaw law;
};

Data one_system(unsigned seed, bool frictional) {
  signorini_test::Random random(seed);
  const auto draw = [&](Index rows, Index columns) {
    MatrixXd M(rows, columns);
    for (Index i = 0; i < rows; ++i)
      for (Index j = 0; j < columns; ++j) M(i, j) = random.uniform(-1, 1);
    return M;
  };
  const MatrixXd C = draw(8, 8);
  const Index rows = frictional ? 6 : 3;
  Data data{C * C.transpose() + MatrixXd::Identity(8, 8),
            draw(8, 1),
            draw(rows, 8),
            0.1 * draw(rows, 1),
            {}};
  if (!frictional) return data;
  data.g.tail(3).setZero();
  data.law = law_of_all(VectorXd::Constant(3, 0.3), VectorXd::Constant(3, 0.01));
  return data;
}

/// Two systems, the second with loads, gaps and cohesion times `small`; rows of gaps first.
Data beside(const Data& one, const Data& two, double small) {
  const Index n = one.p.size();
  const Index slips = static_cast<Index>(one.law.pair.size());
  Data both{MatrixXd::Zero(2 * n, 2 * n),
            VectorXd(2 * n),
            MatrixXd::Zero(6 + 2 * slips, 2 * n),
            VectorXd(6 + 2 * slips),
            {}};
  both.K.topLeftCorner(n, n) = one.K;
  both.K.bottomRightCorner(n, n) = two.K;
  both.p << one.p, small * two.p;
  both.A.topLeftCorner(3, n) = one.A.topRows(3);
  both.A.block(3, n, 3, n) = two.A.topRows(3);
  both.g.head(6) << one.g.head(3), small * two.g.head(3);
  both.A.block(6, 0, slips, n) = one.A.bottomRows(slips);
  both.A.block(6 + slips, n, slips, n) = two.A.bottomRows(slips);
  both.g.tail(2 * slips).setZero();
  if (slips == 0) return both;
  VectorXd coefficient(2 * slips), cohesion(2 * slips);
  coefficient << one.law.coefficient, two.law.coefficient;
  cohesion << one.law.cohesion, small * two.law.cohesion;
  both.law = law_of_all(coefficient, cohesion);
  return both;
}

CertifiedSolution end_of(const Data& data) {
  const QuadraticProgramme programme{data.K.sparseView(), data.p, data.A.sparseView(), data.g};
  const CholeskyFactor factor(data.K);
  const VectorXd free = factor.solve(data.p);
  const VectorXd moved = data.g - data.A * free;
  const Index slips = static_cast<Index>(data.law.pair.size());
  const Index pairs = data.g.size() - slips;
  const MatrixXd F = data.A * factor.solve_columns(data.A.transpose());
  const ContactProblem problem{0.5 * (F + F.transpose()), moved.head(pairs), moved.tail(slips),
                               data.law};
  Ledger ledger;
  return certified_solve(programme,
                         {problem, free, [&](const VectorXd& f) { return factor.solve(f); }}, {},
                         find_solver("primal_dual_active_set"), {}, ledger);
}

}  // namespace

TEST_CASE("a system beside one that is 1e20 times larger is solved to its own last digit",
          "[separate]") {
  for (const bool frictional : {false, true})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const Data one = one_system(seed, frictional);
      const Data two = one_system(seed + 100, frictional);
      const CertifiedSolution alone = end_of(two);
      for (const double small : {0x1p-20, 0x1p-43, 0x1p-66}) {
        CAPTURE(frictional, seed, small);
        const CertifiedSolution both = end_of(beside(one, two, small));
        REQUIRE(alone.state.report.status == SolveStatus::Solved);
        REQUIRE(both.state.report.status == SolveStatus::Solved);
        CHECK(both.certificate.worst() <= 1e-14);
        CHECK((both.state.force.tail(3) / small - alone.state.force).cwiseAbs().maxCoeff() <=
              1e-14 * alone.state.force.maxCoeff());
        CHECK(both.state.gap.size() == 6);
        const Index slips = alone.state.slip.size();
        for (Index k = 0; k < slips; ++k) {
          CHECK(both.state.frictional_pairs[static_cast<std::size_t>(slips + k)] == 3 + k);
          CHECK(both.state.contact_status[static_cast<std::size_t>(slips + k)] ==
                alone.state.contact_status[static_cast<std::size_t>(k)]);
        }
      }
    }
}

TEST_CASE("one system that nothing solves does not spoil the word on the other", "[separate]") {
  Data one = one_system(1, false);
  Data two = one_system(2, false);
  two.A.row(1) = -two.A.row(0);  // a gap that must close where another must open
  two.g(1) = -two.g(0) - 1;
  const CertifiedSolution both = end_of(beside(one, two, 1));
  CHECK(both.state.report.status == SolveStatus::Infeasible);
  REQUIRE(both.state.farkas_certificate.size() == 6);
  CHECK(both.state.farkas_certificate.head(3).isZero(0));
  CHECK(both.state.farkas_certificate(3) > 0);
  CHECK(end_of(beside(two, one, 1)).state.report.status == SolveStatus::Infeasible);
}
