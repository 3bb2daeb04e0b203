#include <stdexcept>

#include "exercise.hpp"

namespace ex19_2 {

Term nitsche_term(const Point& at, const Eigen::VectorXd& u, double gamma, double theta) {
  if (!(gamma > 0) || !(at.weight > 0) || at.pressure.size() != u.size() ||
      at.opening.size() != u.size())
    throw std::invalid_argument(
        "nitsche_term: gamma and weight must be positive, rows of one length");
  const double q = at.pressure.dot(u);
  const double pressing = q - gamma * (at.free_gap + at.opening.dot(u));
  const Eigen::VectorXd test = theta * at.pressure - gamma * at.opening;
  const double amount = at.weight / gamma;
  Term term{-amount * theta * q * at.pressure,
            -amount * theta * at.pressure * at.pressure.transpose()};
  if (pressing > 0) {
    term.force += amount * pressing * test;
    term.slope += amount * test * (at.pressure - gamma * at.opening).transpose();
  }
  return term;
}

}  // namespace ex19_2
