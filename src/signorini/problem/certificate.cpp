// # The certificate
//
// Whoever found a solution, its numbers are judged here, and by nothing but the original data. Each
// condition of contact has a figure: overlap, tension, the product of force and gap, equilibrium,
// the gap between primal and dual energy, and two for friction. Each figure is divided by a length,
// a force or an energy of the problem itself, so 0 is perfect and 1 is nonsense.
//
// A spring of stiffness 1 is loaded with p = 3 towards a wall at the distance 1. The solution is
// \f$ u = 1 \f$, \f$ \lambda = 2 \f$. Somebody claims a force that is too large by 1e-10, and
// displacements that may or may not follow it:
//
// | figure | u = 1 | u = 1 - 1e-10 |
// |---|---|---|
// | gap 1 - u | 0 | 1e-10 |
// | complementarity, over length 1 times force 3 | 0 | 6.7e-11 |
// | equilibrium \f$ \lvert p - u - \lambda\rvert \f$, over 3 | 3.3e-11 | 0 |
// | energy gap, over \f$ \lambda g + pu = 5 \f$ | 2e-11 | 4e-11 |
//
// Either way a figure exceeds the tolerance 1e-12, and the claim is refused.

#include "signorini/problem/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include "signorini/core/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

// All figures in one list, so that none is forgotten where they are compared.
constexpr double Certificate::*all_figures[] = {
    &Certificate::penetration, &Certificate::tension,     &Certificate::complementarity,
    &Certificate::equilibrium, &Certificate::duality_gap, &Certificate::cone,
    &Certificate::sliding,     &Certificate::balance};

void raise(double& figure, double value) { figure = std::max(figure, value); }

// Weak duality: the dual energy of forces that press is a lower bound for the energy of every
// displacement without overlap. The two meet at the solution only. Their difference is
// \f$ \sum f_i w_i \f$ if equilibrium holds, less the work of what is out of balance. Computed as
// the difference of two energies it would lose most of its digits. With friction no energy is
// least. In a programme the friction forces then count as given loads, and a condensed problem has
// no such figure.
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

// The two figures of a frictional pair.
struct Violation {
  double cone;
  double sliding;
  [[nodiscard]] double worst() const { return std::max(cone, sliding); }
};

// Coulomb's law in two figures. `cone`: the friction force does not exceed its bound. `sliding`:
// the pair has no slip, or the friction force resists the slip with the whole bound. With the force
// 4 and the coefficient 0.5, a slip of 3 against the friction force -2 is right. Against -1 the
// force lacks 1, a quarter of the force 4.
//
// Cohesion belongs to closed pairs only, and rounding leaves no pair exactly closed. So the pair is
// judged twice, as open and as closed, and the better verdict counts. As open, its force is an
// error. As closed, its gap is one.
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

// The three conditions of a gap, then the law of friction. An equation holds in both directions:
// any gap is an error, and any force is right.
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

// What is not finite cannot be measured. Infinity exceeds every tolerance.
Certificate uncertified() {
  Certificate nothing;
  for (const auto figure : all_figures) nothing.*figure = std::numeric_limits<double>::infinity();
  return nothing;
}

// Comparisons with NaN are false. Without the second condition a NaN would be lost, and a claim
// without meaning could pass.
Certificate worst_of(Certificate one, const Certificate& other) {
  for (const auto figure : all_figures)
    if (other.*figure > one.*figure || std::isnan(other.*figure)) one.*figure = other.*figure;
  return one;
}

// The same care for NaN.
double Certificate::worst() const {
  double most = 0;
  for (const auto figure : all_figures) {
    if (std::isnan(this->*figure)) return std::numeric_limits<double>::infinity();
    raise(most, this->*figure);
  }
  return most;
}

// The figures of friction and of bodies are printed only if they are not 0.
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
