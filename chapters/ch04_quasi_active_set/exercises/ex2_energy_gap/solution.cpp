#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace ex4_2 {

End last_step(const signorini::DenseProgramme& programme, const Balanced& from,
              const Balanced& towards) {
  const auto& [K, p, A, g, equations] = programme;
  const Eigen::VectorXd gap = g - A * from.displacement;
  const Eigen::VectorXd target = g - A * towards.displacement;
  End end;
  end.fraction = 1;
  for (Eigen::Index i = 0; i < g.size(); ++i)
    if (target(i) < -1e-13 * (1 + std::abs(g(i))))
      end.fraction = std::min(end.fraction, gap(i) / (gap(i) - target(i)));
  end.fraction = std::max(0.0, end.fraction);
  Eigen::VectorXd& u = end.state.displacement;
  u = from.displacement + end.fraction * (towards.displacement - from.displacement);
  end.state.force = from.force + end.fraction * (towards.force - from.force);
  end.energy = 0.5 * u.dot(K * u) - p.dot(u);
  end.energy_gap = end.state.force.dot(g - A * u);
  end.optimal = end.energy_gap <= 1e-12 * (1 + std::abs(end.energy));
  return end;
}

}  // namespace ex4_2
