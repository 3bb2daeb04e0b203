#include "signorini/closing/known_set.hpp"

#include <optional>

#include "signorini/closing/bordered_system.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ScaledFloating scaled_rows(const MatrixXd& compliance, const MatrixXd& rigid) {
  return equilibrate(FloatingProblem{
      {compliance, VectorXd::Zero(compliance.rows())}, rigid, VectorXd::Zero(rigid.cols())});
}

/// The system with friction forces that follow normal ones: not symmetric.
MatrixXd sliding_system(const ScaledFloating& scaled, const KnownSet& set) {
  const Index m = static_cast<Index>(set.closed.size());
  const Index k = scaled.span.cols();
  MatrixXd M = MatrixXd::Zero(m + k, m + k);
  M.topLeftCorner(m, m) = scaled.contact.compliance(set.closed, set.closed);
  M.topRightCorner(m, k) = scaled.span(set.closed, Eigen::all);
  M.bottomLeftCorner(k, m) = M.topRightCorner(m, k).transpose();
  const VectorXd& scale = scaled.contact.scale;
  std::size_t column = 0;
  for (const SlidingPair& pair : set.sliding) {
    while (set.closed[column] != pair.gap) ++column;
    const double slope = pair.slope * scale(pair.gap) / scale(pair.slip);
    M.col(static_cast<Index>(column)).head(m) +=
        slope * scaled.contact.compliance(set.closed, pair.slip);
    M.col(static_cast<Index>(column)).tail(k) += slope * scaled.span.row(pair.slip).transpose();
  }
  return M;
}

bool symmetric(const KnownSet& set) {
  for (const SlidingPair& pair : set.sliding)
    if (pair.slope != 0) return false;
  return true;
}

}  // namespace

KnownSet known_set(const std::vector<Motion>& motions, const FrictionLaw& law) {
  const Index pairs = static_cast<Index>(motions.size());
  KnownSet set;
  for (Index i = 0; i < pairs; ++i)
    if (motions[static_cast<std::size_t>(i)] != Motion::Open) set.closed.push_back(i);
  for (std::size_t k = 0; k < law.pair.size(); ++k) {
    const Motion motion = motions[static_cast<std::size_t>(law.pair[k])];
    const Index row = static_cast<Index>(k);
    const double sign = friction_sign(motion);
    const bool rubs = law.coefficient(row) > 0 || law.cohesion(row) > 0;
    if (motion == Motion::Stick && rubs) set.closed.push_back(pairs + row);
    if (sign != 0 && rubs)
      set.sliding.push_back(
          {law.pair[k], pairs + row, sign * law.coefficient(row), sign * law.cohesion(row)});
  }
  return set;
}

struct Closing::System {
  ScaledFloating scaled;
  std::vector<Index> rows;
  std::optional<BorderedSystem> bordered;  // of a symmetric system
  LuFactor factor;                         // of one with sliding pairs
  MatrixXd inverse;                        // its pseudo-inverse where that is singular
};

Closing::Closing(const MatrixXd& compliance, const MatrixXd& rigid, const KnownSet& set) {
  const auto made = std::make_shared<System>();
  System& system = *made;
  system_ = made;
  system.scaled = scaled_rows(compliance, rigid);
  if (symmetric(set)) {
    system.bordered.emplace(system.scaled, set.closed);
    system.rows = system.bordered->pairs();
    return;
  }
  system.rows = set.closed;
  const MatrixXd M = sliding_system(system.scaled, set);
  system.factor = LuFactor(M);
  const bool regular = system.factor.rcond() > static_cast<double>(M.rows() + 1) * epsilon;
  if (!regular) system.inverse = pseudo_inverse(M);
}

const std::vector<Index>& Closing::rows() const { return system_->rows; }

std::pair<VectorXd, VectorXd> Closing::solve(const VectorXd& movement,
                                             const VectorXd& resultant) const {
  const System& system = *system_;
  const VectorXd scale = system.scaled.contact.scale(system.rows);
  const VectorXd top = -scale.cwiseProduct(movement(system.rows));
  const VectorXd& unit = system.scaled.amplitude_scale;
  const VectorXd bottom = unit.cwiseProduct(resultant);
  if (system.bordered) {
    const auto [force, amplitude] = system.bordered->solve(top, bottom);
    return {scale.cwiseProduct(force), unit.cwiseProduct(amplitude)};
  }
  const Index m = top.size();
  const MatrixXd& inverse = system.scaled.inverse;
  VectorXd right(m + inverse.cols());
  right << top, inverse.transpose() * bottom;
  const VectorXd both =
      system.inverse.size() > 0 ? VectorXd(system.inverse * right) : system.factor.solve(right);
  return {scale.cwiseProduct(both.head(m)), unit.cwiseProduct(inverse * both.tail(inverse.cols()))};
}

}  // namespace signorini
