#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

using Eigen::Index;
using namespace signorini;

TEST_CASE("a Rosen-Suzuki programme satisfies the conditions at its solution", "[examples]") {
  const double epsilon = std::numeric_limits<double>::epsilon();
  for (const Index n : {1, 10, 20})
    for (const Index m : {1, 5, 40})
      for (const std::uint64_t seed : {1, 2, 3}) {
        CAPTURE(n, m, seed);
        const KnownProgramme known = rosen_suzuki(n, m, seed);
        const DenseProgramme& programme = known.programme;
        const Eigen::VectorXd u = known.displacement;
        const Eigen::VectorXd gap = programme.initial_gap - programme.A * u;
        const Eigen::VectorXd left =
            programme.load - programme.stiffness * u - programme.A.transpose() * known.force;
        // p and g are sums of at most n + m products of the size of the largest entry of K u.
        const double rounding =
            epsilon * static_cast<double>(n + m) * (1 + programme.load.cwiseAbs().maxCoeff());
        CHECK(left.cwiseAbs().maxCoeff() <= rounding);
        Index closed = 0;
        for (Index i = 0; i < m; ++i) {
          closed += known.force(i) > 0 ? 1 : 0;
          if (known.force(i) > 0) {
            CHECK(known.force(i) >= 0.5);
            CHECK(std::abs(gap(i)) <= rounding);
          } else {
            CHECK(gap(i) >= 0.1 - rounding);
          }
        }
        CHECK(closed == std::min(n, m) / 2);
        CHECK(known.energy == Approx(0.5 * u.dot(programme.stiffness * u) - programme.load.dot(u))
                                  .epsilon(1e-13)
                                  .margin(1e-13));
      }
}

TEST_CASE("a seed names one Rosen-Suzuki programme", "[examples]") {
  CHECK(rosen_suzuki(4, 6, 7).programme.stiffness == rosen_suzuki(4, 6, 7).programme.stiffness);
  CHECK(rosen_suzuki(4, 6, 7).programme.stiffness != rosen_suzuki(4, 6, 8).programme.stiffness);
  CHECK_THROWS_AS(rosen_suzuki(0, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(rosen_suzuki(1, 0, 1), std::invalid_argument);
}

TEST_CASE("the half-plane is symmetric and positive definite", "[examples]") {
  for (const Index n : {1, 2, 9, 80}) {
    CAPTURE(n);
    const Eigen::MatrixXd G = half_plane_indentation(n).problem.compliance;
    CHECK(G == G.transpose());
    const Eigen::VectorXd value = symmetric_eigenvalues(G);
    CHECK(value(0) > 0);
    CHECK(value(n - 1) / value(0) < 10 * static_cast<double>(n));
  }
}

TEST_CASE("Hertz's forces leave no gap under the parabola and one beside it",
          "[examples][closed-form]") {
  // The exact pressure is constant in no element, so gaps are of the order h^(3/2) at the end of contact.
  for (const Index n : {50, 200, 800}) {
    const Indentation hertz = half_plane_indentation(n);
    const Eigen::VectorXd gap = hertz.problem.compliance * hertz.force + hertz.problem.free_gap;
    const double h = 2.0 / static_cast<double>(n);
    CAPTURE(n);
    CHECK(hertz.force.sum() == Approx(hertz.total_force).epsilon(1e-13));
    for (Index i = 0; i < n; ++i) {
      const double x = std::abs(hertz.position(i));
      if (x < hertz.half_width) CHECK(std::abs(gap(i)) < 0.1 * std::pow(h, 1.5));
      if (x > hertz.half_width + h) CHECK(gap(i) > 0);
    }
  }
}

TEST_CASE("the solution tends to Hertz's half-width and force", "[examples][closed-form]") {
  for (const Index n : {51, 200}) {
    const Indentation hertz = half_plane_indentation(n);
    const ContactState state = primal_dual_active_set(hertz.problem);
    REQUIRE(state.report.status == SolveStatus::Solved);
    const double h = 2.0 / static_cast<double>(n);
    CAPTURE(n);
    CHECK(std::abs(state.force.sum() / hertz.total_force - 1) < h * h);
    CHECK(std::abs(h / 2 * static_cast<double>(state.active().size()) - hertz.half_width) <= h);
    CHECK((state.force - hertz.force).cwiseAbs().maxCoeff() < h * hertz.force.maxCoeff());
  }
}

TEST_CASE("a flat punch touches everywhere and carries the force 1", "[examples][closed-form]") {
  for (const Index n : {10, 100}) {
    const Indentation flat = half_plane_indentation(n, Punch::Flat);
    const ContactState state = primal_dual_active_set(flat.problem);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CAPTURE(n);
    CHECK(static_cast<Index>(state.active().size()) == n);
    CHECK(state.force.sum() == Approx(1).epsilon(1.0 / static_cast<double>(n)));
    const Index middle = n / 2;
    CHECK(state.force(middle) == Approx(flat.force(middle)).epsilon(1.0 / static_cast<double>(n)));
  }
  CHECK_THROWS_AS(half_plane_indentation(0), std::invalid_argument);
}

TEST_CASE("a programme of whole numbers satisfies the conditions exactly", "[examples]") {
  for (const Index n : {1, 10, 20})
    for (const Index m : {1, 5, 40})
      for (const std::uint64_t seed : {1, 2, 3}) {
        CAPTURE(n, m, seed);
        const KnownProgramme known = whole_number_programme(n, m, seed);
        const DenseProgramme& programme = known.programme;
        const Eigen::VectorXd u = known.displacement;
        const Eigen::VectorXd gap = programme.initial_gap - programme.A * u;
        CHECK(programme.load == programme.stiffness * u + programme.A.transpose() * known.force);
        CHECK(gap.minCoeff() >= 0);
        CHECK(known.force.minCoeff() >= 0);
        CHECK(gap.dot(known.force) == 0);
        const Index closed = (gap.array() == 0).count();
        CHECK((closed >= 1 && closed <= std::min(n, m)));
        CHECK(closed == (known.force.array() > 0).count());
        CHECK(programme.A.cwiseAbs().rowwise().maxCoeff().minCoeff() >= 1);  // no row is empty
        CHECK(programme.A == programme.A.array().round().matrix());
        CHECK(symmetric_eigenvalues(programme.stiffness)(0) > 0.99);
        CHECK(known.energy == 0.5 * u.dot(programme.stiffness * u) - programme.load.dot(u));
      }
  CHECK(whole_number_programme(4, 6, 7).programme.A == whole_number_programme(4, 6, 7).programme.A);
  CHECK(whole_number_programme(4, 6, 7).programme.A != whole_number_programme(4, 6, 8).programme.A);
  CHECK_THROWS_AS(whole_number_programme(0, 1, 1), std::invalid_argument);
}
