#include <algorithm>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex6_2 {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd weights(const VectorXd& x, signorini::MeshOrder order, double thickness) {
  VectorXd weight = VectorXd::Zero(x.size());
  const Index step = order == signorini::MeshOrder::Linear ? 1 : 2;
  for (Index k = 0; k + step < x.size(); k += step) {
    const double h = thickness * (x(k + step) - x(k));
    if (step == 1)
      weight.segment<2>(k) += h * Eigen::Vector2d(0.5, 0.5);
    else
      weight.segment<3>(k) += h / 6 * Eigen::Vector3d(1, 4, 1);
  }
  return weight;
}

double touchdown(const VectorXd& x, const VectorXd& pressure) {
  Index first = 0;
  while (first < x.size() && pressure(first) <= 0) ++first;
  if (first == x.size()) return x(x.size() - 1);
  if (first == 0 || first == x.size() - 1) return x(first);
  const double here = pressure(first) * pressure(first);
  const double next = pressure(first + 1) * pressure(first + 1);
  if (next <= here) return x(first);
  const double zero = x(first) - here * (x(first + 1) - x(first)) / (next - here);
  return std::max(zero, x(first - 1));  // the open node before it is known to be free
}

}  // namespace

ContactLine contact_line(const VectorXd& position, const VectorXd& contact_force,
                         signorini::MeshOrder order, double thickness) {
  const Index n = position.size();
  signorini::require_argument(contact_force.size() == n, "contact_line: need ", n, " forces, got ",
                              contact_force.size());
  signorini::require_argument(n >= 2 && (order == signorini::MeshOrder::Linear || n % 2 == 1),
                              "contact_line: ", n, " nodes do not make complete edges");
  signorini::require_argument(
      (position.tail(n - 1) - position.head(n - 1)).minCoeff() > 0 && thickness > 0,
      "contact_line: positions must increase and the thickness be positive");
  const VectorXd pressure = contact_force.cwiseQuotient(weights(position, order, thickness));
  return {pressure, touchdown(position, pressure)};
}

}  // namespace ex6_2
