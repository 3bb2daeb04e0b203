#include <Eigen/LU>
#include <cmath>

#include "exercise.hpp"

namespace ex15_4 {

using signorini::ContactStatus;

std::vector<Answer> all_answers(const Pair& pair) {
  const Eigen::Matrix2d& F = pair.compliance;
  const double mu = pair.coefficient, c = pair.cohesion;
  std::vector<Answer> found;
  if (pair.free_gap >= 0) found.push_back({ContactStatus::Open, 0, 0});
  const Eigen::Vector2d stuck = -F.inverse() * Eigen::Vector2d(pair.free_gap, pair.free_slip);
  if (stuck(0) >= 0 && std::abs(stuck(1)) <= mu * stuck(0) + c)
    found.push_back({ContactStatus::Stick, stuck(0), stuck(1)});
  for (const ContactStatus contact_status :
       {ContactStatus::SlipForward, ContactStatus::SlipBackward}) {
    const double sign = signorini::friction_sign(contact_status);  // of the friction force
    const double stiffness = F(0, 0) + sign * mu * F(0, 1);
    if (stiffness == 0) continue;
    const double force = -(pair.free_gap + sign * c * F(0, 1)) / stiffness;
    const double friction = sign * (mu * force + c);
    const double slip = pair.free_slip + F(1, 0) * force + F(1, 1) * friction;
    if (force >= 0 && sign * slip < 0) found.push_back({contact_status, force, friction});
  }
  return found;
}

}  // namespace ex15_4
