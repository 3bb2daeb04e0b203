#include <Eigen/LU>

#include "../chapters/ch15_friction_remembers/wedge.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex15_4::all_answers;
using ex15_4::Answer;
using ex15_4::Pair;
using signorini::ContactStatus;

// The node of the chapter: stiffness (1, -0.6; -0.6, 1), pressed with 0.2, pushed along.
static Pair node(double coefficient, double push) {
  const Eigen::Matrix2d F = (Eigen::Matrix2d() << 1, -0.6, -0.6, 1).finished().inverse();
  const Eigen::Vector2d free = F * Eigen::Vector2d(-0.2, push);
  return {F, free(0), free(1), coefficient, 0};
}

TEST_CASE("ex15.4 one pair has one answer without coupling", "[ex15.4]") {
  const Eigen::Matrix2d F = Eigen::Vector2d(2, 4).asDiagonal();
  const auto only = [&F](double gap, double slip) {
    const std::vector<Answer> found = all_answers({F, gap, slip, 0.5, 0});
    REQUIRE(found.size() == 1);
    return found[0];
  };
  CHECK(only(1, 8).contact_status == ContactStatus::Open);
  CHECK(only(-6, -4).contact_status == ContactStatus::Stick);
  CHECK(only(-6, -4).force == Approx(3).epsilon(1e-14));
  CHECK(only(-6, -4).friction == Approx(1).epsilon(1e-14));
  CHECK(only(-6, 8).contact_status == ContactStatus::SlipForward);
  CHECK(only(-6, 8).friction == Approx(-1.5).epsilon(1e-14));
  CHECK(only(-6, -8).contact_status == ContactStatus::SlipBackward);
  CHECK(only(-6, -8).friction == Approx(1.5).epsilon(1e-14));
}

TEST_CASE("ex15.4 the node of the chapter: one answer below mu = 5/3, three above", "[ex15.4]") {
  for (const double mu : {0.2, 1.0, 1.6, 1.7, 3.0})
    for (const double push : {-0.5, 0.1, 0.32, 0.335, 0.5, 0.7}) {
      CAPTURE(mu, push);
      const std::vector<Answer> found = all_answers(node(mu, push));
      const bool several = mu * 0.6 > 1 && push > 1. / 3 && push < 0.2 * mu;
      CHECK(found.size() == (several ? 3 : 1));
      const auto known = ch15::answers(mu, push);
      REQUIRE(found.size() == known.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        CHECK(found[k].contact_status == known[k].contact_status);
        CHECK(found[k].force == Approx(known[k].force).margin(1e-12));
        CHECK(found[k].friction == Approx(known[k].friction).margin(1e-12));
      }
    }
}

TEST_CASE("ex15.4 cohesion adds to the bound of a closed pair", "[ex15.4]") {
  const Eigen::Matrix2d F = Eigen::Vector2d(2, 4).asDiagonal();
  const std::vector<Answer> stuck = all_answers({F, -6, 7, 0, 2});  // would slide without it
  REQUIRE(stuck.size() == 1);
  CHECK(stuck[0].contact_status == ContactStatus::Stick);
  // Gap -4 + 2 lambda + tau = 0 with tau = -(lambda / 2 + 1).
  const std::vector<Answer> slides =
      all_answers({(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), -4, 10, 0.5, 1});
  REQUIRE(slides.size() == 1);
  CHECK(slides[0].contact_status == ContactStatus::SlipForward);
  CHECK(slides[0].force == Approx(10.0 / 3).epsilon(1e-14));
  CHECK(slides[0].friction == Approx(-8.0 / 3).epsilon(1e-14));
}
