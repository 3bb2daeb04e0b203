// What every certificate asks of pairs, by hand.
#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"

using Eigen::Vector2d;
using Eigen::Vector4d;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// Two frictional pairs with mu = 0.5: forces and movements of two gaps, then of two slips, measured by 10 and 4.
Certificate figures(const VectorXd& force, const VectorXd& movement, double cohesion = 0,
                    const VectorXd& unit = VectorXd::Ones(4)) {
  const FrictionLaw law = law_of_all(Vector2d(0.5, 0.5), Vector2d(cohesion, cohesion));
  return certify(ClaimResiduals{force, movement, unit, 10, 4}, law);
}

}  // namespace

TEST_CASE("overlap, tension and force across a gap, of the worst pair", "[certificate]") {
  const Certificate found = figures(Vector4d(-2, 5, 0, 0), Vector4d(-0.8, 0.2, 0, 0));
  CHECK(found.penetration == Approx(0.2));
  CHECK(found.tension == Approx(0.2));
  CHECK(found.complementarity == Approx(1.6 / 40));
  CHECK(found.cone == 0);
  CHECK(found.sliding == 0);
  CHECK(found.equilibrium == 0);
  CHECK(found.duality_gap == 0);
}

TEST_CASE("an equation has a gap and a force of any sign", "[certificate]") {
  const VectorXd force = Vector2d(-2, 3);
  const VectorXd movement = Vector2d(0.8, 0);
  const VectorXd unit = Vector2d(1, 1);
  const Certificate found = certify(ClaimResiduals{force, movement, unit, 10, 4}, {}, 1);
  CHECK(found.penetration == Approx(0.2));
  CHECK(found.tension == 0);
  CHECK(found.complementarity == Approx(0.04));
}

TEST_CASE("friction beyond its bound, and slips that nothing resists", "[certificate][friction]") {
  CHECK(figures(Vector4d(4, 6, 2, -3), Vector4d(0, 0, 0, 0)).worst() == 0);  // at the bound
  CHECK(figures(Vector4d(4, 6, 2, -3.5), Vector4d(0, 0, 0, 0)).cone == Approx(0.05));
  CHECK(figures(Vector4d(4, 6, -2, 3), Vector4d(0, 0, 1, -1)).worst() == 0);  // resisted
  const Certificate forward = figures(Vector4d(4, 6, -2, 3), Vector4d(0, 0, -0.1, 0));
  CHECK(forward.sliding ==
        Approx(0.1 / 4));  // along with its friction force: rather a slip too many
  CHECK(figures(Vector4d(4, 6, 1.9, 3), Vector4d(0, 0, -1, 0)).sliding == Approx(0.01));
}

TEST_CASE("cohesion holds a closed pair, not an open one", "[certificate][friction]") {
  CHECK(figures(Vector4d(4, 6, 5, 0), Vector4d(0, 0, 0, 0), 3).worst() == 0);
  CHECK(figures(Vector4d(0, 6, 3, 0), Vector4d(1, 0, 0, 0), 3).cone == Approx(0.25));    // its gap
  CHECK(figures(Vector4d(0, 6, 0.5, 0), Vector4d(1, 0, 0, 0), 3).cone == Approx(0.05));  // open
  // What presses is closed: it may not slide as if it were open, by the smaller of its force and what friction lacks.
  CHECK(figures(Vector4d(0.5, 6, 0, 0), Vector4d(0, 0, 4, 0), 3).cone == Approx(0.05));
  CHECK(figures(Vector4d(4, 6, 0, 0), Vector4d(0, 0, 0.4, 0), 3).sliding == Approx(0.1));
}

TEST_CASE("units of rows do not count", "[certificate][units]") {
  const Vector4d force(-2, 5, 1, -4);
  const Vector4d movement(-0.8, 0.2, 0.3, 0);
  const Vector4d unit(0.25, 2, 8, 0.5);
  const FrictionLaw law{{0, 1}, Vector2d(0.5 * 0.25 / 8, 0.5 * 2 / 0.5), Vector2d(1. / 8, 1 / 0.5)};
  const VectorXd other_force = force.cwiseQuotient(unit);
  const VectorXd other_movement = movement.cwiseProduct(unit);
  const VectorXd units = unit;
  const Certificate one = figures(force, movement, 1);
  const Certificate other = certify(ClaimResiduals{other_force, other_movement, units, 10, 4}, law);
  CHECK(other.penetration == one.penetration);
  CHECK(other.tension == one.tension);
  CHECK(other.complementarity == one.complementarity);
  CHECK(other.cone == Approx(one.cone));
  CHECK(other.sliding == Approx(one.sliding));
}
