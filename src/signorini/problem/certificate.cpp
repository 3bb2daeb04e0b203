#include "signorini/problem/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double Certificate::*all_figures[] = {
    &Certificate::penetration, &Certificate::tension,     &Certificate::complementarity,
    &Certificate::equilibrium, &Certificate::duality_gap, &Certificate::cone,
    &Certificate::sliding,     &Certificate::balance};

void raise(double& figure, double value) { figure = std::max(figure, value); }

double duality_gap(const ClaimResiduals& left, Index pairs) {
  if (left.free.size() == 0) return 0;
  ExactSum energy;
  double energies = 0;
  for (Index i = 0; i < pairs; ++i) {
    energy.add_product(left.force(i), left.movement(i));
    energies += std::abs(left.force(i) * left.free(i));
  }
  for (Index j = 0; j < left.position.size(); ++j) {
    energy.add_product(-left.imbalance(j), left.position(j));
    energies += std::abs(left.load(j) * left.position(j));
  }
  return ratio(std::abs(energy.value()), std::max(energies, left.length * left.force_size));
}

/// How far a frictional pair is from the law.
struct Violation {
  double cone;
  double sliding;
  [[nodiscard]] double worst() const { return std::max(cone, sliding); }
};

/// The smaller violation of the two that pair k has as an open and as a closed one.
/// \param force, movement  scaled, of all rows
/// \param bound, cohesion  scaled mu lambda+ and c
Violation violation(const ClaimResiduals& left, Index pair, Index slip, const VectorXd& force,
                    const VectorXd& movement, double bound, double cohesion) {
  const auto with = [&](double most, double status) {
    const double beyond = std::max(0.0, std::abs(force(slip)) - most);
    const double unresisted = std::abs(std::copysign(most, movement(slip)) + force(slip));
    return Violation{
        std::max(ratio(beyond, left.force_size), status),
        std::min(ratio(std::abs(movement(slip)), left.length), ratio(unresisted, left.force_size))};
  };
  const double pressed = cohesion > 0 ? std::max(0.0, force(pair)) : 0;
  const Violation open = with(bound, ratio(pressed, left.force_size));
  const Violation closed =
      with(bound + cohesion, ratio(std::max(0.0, movement(pair)), left.length));
  return closed.worst() < open.worst() ? closed : open;
}

}  // namespace

Certificate certify(const ClaimResiduals& left, const FrictionLaw& law, Index equations) {
  const VectorXd force = left.force.cwiseProduct(left.unit);
  const VectorXd movement = left.movement.cwiseQuotient(left.unit);
  const Index pairs = movement.size() - static_cast<Index>(law.pair.size());
  Certificate certificate;
  certificate.equilibrium = left.equilibrium;
  certificate.duality_gap = duality_gap(left, pairs);
  for (Index i = 0; i < pairs; ++i) {
    const double gap = i < equations ? -std::abs(movement(i)) : movement(i);
    const double push = i < equations ? std::abs(force(i)) : force(i);
    raise(certificate.penetration, ratio(std::max(0.0, -gap), left.length));
    raise(certificate.tension, ratio(std::max(0.0, -push), left.force_size));
    raise(certificate.complementarity, ratio(std::abs(gap * push), left.length * left.force_size));
  }
  for (Index k = 0; pairs + k < movement.size(); ++k) {
    const Index slip = pairs + k;
    const Index i = law.pair[static_cast<std::size_t>(k)];
    const double bound = law.coefficient(k) * std::max(0.0, left.force(i)) * left.unit(slip);
    const Violation found =
        violation(left, i, slip, force, movement, bound, law.cohesion(k) * left.unit(slip));
    raise(certificate.cone, found.cone);
    raise(certificate.sliding, found.sliding);
  }
  return certificate;
}

Certificate uncertified() {
  Certificate nothing;
  for (const auto figure : all_figures) nothing.*figure = std::numeric_limits<double>::infinity();
  return nothing;
}

Certificate worst_of(Certificate one, const Certificate& other) {
  for (const auto figure : all_figures)
    if (other.*figure > one.*figure || std::isnan(other.*figure)) one.*figure = other.*figure;
  return one;
}

double Certificate::worst() const {
  double most = 0;
  for (const auto figure : all_figures) {
    if (std::isnan(this->*figure)) return std::numeric_limits<double>::infinity();
    raise(most, this->*figure);
  }
  return most;
}

std::ostream& operator<<(std::ostream& out, const Certificate& certificate) {
  std::ostringstream line;
  line << std::scientific << std::setprecision(1) << "penetration " << certificate.penetration
       << ", tension " << certificate.tension << ", complementarity " << certificate.complementarity
       << ", equilibrium " << certificate.equilibrium << ", duality gap "
       << certificate.duality_gap;
  if (certificate.cone > 0 || certificate.sliding > 0)
    line << ", cone " << certificate.cone << ", sliding " << certificate.sliding;
  if (certificate.balance > 0) line << ", balance " << certificate.balance;
  return out << line.str();
}

}  // namespace signorini
